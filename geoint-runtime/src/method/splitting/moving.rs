//! A point while flows move it, and how kicks, drifts and rotations do.

use super::kicks::{Coordinates, Kicks};
use crate::scalar::Real;
use crate::space::{Action, Array, PerCoordinate, Plain, Point, Summation, add_action};
use crate::system::{Cotangent, PrincipalAxes, Separable};

/// The times of a flow: the one that flows of its own kind have reached, and the one that the others have reached.
#[derive(Clone, Copy, Debug)]
pub struct Times<R> {
    pub(crate) own: R,
    pub(crate) other: R,
}

/// A point of a system while flows move it. Its parts are apart, so that a loop may hold each of them in registers.
#[derive(Debug)]
pub struct Moving<'a, S: Cotangent<R>, R: Real, C> {
    pub(crate) system: &'a S,
    pub(crate) q: &'a mut S::Array,
    pub(crate) p: &'a mut S::Array,
    pub(crate) s: &'a mut S::Action,
    pub(crate) sums: &'a mut C,
    /// Of the sum s.
    pub(crate) compensation: &'a mut S::Action,
}

impl<'a, S: Cotangent<R>, R: Real, C> Moving<'a, S, R, C> {
    /// A point in parts.
    #[inline(always)]
    pub(super) fn of(system: &'a S, x: &'a mut Point<S::Phase, C, S::Action>) -> Self {
        let [q, p] = &mut x.z;
        Moving { system, q, p, s: &mut x.s, sums: &mut x.sums, compensation: &mut x.compensation }
    }

    /// The same point, for a flow before another.
    #[inline(always)]
    pub(super) fn again(&mut self) -> Moving<'_, S, R, C> {
        let Moving { system, q, p, s, sums, compensation } = self;
        Moving { system, q, p, s, sums, compensation }
    }
}

impl<S: Separable<R>, R: Real, C: Summation<S::Phase>> Moving<'_, S, R, C> {
    /// p ← p − h ∂V/∂q, at the time that the drifts have reached.
    ///
    /// Plain sums are left to the kernel: called from a closure, it is no longer seen that q and p are apart, which costs a
    /// tenth on six bodies.
    #[inline(always)]
    pub fn kick<F: Kicks<S, R>>(self, flow: &F::Kick, at: Times<R>) {
        if C::PLAIN {
            let Moving { system, q, p, s, .. } = self;
            let mut unread = *s;
            F::kick(system, flow, at.other, q, p, if C::ACTION { s } else { &mut unread });
        } else if S::Action::LEN == 0 && S::KICKS_ADD {
            let Moving { system, q, p, s, sums, .. } = self;
            sums.add_part(S::Array::LEN, p, |p| F::kick(system, flow, at.other, q, p, s));
        } else {
            let d = F::increments(self.system, flow, at.other, &self.coordinates());
            self.add(&d);
        }
    }

    /// A kick that does nothing but add to the momenta, and what it adds.
    #[inline(always)]
    pub(super) fn told(self, kick: impl FnOnce(Moving<'_, S, R, Plain>)) -> S::Array {
        let Moving { system, q, p, s, sums, compensation } = self;
        // Acting on zero, the flow gives the increment.
        let mut impulse = S::Array::nothing();
        kick(Moving { system, q, p: &mut impulse, s, sums: &mut Plain, compensation });
        sums.add_part(S::Array::LEN, p, |p| p.add_scaled(R::from_f64(1.0), &impulse));
        impulse
    }

    /// What a kick that does nothing but add to the momenta would add.
    #[inline(always)]
    pub(super) fn impulse<F: Kicks<S, R>>(self, kick: &F::Kick, at: Times<R>) -> S::Array {
        let mut impulse = S::Array::nothing();
        F::kick(self.system, kick, at.other, self.q, &mut impulse, self.s);
        impulse
    }

    /// A linear drift after momenta have grown by `dp`.
    #[inline(always)]
    pub(super) fn drift_after(self, flow: &S::Drift, at: Times<R>, dp: &S::Array) {
        let Moving { system, q, p, s, .. } = self;
        system.drift_after(flow, at.own, [q, p], s, dp);
    }

    /// q ← q + h ∂T/∂p, at the time that the kicks have reached; or from the time that the drifts have reached, if the drift is
    /// exact in time.
    #[inline(always)]
    pub fn drift(self, flow: &S::Drift, at: Times<R>) {
        let t = if S::DRIFTS_ARE_EXACT_IN_TIME { at.own } else { at.other };
        if C::PLAIN {
            let Moving { system, q, p, s, .. } = self;
            let mut unread = *s;
            system.drift(flow, t, q, p, if C::ACTION { s } else { &mut unread });
        } else if S::Action::LEN == 0 && S::DRIFTS_SHIFT {
            let Moving { system, q, p, s, sums, .. } = self;
            sums.add_part(0, q, |q| system.drift(flow, t, q, p, s));
        } else {
            let d = self.system.drift_increments(flow, t, &self.coordinates());
            self.add(&d);
        }
    }

    /// Rotations of rigid bodies about their axes, in place of a drift.
    #[inline(always)]
    pub(super) fn rotate(self, flow: &S::Drift)
    where
        S: PrincipalAxes<R>,
    {
        if C::PLAIN {
            return self.system.rotate(flow, self.q, self.p);
        }
        // A rotation is no sum: what it adds is the difference.
        let mut d = self.coordinates();
        let [q, p] = &mut d.z;
        self.system.rotate(flow, q, p);
        q.add_scaled(R::from_f64(-1.0), self.q);
        p.add_scaled(R::from_f64(-1.0), self.p);
        self.add(&d);
    }

    #[inline(always)]
    fn coordinates(&self) -> Coordinates<S, R> {
        PerCoordinate { z: [*self.q, *self.p], s: *self.s }
    }

    #[inline(always)]
    fn add(self, d: &Coordinates<S, R>) {
        let one = R::from_f64(1.0);
        self.sums.add_part(0, self.q, |q| q.add_scaled(one, &d.z[0]));
        self.sums.add_part(S::Array::LEN, self.p, |p| p.add_scaled(one, &d.z[1]));
        add_action::<S::Phase, C, S::Action>(self.s, self.compensation, d.s);
    }
}

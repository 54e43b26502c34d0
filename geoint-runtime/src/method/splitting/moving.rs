//! The point that flows move, and the application of kicks, drifts and rotations to it.

use super::kicks::{Coordinates, Kicks};
use crate::scalar::Real;
use crate::space::{Action, Array, PerCoordinate, Plain, Point, Summation, add_action};
use crate::system::{Cotangent, PrincipalAxes, Separable};

/// The two clocks at the start of a flow.
#[derive(Clone, Copy, Debug)]
pub struct Times<R> {
    /// The time that flows of the same kind have reached.
    pub(crate) own: R,
    /// The time that flows of the other kind have reached.
    pub(crate) other: R,
}

/// A point that flows move, as separate references, so that a loop may keep each part in registers.
#[derive(Debug)]
pub struct Moving<'a, S: Cotangent<R>, R: Real, C> {
    pub(crate) system: &'a S,
    pub(crate) q: &'a mut S::Array,
    pub(crate) p: &'a mut S::Array,
    pub(crate) s: &'a mut S::Action,
    pub(crate) sums: &'a mut C,
    /// The compensation of the sum s.
    pub(crate) compensation: &'a mut S::Action,
}

impl<'a, S: Cotangent<R>, R: Real, C> Moving<'a, S, R, C> {
    /// Returns references to the parts of `x`.
    #[inline(always)]
    pub(super) fn of(system: &'a S, x: &'a mut Point<S::Phase, C, S::Action>) -> Self {
        let [q, p] = &mut x.z;
        Moving { system, q, p, s: &mut x.s, sums: &mut x.sums, compensation: &mut x.compensation }
    }

    /// Reborrows the point for one of several flows.
    #[inline(always)]
    pub(super) fn again(&mut self) -> Moving<'_, S, R, C> {
        let Moving { system, q, p, s, sums, compensation } = self;
        Moving { system, q, p, s, sums, compensation }
    }
}

impl<S: Separable<R>, R: Real, C: Summation<S::Phase>> Moving<'_, S, R, C> {
    /// Applies a kick, p ← p − h ∂V/∂q, at the time that the drifts have reached.
    ///
    /// For plain sums the kernel is called directly. In a closure the optimiser would not know that q and p do not alias.
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

    /// Applies a kick that only adds to the momenta. Returns its impulse.
    #[inline(always)]
    pub(super) fn kick_and_report(self, kick: impl FnOnce(Moving<'_, S, R, Plain>)) -> S::Array {
        let Moving { system, q, p, s, sums, compensation } = self;
        // Applied to zero momenta, the kick returns its impulse.
        let mut impulse = S::Array::nothing();
        kick(Moving { system, q, p: &mut impulse, s, sums: &mut Plain, compensation });
        sums.add_part(S::Array::LEN, p, |p| p.add_scaled(R::from_f64(1.0), &impulse));
        impulse
    }

    /// Computes the impulse of a kick that only adds to the momenta, without applying it.
    #[inline(always)]
    pub(super) fn impulse<F: Kicks<S, R>>(self, kick: &F::Kick, at: Times<R>) -> S::Array {
        let mut impulse = S::Array::nothing();
        F::kick(self.system, kick, at.other, self.q, &mut impulse, self.s);
        impulse
    }

    /// Adds `dp` to the momenta and applies a linear drift.
    #[inline(always)]
    pub(super) fn drift_after(self, flow: &S::Drift, at: Times<R>, dp: &S::Array) {
        let Moving { system, q, p, s, .. } = self;
        system.drift_after(flow, at.own, [q, p], s, dp);
    }

    /// Applies a drift, q ← q + h ∂T/∂p, at the time that the kicks have reached. A drift that is exact in time starts at the time that the drifts have
    /// reached.
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

    /// Rotates rigid bodies about their principal axes, in place of a drift.
    #[inline(always)]
    pub(super) fn rotate(self, flow: &S::Drift)
    where
        S: PrincipalAxes<R>,
    {
        if C::PLAIN {
            return self.system.rotate(flow, self.q, self.p);
        }
        // A rotation does not add an increment. The compensated sums get the difference of its end and start.
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

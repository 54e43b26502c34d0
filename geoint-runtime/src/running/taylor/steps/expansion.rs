//! Coefficients of a solution at a point, and the states between it and the end of the step that they give.

use super::Steps;
use crate::scalar::{Real, zero};
use crate::space::{PerCoordinate, Snapshot};
use crate::system::{Jets, StateOf};
use crate::taylor::{self, TaylorMethod};

/// The coefficients at a point.
#[derive(Clone, Copy, Debug)]
pub(in crate::running) struct Expansion<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> {
    pub(in crate::running) x: PerCoordinate<S::Phase, S::Action>,
    /// The unit of time in the coefficients, a power of two.
    pub(in crate::running) unit: f64,
    /// From order 1 on.
    pub(in crate::running) jet: M::Orders<PerCoordinate<S::Phase, S::Action>>,
    /// From order 0 on.
    pub(in crate::running) switches: M::Orders<S::Switches>,
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Steps<S, M, R> {
    /// The coefficients at a point into a place, for steps of about this length.
    #[inline(always)]
    pub(super) fn expand(&mut self, place: usize, h: f64, t: R, x: PerCoordinate<S::Phase, S::Action>) {
        let expansion = &mut self.expansions[place];
        let unit = power_of_two(h);
        (expansion.x, expansion.unit) = (x, unit);
        let start = [R::from_f64(unit), t];
        M::jet(self.method.order(), &self.system, start, (&x.z, &x.s), &mut expansion.jet, &mut expansion.switches);
    }

    /// The coefficients at a state that the user gave, in a unit of time in which none of them overflows, or where a run goes on, in the unit
    /// before.
    #[cold]
    pub(super) fn begin(&mut self) {
        let (t, x) = (self.time(), PerCoordinate::of(&self.x));
        self.expand(self.present, self.expansions[self.present].unit, t, x);
        if self.taken == self.given {
            self.expand(self.present, self.guess(), t, x);
        }
        self.known = true;
    }

    /// The coefficients at the present.
    pub(super) fn jet(&self) -> &[PerCoordinate<S::Phase, S::Action>] {
        &self.expansions[self.present].jet.as_ref()[..self.order()]
    }

    /// A length in the unit of the coefficients at the present.
    #[inline(always)]
    pub(super) fn in_units(&self, h: f64) -> f64 {
        h / self.expansions[self.present].unit
    }

    /// The state at a time within the last step.
    pub(in crate::running) fn at(&self, t: R) -> Option<StateOf<S, R>> {
        let (start, h) = &self.last;
        let (after, before) = (start.left(t), self.clock.left(t));
        if !self.within {
            return None;
        }
        if t == self.time() {
            return Some(S::State::of(t, self.x.z, self.x.s));
        }
        // Between the ends, in the direction of the step.
        (after * h >= 0.0 && before * h <= 0.0 && *h != 0.0).then(|| self.inside(after, t))
    }

    /// The expansion of the last step, and when it started.
    pub(in crate::running) fn last_expansion(&self) -> (&Expansion<S, M, R>, R) {
        (&self.expansions[1 - self.present], self.last.0.now(zero()))
    }

    /// The expansion at the end of the last step, and when that was.
    pub(in crate::running) fn present_expansion(&self) -> (&Expansion<S, M, R>, R) {
        (&self.expansions[self.present], self.time())
    }

    /// The state so long after the start of the last step, which is at the time `t`.
    pub(in crate::running) fn inside(&self, after: f64, t: R) -> StateOf<S, R> {
        let expansion = &self.expansions[1 - self.present];
        let mut x = taylor::increment(&expansion.jet.as_ref()[..self.order()], after / expansion.unit);
        x.add_scaled(R::from_f64(1.0), &expansion.x);
        S::State::of(t, x.z, x.s)
    }
}

/// The largest power of two that a length is not below, 1 where there is none: to multiply with it and to divide by it is exact.
#[inline(always)]
fn power_of_two(h: f64) -> f64 {
    let power = f64::from_bits(h.to_bits() & f64::INFINITY.to_bits());
    if power > 0.0 && power < f64::INFINITY { power } else { 1.0 }
}

//! The record of the evaluations of one step. It passes points to the [`Probe`] of a run, and stores the values of the last evaluation.
//!
//! A probe explains a refusal by the points at which the energy was evaluated. In fast attempts it does nothing.

use super::points::Departure;
use crate::method::Probe;
use crate::scalar::Real;
use crate::solving::Observer;
use crate::space::{Action, Array};
use crate::system::PhaseSpace;

/// Record of the evaluations of one step.
pub struct Watch<'a, S: PhaseSpace<R>, R: Real, P, LastEvaluation> {
    pub(super) probe: &'a mut P,
    /// The last end of the step at which the equation evaluated conditions of the energy (`if`, `abs`). The driver checks that the rounded end lies on
    /// the same sides. Zero if the energy has no conditions.
    pub(super) solved_end: (S::Phase, S::Action),
    /// The values of the last evaluation, for [`ImplicitStep::update`](super::ImplicitStep::update).
    pub last: LastEvaluation,
}

impl<S: PhaseSpace<R>, R: Real, P: Observer, LastEvaluation> Observer for Watch<'_, S, R, P, LastEvaluation> {
    #[inline(always)]
    fn pause(&mut self, paused: bool) {
        self.probe.pause(paused);
    }
}

impl<'a, S: PhaseSpace<R>, R: Real, P: Probe<S, R>, LastEvaluation> Watch<'a, S, R, P, LastEvaluation> {
    /// Returns the record of a step before its first evaluation.
    #[inline(always)]
    pub(super) fn new(probe: &'a mut P, from: &Departure<'_, S, R>, last: LastEvaluation) -> Self {
        // Without conditions the point is never read, and the copy of the start is omitted. It would stall the processor.
        let solved_end =
            if const { S::JUMPS.is_empty() } { (S::Phase::zero(), S::Action::zero()) } else { (from.z, from.s) };
        Watch { probe, solved_end, last }
    }

    /// Shows the probe a point at which the energy is about to be evaluated. Precondition: unless the policy of the method is
    /// [`Evaluated::Elsewhere`](super::Evaluated::Elsewhere), the point is the end of the step. It is then recorded as by [`record_end`](Self::record_end).
    #[inline(always)]
    pub fn visit(&mut self, t: R, z: &S::Phase, s: &S::Action) {
        self.probe.visit(t, z, s);
        self.record_end(z, s);
    }

    /// Records the end of the step at which the equation evaluates conditions. The probe is not called.
    #[inline(always)]
    pub fn record_end(&mut self, z: &S::Phase, s: &S::Action) {
        if const { !S::JUMPS.is_empty() } {
            self.solved_end = (*z, *s);
        }
    }

    /// Returns the probe. Use it to show points other than the end of the step.
    #[inline(always)]
    pub fn probe(&mut self) -> &mut P {
        self.probe
    }
}

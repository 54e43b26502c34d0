//! The record of the evaluations of one step. It passes points to the [`Probe`] of an attempt, and stores the values of the last evaluation.
//!
//! The probe of a thorough attempt explains a refusal by the points at which the energy was evaluated. The probe of a fast attempt ignores them.

use super::points::Departure;
use crate::method::Probe;
use crate::scalar::Real;
use crate::solving::Observer;
use crate::space::{Action, Array};
use crate::system::PhaseSpace;

/// Record of the evaluations of one step.
pub struct Watch<'a, S: PhaseSpace<R>, R: Real, P, LastEvaluation> {
    pub(super) probe: &'a mut P,
    /// The end of the step, z and s, at which the equation last evaluated conditions of the energy (`if`, `abs`). The driver checks that the energy does not
    /// jump from there to the rounded end. Unused if the energy has no conditions, or with
    /// [`Evaluated::Elsewhere`](super::Evaluated::Elsewhere).
    pub(super) solved_end: (S::Phase, S::Action),
    /// The values of the last evaluation, for [`ImplicitStep::update`](super::ImplicitStep::update), or
    /// [`explained`](super::ImplicitStep::explained) if the solver fails.
    pub last: LastEvaluation,
}

impl<S: PhaseSpace<R>, R: Real, P: Observer, LastEvaluation> Observer for Watch<'_, S, R, P, LastEvaluation> {
    #[inline(always)]
    fn pause(&mut self, paused: bool) {
        self.probe.pause(paused);
    }
}

impl<'a, S: PhaseSpace<R>, R: Real, P: Probe<S, R>, LastEvaluation> Watch<'a, S, R, P, LastEvaluation> {
    /// Returns the record of a step before its first evaluation. `solved_end` is the start, if it is read.
    #[inline(always)]
    pub(super) fn new(probe: &'a mut P, from: &Departure<'_, S, R>, last: LastEvaluation) -> Self {
        // Without conditions the end is never read, and zeros cost less than a copy.
        let solved_end =
            if const { S::JUMPS.is_empty() } { (S::Phase::zero(), S::Action::zero()) } else { (from.z, from.s) };
        Watch { probe, solved_end, last }
    }

    /// Shows the probe a point at which the energy is about to be evaluated, and records it as the end of the step. Precondition: it is this end, unless the
    /// policy of the method is [`Evaluated::Elsewhere`](super::Evaluated::Elsewhere), which does not read the record.
    #[inline(always)]
    pub fn visit(&mut self, t: R, z: &S::Phase, s: &S::Action) {
        self.probe.visit(t, z, s);
        self.record_end(z, s);
    }

    /// Records the end of the step at which the equation evaluates conditions of the energy. The probe is not called.
    #[inline(always)]
    pub fn record_end(&mut self, z: &S::Phase, s: &S::Action) {
        if const { !S::JUMPS.is_empty() } {
            self.solved_end = (*z, *s);
        }
    }

    /// Returns the probe, to show it points other than the end of the step.
    #[inline(always)]
    pub fn probe(&mut self) -> &mut P {
        self.probe
    }
}

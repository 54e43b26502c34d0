//! A watch of one step: it shows the points of evaluations to a probe, and holds the values of the last evaluation.

use super::points::Departure;
use crate::method::Probe;
use crate::scalar::Real;
use crate::solving::Observer;
use crate::space::{Action, Array};
use crate::system::PhaseSpace;

/// Sees the evaluations of one step.
pub struct Watch<'a, S: PhaseSpace<R>, R: Real, P, Seen> {
    pub(super) probe: &'a mut P,
    /// The last end of the step at which conditions of the energy (`if`, `abs`) were evaluated. The driver checks that the rounded end lies on the same sides.
    pub(super) decided: (S::Phase, S::Action),
    /// The values of the last evaluation, for the update.
    pub seen: Seen,
}

impl<S: PhaseSpace<R>, R: Real, P: Observer, Seen> Observer for Watch<'_, S, R, P, Seen> {
    #[inline(always)]
    fn pause(&mut self, paused: bool) {
        self.probe.pause(paused);
    }
}

impl<'a, S: PhaseSpace<R>, R: Real, P: Probe<S, R>, Seen> Watch<'a, S, R, P, Seen> {
    /// Starts to watch a step.
    #[inline(always)]
    pub(super) fn new(probe: &'a mut P, from: &Departure<'_, S, R>, seen: Seen) -> Self {
        // Without conditions nobody reads the point. A copy of the start would be read in other pieces than it was written in, which stalls the processor.
        let decided =
            if const { S::JUMPS.is_empty() } { (S::Phase::zero(), S::Action::zero()) } else { (from.z, from.s) };
        Watch { probe, decided, seen }
    }

    /// Shows a point at which the energy is about to be evaluated.
    #[inline(always)]
    pub fn visit(&mut self, t: R, z: &S::Phase, s: &S::Action) {
        self.probe.visit(t, z, s);
        self.decide(z, s);
    }

    /// Records the end of the step at which conditions are evaluated, without showing it to the probe.
    #[inline(always)]
    pub fn decide(&mut self, z: &S::Phase, s: &S::Action) {
        if const { !S::JUMPS.is_empty() } {
            self.decided = (*z, *s);
        }
    }

    /// Returns the probe, for evaluations at other points than the end.
    #[inline(always)]
    pub fn probe(&mut self) -> &mut P {
        self.probe
    }
}

//! What sees the points at which the equation of a step is evaluated, and what the last evaluation leaves.

use super::points::Departure;
use crate::method::Probe;
use crate::scalar::Real;
use crate::solving::Observer;
use crate::space::{Action, Array};
use crate::system::PhaseSpace;

/// Sees the evaluations of one step.
pub struct Watch<'a, S: PhaseSpace<R>, R: Real, P, E> {
    pub(super) probe: &'a mut P,
    /// The point at which conditions of the energy were decided last.
    pub(super) decided: (S::Phase, S::Action),
    /// What the last evaluation leaves for the update.
    pub seen: E,
}

impl<S: PhaseSpace<R>, R: Real, P: Observer, E> Observer for Watch<'_, S, R, P, E> {
    #[inline(always)]
    fn pause(&mut self, paused: bool) {
        self.probe.pause(paused);
    }
}

impl<'a, S: PhaseSpace<R>, R: Real, P: Probe<S, R>, E> Watch<'a, S, R, P, E> {
    /// Starts to watch a step.
    #[inline(always)]
    pub(super) fn new(probe: &'a mut P, from: &Departure<'_, S, R>, seen: E) -> Self {
        // Without conditions nobody looks at the point. A copy of the start would be read from memory in other pieces than it was written in.
        let decided =
            if const { S::JUMPS.is_empty() } { (S::Phase::zero(), S::Action::zero()) } else { (from.z, from.s) };
        Watch { probe, decided, seen }
    }

    /// Tells that the energy is about to be evaluated at a point.
    #[inline(always)]
    pub fn visit(&mut self, t: R, z: &S::Phase, s: &S::Action) {
        self.probe.visit(t, z, s);
        self.decide(z, s);
    }

    /// Tells that conditions are decided for a step that ends here.
    #[inline(always)]
    pub fn decide(&mut self, z: &S::Phase, s: &S::Action) {
        if const { !S::JUMPS.is_empty() } {
            self.decided = (*z, *s);
        }
    }

    /// Returns who watches the points, for evaluations that decide no conditions.
    #[inline(always)]
    pub fn probe(&mut self) -> &mut P {
        self.probe
    }
}

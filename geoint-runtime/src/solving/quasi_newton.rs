//! Newton's iteration with an approximate derivative. Convergence is linear, not quadratic.
//!
//! Steps along means of gradients need it: the derivative of their mean is exact only near the solution. Each step starts from the guess of its equation, and takes
//! at most 100 evaluations. The iteration, and the ways to repeat it, are those of [`rescue`](super::rescue), which are cold for Newton's iteration only.

use super::equation::{Solution, Solver, StepEquation, Units};
use super::experience::Experience;
use super::rounding::Convergence;
use super::{Observer, Refusal, rescue};
use crate::space::{Array, Record, Tape};

/// Solves equations with an approximate derivative, one per step. It remembers the sizes of the unknowns.
#[derive(Clone, Copy, Debug)]
pub struct QuasiNewton<A> {
    experience: Experience<A>,
}

impl<A: Array> Record<A::Real> for QuasiNewton<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.experience.record(tape);
    }
}

impl<A: Array> Solver<A> for QuasiNewton<A> {
    fn new(units: Units) -> Self {
        QuasiNewton { experience: Experience::new(units) }
    }

    fn solve<W: Observer, E: StepEquation<A, W>>(
        &mut self,
        equation: &E,
        watch: &mut W,
    ) -> Result<Solution<A>, Refusal> {
        let (solution, experience) = rescue::from_start(self.experience, *equation, Convergence::Linear, watch);
        self.experience = experience;
        solution
    }
}

//! Newton's iteration with an approximate derivative. Convergence is linear, not quadratic.
//!
//! Each step starts from the guess of its equation, and takes as many corrections as it needs. The iteration, and the ways to repeat it, are those of
//! [`rescue`](super::rescue).

use super::equation::{Solution, Solver, StepEquation, Units};
use super::experience::Experience;
use super::rounding::Convergence;
use super::{Observer, Refusal, rescue};
use crate::space::{Array, Record, Tape};

/// Solves one equation per step whose derivative is known approximately. It remembers the sizes of the unknowns.
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

//! Newton's iteration x ← x − J⁻¹ r(x) with an approximate derivative J of the residual r. Corrections shrink by a factor: convergence is linear, not
//! quadratic.
//!
//! Steps along means of gradients need it, because the derivative of their mean is exact only near the solution. Each step starts from the guess of its
//! equation. The searches are those of [`rescue`](super::rescue): at most 100 evaluations each. For thorough steps, difference quotients replace J if the first
//! search fails.
//!
//! Limit: a solution after more than five evaluations is followed to h = 0, unless the equation is bound by energy. A fast step is then refused and repeated.

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
        let (solution, experience) =
            rescue::solve_from_explicit_guess(self.experience, *equation, Convergence::Linear, watch);
        self.experience = experience;
        solution
    }
}

//! Newton's iteration x ← x − J⁻¹ r(x) with an approximate derivative J of the residual r. Corrections shrink by a roughly constant factor: convergence is
//! linear, not quadratic.
//!
//! Steps along means of gradients ([`MeanStep`](crate::method::discrete_gradient::MeanStep)) need it, because some of them omit terms of ∂r/∂x in J. J tends to
//! ∂r/∂x as h → 0. Each step starts from the guess of its equation, never from an extrapolation, unlike [`Newton`](super::newton::Newton). The searches are
//! those of [`rescue`](super::rescue), at most 100 evaluations each. [`Effort::Thorough`](super::Effort::Thorough) also tries difference quotients for J.
//!
//! Limit: more than five evaluations may end on a solution that does not belong to small h. A thorough step then follows it back to h = 0
//! ([`branch`](super::branch)), and a fast step is refused and repeated. Equations with [`Branch::OfEnergy`](crate::method::implicit::Branch::OfEnergy), as
//! all steps of means, are exempt.

use super::equation::{Solution, Solver, StepEquation, Units};
use super::experience::Experience;
use super::rounding::Convergence;
use super::{Failure, Observer, rescue};
use crate::space::{Array, Record, Tape};

/// Solves equations with an approximate derivative, one per step. It remembers the largest recent magnitudes of the unknowns: corrections are small relative to
/// them, also if an unknown passes zero.
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
    ) -> Result<Solution<A>, Failure> {
        let (solution, experience) =
            rescue::solve_from_explicit_guess(self.experience, *equation, Convergence::Linear, watch);
        self.experience = experience;
        solution
    }
}

//! The equation of a step with multipliers among its unknowns, and what both methods have in common.

use crate::method::{Deciding, Probe, Refusal};
use crate::scalar::Real;
use crate::solving::equation::{Effort, Solution, StepEquation};
use crate::solving::newton::Newton;
use crate::space::vector::sum;
use crate::space::{Array, Square};
use crate::system::{ConstrainedStep, Poles, on_one_side};

/// Coefficients of a step.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R> {
    pub(super) constants: P,
    pub(super) poles: Poles,
    pub(super) h: R,
}

impl<P, R: Real> Prepared<P, R> {
    pub(super) fn new<M, S: ConstrainedStep<M, R, Constants = P>>(system: &S, h: R) -> Self {
        Prepared { constants: system.constants(h), poles: Poles::of(system), h }
    }
}

/// A step of `M` from z.
pub(super) struct Equation<'a, S: ConstrainedStep<M, R>, M, R: Real> {
    pub(super) system: &'a S,
    pub(super) constants: &'a S::Constants,
    pub(super) begun: S::Start,
    pub(super) t: R,
    pub(super) z: S::Phase,
}

impl<S: ConstrainedStep<M, R>, M, R: Real> Clone for Equation<'_, S, M, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: ConstrainedStep<M, R>, M, R: Real> Copy for Equation<'_, S, M, R> {}

impl<S: ConstrainedStep<M, R>, M, R: Real> Equation<'_, S, M, R> {
    /// What a step adds to z, and what only constraints that depend on each other at its start can be the reason of.
    #[inline(always)]
    pub(super) fn solve<P: Probe<S, R>>(
        &self,
        newton: &mut Newton<S::Unknown>,
        deciding: &mut Deciding<'_, P, S::Phase>,
    ) -> Result<S::Phase, Refusal> {
        match newton.solve(self, deciding) {
            Ok(Solution { x, .. }) => Ok(self.system.end(self.constants, &self.begun, &x)),
            Err(refusal) => Err(self.explained(refusal)),
        }
    }

    #[cold]
    fn explained(&self, refusal: Refusal) -> Refusal {
        match on_one_side(self.system, (self.t, &self.z), [&self.z[0], &self.z[0]]) {
            Err(what) => Refusal::DependentConstraints { what },
            Ok(()) => refusal,
        }
    }
}

impl<S: ConstrainedStep<M, R>, M, R: Real, P: Probe<S, R>> StepEquation<S::Unknown, Deciding<'_, P, S::Phase>>
    for Equation<'_, S, M, R>
{
    const EFFORT: Effort = P::EFFORT;

    #[inline(always)]
    fn origin(&self) -> S::Unknown {
        self.system.origin(self.constants, &self.begun)
    }

    /// The first iteration finds what an explicit step would.
    fn guess(&self) -> S::Unknown {
        S::Unknown::zero()
    }

    #[inline(always)]
    fn residual(
        &self,
        watch: &mut Deciding<'_, P, S::Phase>,
        x: &S::Unknown,
        matrix: &mut Square<S::Unknown>,
    ) -> S::Unknown {
        let Equation { system, constants, begun, t, z } = self;
        watch.visit(*t, &sum(z, &system.end(constants, begun, x)));
        let mut residual = S::Unknown::zero();
        system.residual(constants, begun, x, &mut residual, matrix);
        residual
    }
}

//! The tree discrete gradient as a method. The equation that it solves is beside it.

mod equation;
mod field;
mod polarised;

use super::energy::{Energy, Slope};
use super::mean::MeanGradient;
use crate::method::composition::substeps;
use crate::method::corrected::kept;
use crate::method::{Claims, Method, Name, Probe, Refusal, Step, StepsOf};
use crate::scalar::Real;
use crate::space::{Array, Summation};
use crate::system::{Conservative, DiscreteField, Graded, Invariants, KeptBy};

/// x₁ = x₀ + h J ∇̄H(x₀, x₁) with the tree discrete gradient: the energy is kept to rounding for every h.
///
/// Order 2, symmetric, for every H; not symplectic. ∇̄H is the reverse sweep of H with divided differences in place of
/// derivatives, in forms without cancellation. Quadratic and linear momenta that commute with the innermost quadratic
/// and linear forms in which H is written are kept as well: write central forces as functions of `x * x + y * y`. One
/// Newton solve a step, for half of the unknowns if T is quadratic. With damping C the energy falls by exactly h ∇̄H·C ∇̄H
/// instead (in compositions with steps back in time, only that of each of their steps is so balanced).
/// T. Matsubara, A. Ishikawa & T. Yaguchi, NeurIPS 2020; R. A. LaBudde & D. Greenspan, Numer. Math. 25 (1976) 323.
#[doc(alias("energy-momentum", "energy conserving", "energy-preserving", "AVF"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DiscreteGradient;

impl<S: Graded<R>, R: Real> Method<S, R> for DiscreteGradient
where
    S::Gradient: StepsOf<DiscreteGradient, S, R>,
{
    type Proof = <S as Graded<R>>::Proof;
    type Prepared = <S::Gradient as StepsOf<Self, S, R>>::Prepared;
    type Memory = <S::Gradient as StepsOf<Self, S, R>>::Memory;
    const COMPOSES_TO: u32 = <S::Gradient as StepsOf<Self, S, R>>::COMPOSES_TO;
    const ROUGH_IF_SHORT: bool = <S::Gradient as StepsOf<Self, S, R>>::ROUGH_IF_SHORT;
    const KEEPS: bool = <KeptBy<S, R> as Invariants<S, R>>::Values::LEN > 0;

    #[inline]
    fn way_back(_: &Self::Prepared, system: &S, origin: &S::Phase, z: &S::Phase) -> S::Phase {
        kept::way_back(system, &KeptBy::<S, R>::default(), origin, z)
    }

    fn claims(&self) -> Claims {
        Claims { order: 2, symmetric: true, symplectic: false, conserves_energy: true, perturbed: &[], forces: None }
    }

    fn name(&self) -> Name {
        Name::new("DiscreteGradient")
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        <S::Gradient as StepsOf<Self, S, R>>::prepare(system, h)
    }

    fn memory() -> Self::Memory {
        <S::Gradient as StepsOf<Self, S, R>>::memory()
    }

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        <S::Gradient as StepsOf<Self, S, R>>::step(prepared, memory, step)
    }
}

/// The tree discrete gradient as others use it.
impl MeanGradient for DiscreteGradient {
    fn mean_name(&self) -> Name {
        Name::new("DiscreteGradient")
    }

    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Refusal> {
        Ok(energy.tree(x, d))
    }
}

substeps!([] DiscreteGradient);

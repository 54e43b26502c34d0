//! The tree discrete gradient as a method. The equation that it solves is beside it.

mod equation;

use super::energy::{Energy, Slope};
use super::mean::MeanGradient;
use crate::method::composition::substeps;
use crate::method::{Claims, Deciding, Method, Name, Probe, Refusal, Step, check_conditions, check_poles, start};
use crate::scalar::Real;
use crate::solving::Inverse;
use crate::solving::newton::Newton;
use crate::space::{Array, Compensated, Snapshot, Summation};
use crate::system::{Conservative, DiscreteField, Poles};
use equation::{Coefficients, Equation};

/// x₁ = x₀ + h J ∇̄H(x₀, x₁) with the tree discrete gradient: the energy is kept to rounding for every h.
///
/// Order 2, symmetric, for every H; not symplectic. ∇̄H is the reverse sweep of H with divided differences in place of
/// derivatives, in forms without cancellation. Quadratic and linear momenta that commute with the innermost quadratic
/// and linear forms in which H is written are kept as well: write central forces as functions of `x * x + y * y`. One
/// Newton solve a step, for half of the unknowns if T is quadratic. With damping C the energy falls by exactly h ∇̄H·C ∇̄H
/// instead (in compositions with steps back in time, only that of each of their steps is so balanced).
/// T. Matsubara, A. Ishikawa & T. Yaguchi, NeurIPS 2020; R. A. LaBudde & D. Greenspan, Numer. Math. 25 (1976) 323.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DiscreteGradient;

/// Coefficients of a step.
#[derive(Clone, Debug)]
pub struct Prepared<S: DiscreteField<R>, R: Real> {
    coefficients: Coefficients<S, R>,
    inverse: S::Inverse,
    poles: Poles,
}

/// What a step hands on to the next one.
#[derive(Clone, Debug)]
pub struct Memory<S: DiscreteField<R>, R: Real> {
    newton: Newton<S::Unknown>,
    /// The energy is worth compensated sums, which cost a twentieth: at some step sizes the roundings of plain ones have a bias,
    /// and it drifts by 10⁻¹² in a million steps.
    sums: Compensated<S::Phase>,
}

impl<S: DiscreteField<R>, R: Real> Method<S, R> for DiscreteGradient {
    type Proof = <S as DiscreteField<R>>::Proof;
    type Prepared = Prepared<S, R>;
    type Memory = Memory<S, R>;

    fn claims(&self) -> Claims {
        Claims { order: 2, symmetric: true, symplectic: false, conserves_energy: true, perturbed: &[], forces: None }
    }

    fn name(&self) -> Name {
        Name::new("DiscreteGradient")
    }

    fn prepare(&self, system: &S, h: R) -> Prepared<S, R> {
        let coefficients = Coefficients::new(system, h);
        let inverse = S::Inverse::new(|| coefficients.constant_matrix(system));
        Prepared { coefficients, inverse, poles: Poles::of(system) }
    }

    fn memory() -> Memory<S, R> {
        Memory { newton: Newton::new(S::State::ALIKE, S::Phase::LEN / S::State::ALIKE), sums: Compensated::new() }
    }

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { coefficients, inverse, poles }: &Prepared<S, R>,
        Memory { newton, sums }: &mut Memory<S, R>,
        Step { system, t, x, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        probe.visit(t, &x.z, &());
        let equation = Equation::of_step(system, coefficients, t, x);
        let mut deciding = Deciding { probe, end: x.z };

        // h·f̄ is affine in the impulse: one product with the inverse of its matrix.
        if S::Inverse::EXISTS {
            let impulse = inverse.times(&equation.without_impulse(&mut deciding));
            let before = start::<S, R, C>(x);
            x.add_with(sums, &equation.increments(&impulse), &S::Phase::zero());
            if !impulse.is_finite() {
                return Err(Refusal::Singular);
            }
            // Poles that the simplified energy has not.
            return check_poles(poles, true, [t, t + coefficients.h], &before, Step { system, t, x, probe });
        }

        let (impulse, lost) = newton.solve(&equation, &mut deciding)?;
        let Deciding { probe, end } = deciding;

        let before = start::<S, R, C>(x);
        let increments = equation.increments(&impulse);
        x.add_with(sums, &increments, &equation.lost::<C>(&impulse, &lost));
        check_conditions(system, t + R::from_f64(0.5) * coefficients.h, &end, x)?;
        check_poles(poles, true, [t, t + coefficients.h], &before, Step { system, t, x, probe })
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

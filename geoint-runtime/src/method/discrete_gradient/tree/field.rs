//! Steps of the tree discrete gradient of an energy, or of what a field keeps.

use super::DiscreteGradient;
use super::equation::{Coefficients, Equation};
use crate::method::corrected::rounded;
use crate::method::{Deciding, Probe, Refusal, Step, StepsOf, check_conditions, check_poles, start};
use crate::scalar::Real;
use crate::solving::Inverse;
use crate::solving::equation::Solution;
use crate::solving::newton::Newton;
use crate::space::{Array, Compensated, Record, Snapshot, Summation, Tape};
use crate::system::{ByTree, DiscreteField, Poles};

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

impl<S: DiscreteField<R>, R: Real> Record<R> for Memory<S, R> {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        self.newton.record(tape);
        self.sums.record(tape);
    }
}

impl<S: DiscreteField<R>, R: Real> StepsOf<DiscreteGradient, S, R> for ByTree {
    type Prepared = Prepared<S, R>;
    type Memory = Memory<S, R>;

    fn prepare(system: &S, h: R) -> Prepared<S, R> {
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
        Step { system, t, end, x, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        probe.visit(t, &x.z, &());
        let equation = Equation::of_step(system, coefficients, [t, end], x, sums);
        let mut deciding = Deciding::of::<S, R>(probe, &x.z);

        // h·f̄ is affine in the impulse: one product with the inverse of its matrix.
        if S::Inverse::EXISTS {
            let (impulse, increments) = equation.affine(inverse, &mut deciding);
            let before = start::<S, R, C>(x);
            x.add_with(sums, &increments, &S::Phase::zero());
            if !impulse.is_finite() {
                return Err(Refusal::Singular);
            }
            // Poles that the simplified energy has not.
            return check_poles(poles, true, &before, Step { system, t, end, x, probe });
        }

        let Solution { x: impulse, rounding_error } = newton.solve(&equation, &mut deciding)?;
        let Deciding { probe, decided } = deciding;

        let before = start::<S, R, C>(x);
        let lost = equation.lost::<C>(&impulse, &rounding_error);
        x.add_with(sums, &equation.increments(&impulse), &lost);
        rounded::check_step::<S, R, P, C>(system, [t, end], &before.0, x)?;
        check_conditions(system, t + R::from_f64(0.5) * coefficients.h, &decided, x)?;
        check_poles(poles, true, &before, Step { system, t, end, x, probe })
    }
}

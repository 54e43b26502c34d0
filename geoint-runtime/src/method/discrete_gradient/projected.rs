//! Order 4 by projection of a mean velocity: the equation is the system's, the step is here.

use super::mean::MeanGradient;
use super::{DiscreteGradient, FourthOrder};
use crate::method::{Claims, Method, Name, Probe, Refusal, Step, check_conditions, check_end, start};
use crate::scalar::Real;
use crate::solving::newton::Newton;
use crate::space::vector::{moved, scaled, sum};
use crate::space::{Array, Compensated, Snapshot, Square, Summation};
use crate::system::{FourthOrderField, Poles};
use core::cell::Cell;

/// Coefficients of a step.
#[derive(Clone, Debug)]
pub struct Prepared<S: FourthOrderField<R>, R: Real> {
    parameters: S::FourthParameters,
    h: R,
    poles: Poles,
}

/// What a step hands on to the next one.
#[derive(Clone, Debug)]
pub struct Memory<Z: Array> {
    newton: Newton<Z>,
    /// What is kept is worth compensated sums.
    sums: Compensated<Z>,
}

impl<S: FourthOrderField<R>, R: Real> Method<S, R> for FourthOrder<DiscreteGradient> {
    type Proof = <S as FourthOrderField<R>>::Proof;
    type Prepared = Prepared<S, R>;
    type Memory = Memory<S::Phase>;

    fn claims(&self) -> Claims {
        Claims { order: 4, symmetric: true, symplectic: false, conserves_energy: true, perturbed: &[], forces: None }
    }

    fn name(&self) -> Name {
        Name::new("FourthOrder").of(self.0.mean_name())
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        Prepared { parameters: system.fourth_parameters(h), h, poles: Poles::of(system) }
    }

    fn memory() -> Self::Memory {
        Memory { newton: Newton::new(S::State::ALIKE, S::Phase::LEN / S::State::ALIKE), sums: Compensated::new() }
    }

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { parameters, h, poles }: &Self::Prepared,
        Memory { newton, sums }: &mut Self::Memory,
        Step { system, t, x, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let (z, h, half) = (x.z, *h, R::from_f64(0.5) * *h);
        probe.visit(t, &z, &());
        // The explicit midpoint rule.
        let explicit = move || {
            let mut rate = S::Phase::zero();
            system.rate(t, &z, &mut rate);
            system.rate(t + half, &moved(&z, half, &rate), &mut rate);
            scaled(h, &rate)
        };
        let begun = system.fourth_begin(parameters, t + half, &z);
        // The end of the step at which conditions were decided last.
        let decided = Cell::new(z);
        let evaluate = |probe: &mut P, d: &S::Phase, matrix: &mut Square<S::Phase>| {
            let end = sum(&z, d);
            probe.visit(t, &end, &());
            if !S::JUMPS.is_empty() {
                decided.set(end);
            }
            let mut image = S::Phase::zero();
            system.fourth_slope(parameters, &begun, d, &mut image, matrix);
            image
        };
        let image = |probe: &mut P, d: &S::Phase| evaluate(probe, d, &mut S::Phase::fill(S::Phase::zero()));
        let (d, lost) = newton.solve((&z, P::PATIENT.then_some(0.0)), explicit, probe, image, evaluate)?;
        let before = start::<S, R, C>(x);
        x.add_with(sums, &d, &lost);
        check_conditions(system, t + half, &decided.get(), x)?;
        check_end(poles, [t, t + h], &before, Step { system, t, x, probe })
    }
}

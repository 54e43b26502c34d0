//! Steps of the polarised discrete gradient of a Lagrangian that is quadratic in v: see [`PolarisedForm`].

use super::GradientSteps;
use crate::method::{Probe, Refusal, Step, check_conditions, check_poles, start};
use crate::scalar::Real;
use crate::solving::newton::Newton;
use crate::space::vector::{scaled, sum};
use crate::space::{Array, Compensated, Square, Summation};
use crate::system::{ByPolarisation, Orientation, PolarisedForm, Poles, acceleration, row_scale, velocity_near};

/// Coefficients of a step.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R> {
    parameters: P,
    poles: Poles,
    h: R,
}

/// What a step hands on to the next one.
#[derive(Clone, Debug)]
pub struct Memory<S: PolarisedForm<R>, R: Real> {
    newton: Newton<S::Array>,
    orientation: Orientation,
    sums: Compensated<S::Phase>,
}

impl<S: PolarisedForm<R>, R: Real> GradientSteps<S, R> for ByPolarisation {
    type Prepared = Prepared<S::Parameters, R>;
    type Memory = Memory<S, R>;

    fn prepare(system: &S, h: R) -> Self::Prepared {
        Prepared { parameters: system.parameters(h), poles: Poles::of(system), h }
    }

    fn memory() -> Self::Memory {
        Memory { newton: Newton::new(S::Array::LEN, 1), orientation: Orientation::unknown(), sums: Compensated::new() }
    }

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { parameters, poles, h }: &Self::Prepared,
        Memory { newton, orientation, sums }: &mut Self::Memory,
        Step { system, t, x, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let (none, z, half) = (S::Array::zero(), x.z, R::from_f64(0.5));
        probe.visit(t, &z, &());
        let (v, positive) = velocity_near(system, t, &z, none).ok_or(Refusal::Singular)?;
        let sign = orientation.sign::<R>(|| Some(positive))?;
        orientation.agrees(Some(positive))?;
        let begun = system.begin(parameters, t + half * *h, &z, &v);
        let mut units = none;
        {
            let (mut p, mut mass) = (none, S::Array::fill(none));
            system.mass(t, &z[0], &v, &mut p, &mut mass);
            for (i, row) in S::Array::entries::<S::Array>(&mut mass).iter().enumerate() {
                units.as_mut_slice()[i] = R::from_f64(1.0) / row_scale(row, i);
            }
            units.as_mut_slice()[0] *= sign;
        }

        // q₁ − q₀ = h (v₀ + d/2).
        let shift = |d: &S::Array| {
            let mut mean = v;
            mean.add_scaled(half, d);
            scaled(*h, &mean)
        };
        let explicit = move || scaled(*h, &acceleration(system, t, &z[0], &v));
        let evaluate = |probe: &mut P, d: &S::Array, matrix: &mut Square<S::Array>| {
            probe.visit(t, &[sum(&z[0], &shift(d)), z[1]], &());
            let mut residual = none;
            system.equation(parameters, &begun, d, &mut residual, matrix);
            let mut image = *d;
            let rows = S::Array::entries::<S::Array>(matrix).iter_mut().zip(image.as_mut_slice());
            for (i, (row, image)) in rows.enumerate() {
                let unit = units.as_slice()[i];
                for x in row.as_mut_slice() {
                    *x *= unit;
                }
                *image = (-unit).multiply_add(residual.as_slice()[i], *image);
            }
            image
        };
        let image = |probe: &mut P, d: &S::Array| evaluate(probe, d, &mut S::Array::fill(none));
        // −2v₀ turns v round: nothing moves.
        let still = P::PATIENT.then_some(-2.0);
        let (d, _) = newton.solve((&v, still), explicit, probe, image, evaluate)?;

        let increments = [shift(&d), system.impulse(parameters, &begun, &d)];
        let decided = sum(&z, &increments);
        let before = start::<S, R, C>(x);
        x.add_with(sums, &increments, &S::Phase::zero());
        check_conditions(system, t + half * *h, &decided, x)?;
        check_poles(poles, true, [t, t + *h], &before, Step { system, t, x, probe })
    }
}

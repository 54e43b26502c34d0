//! Steps of the polarised discrete gradient of a Lagrangian that is quadratic in v: see [`PolarisedForm`].

use super::DiscreteGradient;
use crate::method::{Deciding, Probe, Refusal, Step, StepsOf, check_conditions, check_poles, start};
use crate::scalar::Real;
use crate::solving::equation::StepEquation;
use crate::solving::newton::{Found, Newton};
use crate::space::vector::{difference, moved, scaled, sum};
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

impl<S: PolarisedForm<R>, R: Real> StepsOf<DiscreteGradient, S, R> for ByPolarisation {
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
        let (none, z, middle) = (S::Array::zero(), x.z, t + R::from_f64(0.5) * *h);
        probe.visit(t, &z, &());
        let (v, positive) = velocity_near(system, t, &z, none).ok_or(Refusal::Singular)?;
        let sign = orientation.sign::<R>(|| Some(positive))?;
        orientation.agrees(Some(positive))?;
        let begun = system.begin(parameters, middle, &z, &v);
        let (mut p, mut mass) = (none, S::Array::fill(none));
        system.mass(t, &z[0], &v, &mut p, &mut mass);
        let mut units = none;
        for (i, row) in S::Array::entries::<S::Array>(&mut mass).iter().enumerate() {
            units.as_mut_slice()[i] = R::from_f64(1.0) / row_scale(row, i);
        }
        units.as_mut_slice()[0] *= sign;

        let equation = Equation { system, parameters, t, h: *h, z, v, begun, units };
        let mut deciding = Deciding { probe, end: z };
        let Found { x: d, outcome, .. } = newton.solve(&equation, &mut deciding);
        outcome?;
        let Deciding { probe, end } = deciding;

        let increments = [equation.shift(&d), system.impulse(parameters, &begun, &d)];
        let before = start::<S, R, C>(x);
        x.add_with(sums, &increments, &S::Phase::zero());
        check_conditions(system, middle, &end, x)?;
        let last = velocity_near(system, t + *h, &x.z, sum(&v, &d));
        orientation.agrees(last.map(|(_, positive)| positive))?;
        check_poles(poles, true, [t, t + *h], &before, Step { system, t, x, probe })
    }
}

/// M(q₁)v₁ + a(q₁) = p₁ for d = v₁ − v₀.
struct Equation<'a, S: PolarisedForm<R>, R: Real> {
    system: &'a S,
    parameters: &'a S::Parameters,
    t: R,
    h: R,
    z: S::Phase,
    v: S::Array,
    begun: S::Start,
    /// A row over |Mᵢᵢ| has the unit of the velocity.
    units: S::Array,
}

impl<S: PolarisedForm<R>, R: Real> Clone for Equation<'_, S, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: PolarisedForm<R>, R: Real> Copy for Equation<'_, S, R> {}

impl<S: PolarisedForm<R>, R: Real> Equation<'_, S, R> {
    /// q₁ − q₀ = h (v₀ + d/2).
    #[inline(always)]
    fn shift(&self, d: &S::Array) -> S::Array {
        scaled(self.h, &moved(&self.v, R::from_f64(0.5), d))
    }
}

impl<S: PolarisedForm<R>, R: Real, P: Probe<S, R>> StepEquation<S::Array, Deciding<'_, P, S::Phase>>
    for Equation<'_, S, R>
{
    /// −2v₀ turns v round: nothing moves.
    const STANDSTILL: Option<f64> = if P::PATIENT { Some(-2.0) } else { None };

    #[inline(always)]
    fn origin(&self) -> S::Array {
        self.v
    }

    fn explicit(&self) -> S::Array {
        scaled(self.h, &acceleration(self.system, self.t, &self.z[0], &self.v))
    }

    #[inline(always)]
    fn evaluate(&self, watch: &mut Deciding<'_, P, S::Phase>, d: &S::Array, matrix: &mut Square<S::Array>) -> S::Array {
        difference(d, &self.residual(watch, d, matrix))
    }

    #[inline(always)]
    fn residual(&self, watch: &mut Deciding<'_, P, S::Phase>, d: &S::Array, matrix: &mut Square<S::Array>) -> S::Array {
        watch.visit(self.t, &[sum(&self.z[0], &self.shift(d)), self.z[1]]);
        let mut residual = S::Array::zero();
        self.system.equation(self.parameters, &self.begun, d, &mut residual, matrix);
        let rows = S::Array::entries::<S::Array>(matrix).iter_mut().zip(residual.as_mut_slice());
        for ((row, residual), unit) in rows.zip(self.units.as_slice()) {
            *row = scaled(*unit, row);
            *residual *= *unit;
        }
        residual
    }
}

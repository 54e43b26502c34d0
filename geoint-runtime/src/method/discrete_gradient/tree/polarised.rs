//! Steps of the polarised discrete gradient of a Lagrangian that is quadratic in v: see [`PolarisedForm`].

use super::DiscreteGradient;
use crate::method::{Deciding, Probe, Refusal, Step, StepsOf, check_conditions, check_poles, start};
use crate::scalar::Real;
use crate::solving::Observer;
use crate::solving::equation::{Effort, Solution, StepEquation};
use crate::solving::newton::Newton;
use crate::space::vector::{difference, dot, moved, scaled, sum};
use crate::space::{Array, Compensated, Record, Square, Summation, Tape};
use crate::system::{ByPolarisation, PolarisedForm, Poles, Regular, acceleration, row_scale, velocity_near};

/// Coefficients of a step.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R> {
    parameters: P,
    poles: Poles,
    h: R,
    /// The mass matrix is positive definite everywhere.
    is_definite: bool,
}

/// What is known of a point.
#[derive(Clone, Copy, Debug)]
struct Known<Z, A> {
    z: Z,
    v: A,
    /// 1/|Mᵢᵢ|, perhaps of a point before.
    units: A,
}

/// What a step hands on to the next one.
#[derive(Clone, Debug)]
pub struct Memory<S: PolarisedForm<R>, R: Real> {
    newton: Newton<S::Array>,
    regular: Regular<S::Array>,
    /// The end of the last step.
    last: Option<Known<S::Phase, S::Array>>,
    sums: Compensated<S::Phase>,
}

impl<S: PolarisedForm<R>, R: Real> Record<R> for Memory<S, R> {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        self.newton.record(tape);
        self.regular.record(tape);
        let blank = || Known { z: S::Phase::zero(), v: S::Array::zero(), units: S::Array::zero() };
        tape.option(&mut self.last, blank);
        self.sums.record(tape);
    }
}

impl<Z: Array, A: Array<Real = Z::Real>> Record<Z::Real> for Known<Z, A> {
    fn record(&mut self, tape: &mut impl Tape<Z::Real>) {
        tape.array(&mut self.z);
        tape.array(&mut self.v);
        tape.array(&mut self.units);
    }
}

impl<S: PolarisedForm<R>, R: Real> StepsOf<DiscreteGradient, S, R> for ByPolarisation {
    type Prepared = Prepared<S::Parameters, R>;
    type Memory = Memory<S, R>;

    fn prepare(system: &S, h: R) -> Self::Prepared {
        Prepared { parameters: system.parameters(h), poles: Poles::of(system), h, is_definite: system.is_definite() }
    }

    fn memory() -> Self::Memory {
        Memory {
            newton: Newton::new(S::Array::LEN, 1),
            regular: Regular::unknown(),
            last: None,
            sums: Compensated::new(),
        }
    }

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { parameters, poles, h, is_definite }: &Self::Prepared,
        Memory { newton, regular, last, sums }: &mut Self::Memory,
        Step { system, t, end, x, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let (z, middle) = (x.z, t + R::from_f64(0.5) * *h);
        probe.visit(t, &z, &());
        let sign = regular.begin(system, *is_definite, (t, &z, &()))?;
        // A point that nobody has moved since.
        let known = match *last {
            Some(known) if known.z == z => known,
            _ => known(system, t, z)?,
        };
        let Known { v, mut units, .. } = known;
        units.as_mut_slice()[0] *= sign;
        let begun = system.begin(parameters, middle, &z, &v);
        let equation = Equation { system, parameters, t, h: *h, z, v, begun, units };
        let none = S::Array::zero();
        let deciding = Deciding::of::<S, R>(probe, &z);
        let mut seen = Seen { deciding, d: none, impulse: none, by_d: S::Array::fill(none) };
        let Solution { x: d, .. } = newton.solve(&equation, &mut seen)?;
        // The impulse where it was evaluated last, and what the last correction changes it by: its square is rounding.
        let correction = difference(&d, &seen.d);
        let mut impulse = seen.impulse;
        for (p, row) in impulse.as_mut_slice().iter_mut().zip(S::Array::entries_of::<S::Array>(&seen.by_d)) {
            *p += dot(row, &correction);
        }
        let Deciding { probe, decided } = seen.deciding;

        let increments = [equation.shift(&d), impulse];
        let before = start::<S, R, C>(x);
        x.add_with(sums, &increments, &S::Phase::zero());
        check_conditions(system, middle, &decided, x)?;
        let mut v = sum(&v, &d);
        if !is_definite {
            regular.follow(system, false, [(t, &z, &()), (t + *h, &x.z, &())], v)?;
            v = velocity_near(system, t + *h, &x.z, &(), v).ok_or(Refusal::Singular)?;
        }
        *last = Some(Known { z: x.z, v, ..known });
        check_poles(poles, true, &before, Step { system, t, end, x, probe })
    }
}

/// v of a point, and units.
#[cold]
#[inline(never)]
fn known<S: PolarisedForm<R>, R: Real>(system: &S, t: R, z: S::Phase) -> Result<Known<S::Phase, S::Array>, Refusal> {
    let none = S::Array::zero();
    let v = velocity_near(system, t, &z, &(), none).ok_or(Refusal::Singular)?;
    let (mut p, mut mass, mut units) = (none, S::Array::fill(none), none);
    system.mass(t, &z[0], &v, &(), (&mut p, &mut mass));
    for (i, row) in S::Array::entries::<S::Array>(&mut mass).iter().enumerate() {
        units.as_mut_slice()[i] = R::from_f64(1.0) / row_scale(row, i);
    }
    Ok(Known { z, v, units })
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

/// Who watches, and the impulse that was evaluated last, for which d, with its derivative.
struct Seen<'a, P, Z, A: Array> {
    deciding: Deciding<'a, P, Z>,
    d: A,
    impulse: A,
    by_d: Square<A>,
}

impl<P: Observer, Z, A: Array> Observer for Seen<'_, P, Z, A> {
    fn pause(&mut self, paused: bool) {
        self.deciding.pause(paused);
    }
}

impl<S: PolarisedForm<R>, R: Real, P: Probe<S, R>> StepEquation<S::Array, Seen<'_, P, S::Phase, S::Array>>
    for Equation<'_, S, R>
{
    const EFFORT: Effort = P::EFFORT;

    /// Friction takes energy away, and only explicit time may add some.
    fn is_bound_by_energy(&self) -> bool {
        true
    }

    /// −2v₀ turns v round: nothing moves.
    fn standstill(&self) -> f64 {
        -2.0
    }

    #[inline(always)]
    fn origin(&self) -> S::Array {
        self.v
    }

    fn guess(&self) -> S::Array {
        scaled(self.h, &acceleration(self.system, self.t, &self.z[0], &self.v))
    }

    #[inline(always)]
    fn residual(
        &self,
        Seen { deciding, d: last, impulse, by_d }: &mut Seen<'_, P, S::Phase, S::Array>,
        d: &S::Array,
        matrix: &mut Square<S::Array>,
    ) -> S::Array {
        deciding.visit(self.t, &[sum(&self.z[0], &self.shift(d)), self.z[1]]);
        let mut residual = S::Array::zero();
        *last = *d;
        self.system.equation(self.parameters, &self.begun, d, [&mut residual, impulse], [matrix, by_d]);
        let rows = S::Array::entries::<S::Array>(matrix).iter_mut().zip(residual.as_mut_slice());
        for ((row, residual), unit) in rows.zip(self.units.as_slice()) {
            *row = scaled(*unit, row);
            *residual *= *unit;
        }
        residual
    }
}

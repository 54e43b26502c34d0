//! Steps of the polarised discrete gradient of a Lagrangian with an action: see [`ContactPolarised`].

use super::ContactDiscreteGradient;
use crate::method::{Probe, Refusal, Step, StepsOf, check_end, start};
use crate::scalar::{Real, zero};
use crate::solving::Observer;
use crate::solving::equation::{Effort, Solution, StepEquation};
use crate::solving::newton::Newton;
use crate::space::vector::{difference, dot, moved, product, scaled, sum};
use crate::space::{Array, PerCoordinate, Record, Square, Summation, Tape};
use crate::system::{ByPolarisation, ContactPolarised, ContactStage, Poles, Regular, row_scale, velocity_near};

/// Coefficients of a step.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, R> {
    parameters: P,
    poles: Poles,
    h: R,
    /// The mass matrix is positive definite everywhere.
    is_definite: bool,
}

/// What a step hands on to the next one.
#[derive(Clone, Copy, Debug)]
pub struct Memory<D, A: Array> {
    newton: Newton<D>,
    regular: Regular<A>,
    /// The velocity at the end of the last step.
    v: A,
}

impl<D: Array, A: Array<Real = D::Real>> Record<D::Real> for Memory<D, A> {
    fn record(&mut self, tape: &mut impl Tape<D::Real>) {
        self.newton.record(tape);
        self.regular.record(tape);
        self.v.as_mut_slice().iter_mut().for_each(|x| tape.scalar(x));
    }
}

impl<S: ContactPolarised<R>, R: Real> StepsOf<ContactDiscreteGradient, S, R> for ByPolarisation {
    type Prepared = Prepared<S::Parameters, R>;
    type Memory = Memory<S::Unknown, S::Array>;

    fn prepare(system: &S, h: R) -> Self::Prepared {
        Prepared { parameters: system.parameters(h), poles: Poles::of(system), h, is_definite: system.is_definite() }
    }

    fn memory() -> Self::Memory {
        Memory { newton: Newton::new(S::Array::LEN, 2), regular: Regular::unknown(), v: S::Array::zero() }
    }

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { parameters, poles, h, is_definite }: &Self::Prepared,
        Memory { newton, regular, v: near }: &mut Self::Memory,
        Step { system, t, end, x, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let (z, s, middle) = (x.z, x.s, t + R::from_f64(0.5) * *h);
        probe.visit(t, &z, &s);
        // With time frozen in the middle of the step.
        let sign = regular.begin(system, *is_definite, (t, &z, &s))?;
        let v = velocity_near(system, middle, &z, &s, *near).ok_or(Refusal::Singular)?;
        let begun = system.begin(parameters, middle, &z, &s, &v);
        let units = units(system, middle, &z, &s, (&v, sign));
        let equation = Equation { system, parameters, middle, h: *h, z, s, v, begun, units };
        let none = S::Unknown::zero();
        let mut seen = Seen { probe, d: none, increments: none, by_d: S::Unknown::fill(none) };
        let Solution { x: d, .. } = newton.solve(&equation, &mut seen)?;
        // Increments where they were evaluated last, and what the last correction changes them by: its square is rounding.
        let correction = difference(&d, &seen.d);
        let mut increments = seen.increments;
        for (x, row) in increments.as_mut_slice().iter_mut().zip(S::Unknown::entries_of::<S::Unknown>(&seen.by_d)) {
            *x += dot(row, &correction);
        }
        let Seen { probe, .. } = seen;

        let (impulse, ds) = equation.apart(&increments);
        let before = start::<S, R, C>(x);
        x.add_everywhere(&PerCoordinate { z: [equation.shift(&d), impulse], s: ds });
        *near = sum(&v, &equation.apart(&d).0);
        regular.follow(system, *is_definite, [(t, &z, &s), (t + *h, &x.z, &x.s)], *near)?;
        check_end(poles, &before, Step { system, t, end, x, probe })
    }
}

/// 1/|Mᵢᵢ| for rows of momenta, and 1 for that of the action; the first with the sign of the determinant of M.
#[inline(always)]
fn units<S: ContactPolarised<R>, R: Real>(
    system: &S,
    t: R,
    z: &S::Phase,
    s: &R,
    (v, sign): (&S::Array, R),
) -> S::Unknown {
    let (mut p, mut mass, mut units) = (S::Array::zero(), S::Array::fill(S::Array::zero()), S::Unknown::zero());
    system.mass(t, &z[0], v, s, (&mut p, &mut mass));
    units.as_mut_slice().fill(R::from_f64(1.0));
    let rows = S::Array::entries_of::<S::Array>(&mass).iter().enumerate();
    for (unit, (i, row)) in units.as_mut_slice().iter_mut().zip(rows) {
        *unit = R::from_f64(1.0) / row_scale(row, i);
    }
    units.as_mut_slice()[0] *= sign;
    units
}

/// ∂L/∂v = p₁ at the end, and the increment of s, for those of v and s.
struct Equation<'a, S: ContactPolarised<R>, R: Real> {
    system: &'a S,
    parameters: &'a S::Parameters,
    middle: R,
    h: R,
    z: S::Phase,
    s: R,
    v: S::Array,
    begun: S::Start,
    units: S::Unknown,
}

impl<S: ContactPolarised<R>, R: Real> Clone for Equation<'_, S, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: ContactPolarised<R>, R: Real> Copy for Equation<'_, S, R> {}

impl<S: ContactPolarised<R>, R: Real> Equation<'_, S, R> {
    /// What belongs to coordinates, and to the action.
    #[inline(always)]
    fn apart(&self, d: &S::Unknown) -> (S::Array, R) {
        let mut v = S::Array::zero();
        v.as_mut_slice().copy_from_slice(&d.as_slice()[..S::Array::LEN]);
        (v, d.as_slice().last().copied().unwrap_or_else(zero))
    }

    /// The same in a row.
    #[inline(always)]
    fn together(&self, v: &S::Array, s: R) -> S::Unknown {
        let mut row = S::Unknown::zero();
        row.as_mut_slice().fill(s);
        row.as_mut_slice()[..S::Array::LEN].copy_from_slice(v.as_slice());
        row
    }

    /// q₁ − q₀ = h (v₀ + d/2).
    #[inline(always)]
    fn shift(&self, d: &S::Unknown) -> S::Array {
        scaled(self.h, &moved(&self.v, R::from_f64(0.5), &self.apart(d).0))
    }
}

/// Who watches, and the increments that were evaluated last, for which d, with their derivatives.
struct Seen<'a, P, D: Array> {
    probe: &'a mut P,
    d: D,
    increments: D,
    by_d: Square<D>,
}

impl<P: Observer, D: Array> Observer for Seen<'_, P, D> {
    fn pause(&mut self, paused: bool) {
        self.probe.pause(paused);
    }
}

impl<S: ContactPolarised<R>, R: Real, P: Probe<S, R>> StepEquation<S::Unknown, Seen<'_, P, S::Unknown>>
    for Equation<'_, S, R>
{
    const EFFORT: Effort = P::EFFORT;

    #[inline(always)]
    fn origin(&self) -> S::Unknown {
        self.together(&self.v, self.s)
    }

    /// The increments as if v' and s' were constant.
    fn guess(&self) -> S::Unknown {
        let mut at = ContactStage::none();
        self.system.stage(&self.system.stage_constants(), self.middle, &self.z[0], &self.v, &self.s, &mut at);
        scaled(self.h, &self.together(&at.acceleration(&self.v), at.lagrangian))
    }

    #[inline(always)]
    fn residual(
        &self,
        Seen { probe, d: last, increments, by_d }: &mut Seen<'_, P, S::Unknown>,
        d: &S::Unknown,
        matrix: &mut Square<S::Unknown>,
    ) -> S::Unknown {
        let s = self.s + self.apart(d).1;
        probe.visit(self.middle, &[sum(&self.z[0], &self.shift(d)), self.z[1]], &s);
        let mut residual = S::Unknown::zero();
        *last = *d;
        self.system.equation(self.parameters, &self.begun, d, [&mut residual, increments], [matrix, by_d]);
        for (row, unit) in S::Unknown::entries::<S::Unknown>(matrix).iter_mut().zip(self.units.as_slice()) {
            *row = scaled(*unit, row);
        }
        product(&residual, &self.units)
    }
}

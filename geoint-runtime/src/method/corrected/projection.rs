//! x₁ = y + Σ λᵢ D²∇Iᵢ(y): a step of any method, and back to where the invariants were.

use super::scales::Scales;
use crate::method::corrected::invariants::Invariants;
use crate::method::{And, Claims, Method, Name, Probe, Refusal, Step, check_conditions, check_poles, outer_step};
use crate::scalar::{Real, zero};
use crate::solving::noise;
use crate::solving::rounding::correct;
use crate::solving::size::Sizes;
use crate::space::vector::{difference, dot, sum};
use crate::space::{Array, Compensated, Record, Square, Summation, Tape};
use crate::system::{Poles, VectorField};
use core::cell::Cell;

/// A method, and the invariants that each of its steps is projected onto: `Projection(RK4, Energy)`.
///
/// The order of the method; invariants are kept to rounding; where gradients depend on each other, those that say nothing new take
/// no part. Neither symmetric nor symplectic: what is not projected onto drifts, even the momentum of a cyclic coordinate. The way
/// back is the shortest one if every coordinate is measured in units of the largest magnitude D that it has had, or of what it moves by in a
/// thousand steps, if that is less: an angle of many turns is large, and energies do not change over as much. It does not depend on the units in
/// which q and p are given, and a coordinate that has always been zero stays zero.
/// E. Hairer, Ch. Lubich & G. Wanner, *Geometric Numerical Integration* (2006), section IV.4, algorithm 4.2.
///
/// Taylor series are projected, too: `system.taylor(Projection(Taylor { tolerance: 1e-8 }, Energy), state)`. Their energy then has no drift at
/// any tolerance. States between the ends of steps are those of the series.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Projection<M, I>(pub M, pub I);

/// What a step hands on to the next one.
#[derive(Clone, Copy, Debug)]
pub struct Memory<M, A: Array> {
    method: M,
    scales: Scales<A>,
    /// Corrections may be smaller than the last digit of a coordinate, and all of one sign.
    sums: Compensated<A>,
}

impl<M: Record<A::Real>, A: Array> Record<A::Real> for Memory<M, A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.method.record(tape);
        self.scales.record(tape);
        self.sums.record(tape);
    }
}

/// What the method prepared, and the invariants.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<P, I, R> {
    method: P,
    h: R,
    poles: Poles,
    invariants: I,
}

impl<S: VectorField<R>, R: Real, M: Method<S, R>, I: Invariants<S, R>> Method<S, R> for Projection<M, I> {
    type Proof = <M::Proof as And<I::Values>>::Both;
    type Prepared = Prepared<M::Prepared, I, R>;
    type Memory = Memory<M::Memory, S::Phase>;
    const SCALES_STEPS: bool = M::SCALES_STEPS;

    fn claims(&self) -> Claims {
        let Claims { order, .. } = self.0.claims();
        Claims {
            order,
            symmetric: false,
            symplectic: false,
            conserves_energy: I::KEEP_ENERGY,
            perturbed: &[],
            forces: None,
        }
    }

    fn name(&self) -> Name {
        Name::new("Projection").of(self.0.name())
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        Prepared { method: self.0.prepare(system, h), h, poles: Poles::of(system), invariants: self.1 }
    }

    fn memory() -> Self::Memory {
        Memory { method: M::memory(), scales: Scales::new(), sums: Compensated::new() }
    }

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { method, h, poles, invariants }: &Self::Prepared,
        memory: &mut Self::Memory,
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let Memory { method: memory, scales, sums } = memory;
        let before = step.x.z;
        outer_step::<S, R, M, C, P>(method, memory, *h, step.part(step.t))?;
        let Step { system, t, x, probe } = step;
        probe.visit(t, &x.z, &());
        let moved = difference(&x.z, &before);
        scales.include(&before, &moved);

        let way = way_back(system, invariants, scales, [&before, &x.z], &moved)?;
        x.correct(sums, &before, &moved, &way.back);
        if I::KEEP_ENERGY {
            check_conditions(system, t, &sum(&before, &way.decided), x)?;
        }
        check_poles(poles, false, [t; 2], &(before, ()), Step { system, t, x, probe })
    }
}

/// From the end of a step to where the invariants are what they were.
pub(super) struct WayBack<Z> {
    pub(super) back: Z,
    /// The increment of the step at whose end conditions of the energy were decided last.
    decided: Z,
}

/// The way back from the end of a step by `moved`.
pub(super) fn way_back<S: VectorField<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    scales: &Scales<S::Phase>,
    [before, end]: [&S::Phase; 2],
    moved: &S::Phase,
) -> Result<WayBack<S::Phase>, Refusal> {
    let (sizes, units) = (&scales.sizes, scales.units());
    // D∇I, and the sum of its entries' magnitudes, by which it is divided. By ε times the same sum over sizes rounding changes an invariant.
    let mut gradients = invariants.gradients(system, end);
    let directions = I::Values::entries(&mut gradients);
    let (mut terms, mut digits) = (I::Values::zero(), Sizes::equal());
    for (i, direction) in directions.iter_mut().enumerate() {
        let whole = sizes.normalise(&mut direction.clone());
        let part = units.normalise(direction);
        terms.as_mut_slice()[i] = part;
        digits.entries()[i] = if part.magnitude() > 0.0 { whole / part } else { zero() };
    }
    // Simplified Newton for the multipliers: at y, with the gradients that are there already.
    let triangle = orthonormalise::<I::Values, S::Phase>(directions);
    let back = |multipliers: &I::Values| {
        let mut back = S::Phase::zero();
        for (multiplier, direction) in multipliers.as_slice().iter().zip(&*directions) {
            back.add_scaled(*multiplier, direction);
        }
        units.multiply(&mut back);
        back
    };
    // The increments at whose end conditions of the energy were decided last.
    let decided = Cell::new(*moved);
    let residual = |multipliers: &I::Values| {
        let change = sum(moved, &back(multipliers));
        decided.set(change);
        let mut changes = invariants.changes(system, before, &change);
        for (change, terms) in changes.as_mut_slice().iter_mut().zip(terms.as_slice()) {
            // Also where gradients vanish there may be nothing to do.
            *change = if change.magnitude() == 0.0 { *change } else { *change / *terms };
        }
        changes
    };
    // A correction that does not shrink may be one from side to side of a jump.
    let jumps = I::KEEP_ENERGY && !S::JUMPS.is_empty();
    let is_noise = |multipliers: &I::Values, delta: &I::Values, farther: f64| {
        !jumps && {
            let correction = |at: &I::Values| {
                let mut delta = residual(at);
                along(&triangle, &digits, &mut delta);
                delta
            };
            let kinds = [I::Values::LEN, 1];
            let noise = noise::measure(&digits, multipliers, (delta, farther), kinds, |at| Some(correction(at)));
            // A coordinate that is rounded otherwise moves both ends of the step, and the gradient may vanish at one of them.
            let mut digits = digits;
            let mut gradients = invariants.gradients(system, before);
            for (i, gradient) in I::Values::entries(&mut gradients).iter_mut().enumerate() {
                let start = sizes.normalise(gradient);
                if terms.as_slice()[i].magnitude() > 0.0 {
                    digits.entries()[i] += start / terms.as_slice()[i];
                }
            }
            noise::explains(&noise, &correction(multipliers), &digits)
        }
    };
    let multipliers = correct(I::Values::zero(), is_noise, |multipliers| {
        let mut delta = residual(multipliers);
        let relative = along(&triangle, &digits, &mut delta);
        Ok((delta, relative))
    })?;
    Ok(WayBack { back: back(&multipliers), decided: decided.get() })
}

/// Makes directions orthonormal, by Gram's and Schmidt's method, each twice; the triangle that takes them back to what they were.
///
/// Directions that agree to √ε with those before them are zero then, and so are their rows: the functions that they are gradients of differ by
/// less than rounding from functions of the others.
fn orthonormalise<A: Array, Z: Array<Real = A::Real>>(directions: &mut [Z]) -> Square<A> {
    let mut triangle = A::fill(A::zero());
    for (i, row) in A::entries::<A>(&mut triangle).iter_mut().enumerate() {
        let (before, rest) = directions.split_at_mut(i);
        let direction = &mut rest[0];
        let length = dot(direction, direction).sqrt();
        let row = row.as_mut_slice();
        for (j, other) in before.iter().enumerate().chain(before.iter().enumerate()) {
            let part = dot(direction, other);
            row[j] += part;
            direction.add_scaled(-part, other);
        }
        let left = dot(direction, direction).sqrt();
        // What is not a number stays so.
        let agrees = left.magnitude() <= length.magnitude() * A::Real::epsilon().sqrt();
        for x in direction.as_mut_slice() {
            *x = if agrees { zero() } else { *x / left };
        }
        row[i] = if agrees { zero() } else { left };
    }
    triangle
}

/// From changes of functions to multipliers of orthonormal directions; the largest change of those that have a direction, relative to `digits`.
fn along<A: Array>(triangle: &Square<A>, digits: &Sizes<A>, changes: &mut A) -> f64 {
    let mut greatest = 0.0_f64;
    for (i, row) in A::entries_of::<A>(triangle).iter().enumerate() {
        let (row, changes) = (row.as_slice(), changes.as_mut_slice());
        if row[i].magnitude() == 0.0 {
            changes[i] = zero();
            continue;
        }
        // Not `max`: that would lose what is not a number.
        let change = changes[i].magnitude() / digits.of(i);
        greatest = if change <= greatest { greatest } else { change };
        for j in 0..i {
            changes[i] -= row[j] * changes[j];
        }
        changes[i] /= row[i];
    }
    greatest
}

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
/// The order of the method; invariants are kept to rounding, also where their gradients depend on each other, as those of energy and momentum
/// do on a circle. Neither symmetric nor symplectic: what is not projected onto drifts, even the momentum of a cyclic coordinate. The way
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

/// The way back from the end of a step by `moved`: by simplified Newton's iteration for the multipliers, at that end, with the gradients there. On a
/// circular orbit, or any on which an invariant is as small as others allow, gradients depend on each other: near it the directions turn as fast
/// as the distance shrinks, and are asked for anew at each point.
pub(super) fn way_back<S: VectorField<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    scales: &Scales<S::Phase>,
    [before, end]: [&S::Phase; 2],
    moved: &S::Phase,
) -> Result<WayBack<S::Phase>, Refusal> {
    // The increments at whose end conditions of the energy were decided last.
    let decided = Cell::new(*moved);
    let changes = |increment: &S::Phase| {
        decided.set(*increment);
        invariants.changes(system, before, increment)
    };
    let frame = |at: &S::Phase| Frame::<I::Values, S::Phase>::new(invariants.gradients(system, at), scales);
    let at_end = frame(end);
    // A correction that does not shrink may be one from side to side of a jump.
    let jumps = I::KEEP_ENERGY && !S::JUMPS.is_empty();
    let correction = |multipliers: &I::Values| {
        let mut delta = changes(&sum(moved, &at_end.back(multipliers)));
        let relative = at_end.multipliers(&mut delta);
        (delta, relative)
    };
    let is_noise = |multipliers: &I::Values, delta: &I::Values, farther: f64| {
        let rounding = |multipliers: &I::Values| Some(correction(multipliers).0);
        !jumps && {
            let kinds = [I::Values::LEN, 1];
            let noise = noise::measure(&at_end.digits, multipliers, (delta, farther), kinds, rounding);
            // A coordinate that is rounded otherwise moves both ends of the step, and the gradient may vanish at one of them.
            let digits = at_end.digits_with(invariants.gradients(system, before), scales);
            noise::explains(&noise, &correction(multipliers).0, &digits)
        }
    };
    let turning = |increment: &S::Phase| {
        let (frame, mut delta) = (frame(&sum(before, increment)), changes(increment));
        let relative = frame.multipliers(&mut delta);
        (frame.back(&delta), relative)
    };
    let back = match correct(I::Values::zero(), is_noise, |multipliers| Ok(correction(multipliers))) {
        Ok(multipliers) => at_end.back(&multipliers),
        Err(refusal) => {
            let end = correct(*moved, |_, _, _| false, |increment| Ok(turning(increment)));
            difference(&end.map_err(|_| refusal)?, moved)
        }
    };
    Ok(WayBack { back, decided: decided.get() })
}

/// The directions in which invariants change at a point.
struct Frame<A: Array, Z: Array<Real = A::Real>> {
    units: Sizes<Z>,
    /// D∇I, orthonormal, and the triangle that takes them back to what they were.
    directions: A::Map<Z>,
    triangle: Square<A>,
    /// The sum of the magnitudes of the entries of D∇I, by which it is divided.
    terms: A,
    /// By ε times the same sum over sizes, in units of those terms, rounding changes an invariant.
    digits: Sizes<A>,
}

impl<A: Array, Z: Array<Real = A::Real>> Frame<A, Z> {
    fn new(mut gradients: A::Map<Z>, scales: &Scales<Z>) -> Self {
        let units = scales.units();
        let (mut terms, mut digits) = (A::zero(), Sizes::equal());
        for (i, direction) in A::entries(&mut gradients).iter_mut().enumerate() {
            let whole = scales.sizes.normalise(&mut direction.clone());
            let part = units.normalise(direction);
            terms.as_mut_slice()[i] = part;
            digits.entries()[i] = if part.magnitude() > 0.0 { whole / part } else { zero() };
        }
        let triangle = orthonormalise::<A, Z>(A::entries(&mut gradients));
        Frame { units, directions: gradients, triangle, terms, digits }
    }

    /// The digits, with what rounding changes where the gradients are these.
    fn digits_with(&self, mut gradients: A::Map<Z>, scales: &Scales<Z>) -> Sizes<A> {
        let mut digits = self.digits;
        for (i, gradient) in A::entries(&mut gradients).iter_mut().enumerate() {
            let whole = scales.sizes.normalise(gradient);
            if self.terms.as_slice()[i].magnitude() > 0.0 {
                digits.entries()[i] += whole / self.terms.as_slice()[i];
            }
        }
        digits
    }

    /// Σ λᵢ D²∇Iᵢ.
    fn back(&self, multipliers: &A) -> Z {
        let mut back = Z::zero();
        for (multiplier, direction) in multipliers.as_slice().iter().zip(A::entries_of(&self.directions)) {
            back.add_scaled(*multiplier, direction);
        }
        self.units.multiply(&mut back);
        back
    }

    /// From changes of invariants to the multipliers that cause them; the largest change, relative to what rounding changes.
    fn multipliers(&self, changes: &mut A) -> f64 {
        for (change, terms) in changes.as_mut_slice().iter_mut().zip(self.terms.as_slice()) {
            // Also where gradients vanish there may be nothing to do.
            *change = if change.magnitude() == 0.0 { *change } else { *change / *terms };
        }
        along(&self.triangle, &self.digits, changes)
    }
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

/// From changes of functions to multipliers of orthonormal directions; the largest change relative to `digits`. Of functions that have no direction
/// of their own it is what others do not change with them: nothing can be done about that.
fn along<A: Array>(triangle: &Square<A>, digits: &Sizes<A>, changes: &mut A) -> f64 {
    let mut greatest = 0.0_f64;
    for (i, row) in A::entries_of::<A>(triangle).iter().enumerate() {
        let (row, changes) = (row.as_slice(), changes.as_mut_slice());
        let (whole, mut rest) = (changes[i], changes[i]);
        for j in 0..i {
            rest -= row[j] * changes[j];
        }
        let has_direction = row[i].magnitude() != 0.0;
        let change = if has_direction { whole.magnitude() } else { rest.magnitude() };
        let change = if change == 0.0 { change } else { change / digits.of(i) };
        // Not `max`: that would lose what is not a number.
        greatest = if change <= greatest { greatest } else { change };
        changes[i] = if has_direction { rest / row[i] } else { zero() };
    }
    greatest
}

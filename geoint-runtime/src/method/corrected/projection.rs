//! x₁ = y + Σ λᵢ D²∇Iᵢ(y): a step of any method, and back to where the invariants were. If that fails, the gradients are those at each iterate.

use super::frame::Frame;
use super::range::is_representable;
use super::scales::{Scales, part_of_rounding, rounding};
use super::turns::check_turns;
use super::{kept, rounded};
use crate::method::corrected::invariants::Invariants;
use crate::method::{And, Claims, Method, Name, Probe, Refusal, Step, check_conditions, check_poles, outer_step};
use crate::scalar::Real;
use crate::solving::noise;
use crate::solving::rounding::correct;
use crate::solving::size::Sizes;
use crate::space::vector::{difference, sum};
use crate::space::{Array, Compensated, Record, Summation, Tape};
use crate::system::{Poles, VectorField};
use core::cell::Cell;

/// A method, and the invariants that each of its steps is projected onto: `Projection(RK4, Energy)`.
///
/// The order of the method; invariants are kept to rounding, also where their gradients depend on each other, as those of energy and momentum
/// do on a circle. The method is neither symmetric nor symplectic: other invariants drift, even the momentum of a cyclic coordinate.
///
/// The correction is the shortest one, where each coordinate has a unit D:
///
/// - D is the largest recent magnitude of the coordinate,
/// - but at most 1024 times its recent increment: the distance of an angle from zero means nothing after many turns,
/// - and at least so large that a coordinate takes the corrections which its own rounding explains.
///
/// The correction does not depend on the units of q and p, and a coordinate that has always been zero stays zero.
///
/// An angle `atan2(y, x)` in an invariant is followed across its cut. Errors: [`StepError::Turned`](crate::StepError::Turned) if the angle moves by
/// more than half a turn in a step, and [`StepError::OutOfRange`](crate::StepError::OutOfRange) if an invariant underflows or overflows.
///
/// E. Hairer, Ch. Lubich & G. Wanner, *Geometric Numerical Integration* (2006), section IV.4, algorithm 4.2.
///
/// Taylor series are projected, too: `system.taylor(Projection(Taylor { tolerance: 1e-8 }, Energy), state)`. Each step is led back to the
/// values of the invariants at the start of the run, so that neither errors of the series nor roundings add up. States between the ends of steps are
/// those of the series.
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
pub struct Prepared<P, I> {
    method: P,
    poles: Poles,
    invariants: I,
}

impl<S: VectorField<R>, R: Real, M: Method<S, R>, I: Invariants<S, R>> Method<S, R> for Projection<M, I> {
    type Proof = <M::Proof as And<I::Values>>::Both;
    type Prepared = Prepared<M::Prepared, I>;
    type Memory = Memory<M::Memory, S::Phase>;
    const SCALES_STEPS: bool = M::SCALES_STEPS;
    const KEEPS: bool = I::Values::LEN > 0;

    #[inline]
    fn way_back(prepared: &Self::Prepared, system: &S, origin: &S::Phase, z: &S::Phase) -> S::Phase {
        kept::way_back(system, &prepared.invariants, origin, z)
    }

    #[inline]
    fn is_in_range(prepared: &Self::Prepared, system: &S, z: &S::Phase) -> bool {
        M::is_in_range(&prepared.method, system, z) && is_representable(system, &prepared.invariants, z)
    }

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
        Prepared { method: self.0.prepare(system, h), poles: Poles::of(system), invariants: self.1 }
    }

    fn memory() -> Self::Memory {
        Memory { method: M::memory(), scales: Scales::new(), sums: Compensated::new() }
    }

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { method, poles, invariants }: &Self::Prepared,
        memory: &mut Self::Memory,
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let Memory { method: memory, scales, sums } = memory;
        let before = step.x.z;
        outer_step::<S, R, M, C, P>(method, memory, step.part([step.t, step.end]))?;
        let Step { system, t, end: later, x, probe } = step;
        probe.visit(t, &x.z, &());
        let moved = difference(&x.z, &before);
        scales.include(&before, &moved);

        let end = x.z;
        check_turns(system, [t, later - t], [&before, &end])?;
        let way = way_back(system, invariants, &I::Values::zero(), scales, [&before, &end])?;
        x.correct(sums, &before, &moved, &way.back);
        if I::KEEP_ENERGY {
            check_conditions(system, t, &sum(&before, &way.decided), x)?;
        }
        check_poles(poles, false, &(before, ()), Step::at(t, (system, &mut *x, probe)))?;
        rounded::check_correction(system, [t, later], invariants, [&before, &end, &x.z])
    }
}

/// An invariant whose terms are larger by this factor than in the units of a correction reads a coordinate far from zero.
const FAR: f64 = 8.0;

/// Returns the largest change of such an invariant, as a part of its terms, that may be rounding. Where large forces cancel, the change may be many
/// roundings of the terms that are known here. The bound √ε/16 is empirical.
fn cancelling<R: Real>() -> f64 {
    R::epsilon().sqrt() / 16.0
}

/// From the end of a step to where the invariants are what they were.
pub(super) struct WayBack<Z> {
    pub(super) back: Z,
    /// The increment of the step at whose end conditions of the energy were decided last.
    decided: Z,
}

/// Returns the way from `end` to where the invariants have changed by `wanted` since `before`.
///
/// A simplified Newton iteration finds the multipliers, with the gradients at that end. On a circular orbit, or on any other orbit on which an
/// invariant is as small as others allow, gradients depend on each other. Near such an orbit the gradients turn as fast as the iteration converges. If
/// the simplified iteration fails, the gradients are therefore evaluated at each point.
#[inline(always)]
pub(super) fn way_back<S: VectorField<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    wanted: &I::Values,
    scales: &Scales<S::Phase>,
    [before, end]: [&S::Phase; 2],
) -> Result<WayBack<S::Phase>, Refusal> {
    let moved = &difference(end, before);
    // Coordinates are rounded as they are on the way of this step: what was large lately is exact now.
    let mut sizes = Sizes::new();
    sizes.include(before, moved);
    // The increments at whose end conditions of the energy were decided last.
    let decided = Cell::new(*moved);
    let changes = |increment: &S::Phase| {
        decided.set(*increment);
        difference(&invariants.changes(system, before, increment), wanted)
    };
    let gradients = invariants.gradients(system, end);
    let explained = || explained_by_rounding(system, invariants, wanted, &gradients, [before, moved], &sizes);
    let units = scales.units(explained);
    let at_end = Frame::<I::Values, S::Phase>::new(gradients, units, &sizes);
    let frame = |at: &S::Phase| Frame::<I::Values, S::Phase>::new(invariants.gradients(system, at), units, &sizes);
    // Where the energy jumps, corrections from side to side do not shrink. Nothing is taken for noise then.
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
            // Rounding of a coordinate changes the invariant at both ends of the step. The gradient at the end alone may vanish.
            let digits = at_end.digits_with(invariants.gradients(system, before), &sizes);
            let left = correction(multipliers).0;
            // Noise is measured by shifts of coordinates. For an angle of many turns a shift shows the curvature of the cosine, which is no
            // noise. So the change has to be small, too.
            let is_small = |i: usize| {
                let turns_often = at_end.digits.of(i) > FAR;
                !turns_often || left.as_slice()[i].magnitude() <= cancelling::<R>() * digits.of(i)
            };
            (0..I::Values::LEN).all(is_small) && noise::explains(&noise, &left, &digits)
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

/// Returns for each coordinate the part of the correction that rounding explains. For an invariant it is the rounding of its terms relative to its change,
/// at most 1; for a coordinate it is the least part of the invariants that read it.
///
/// The gradient is also evaluated at a point as far away as the correction may lead. If a slope is another one there, the part is zero: a slope that
/// nearly vanishes would ask for a correction far away.
#[cold]
#[inline(never)]
fn explained_by_rounding<S: VectorField<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    wanted: &I::Values,
    gradients: &<I::Values as Array>::Map<S::Phase>,
    [before, moved]: [&S::Phase; 2],
    sizes: &Sizes<S::Phase>,
) -> S::Phase {
    let changes = difference(&invariants.changes(system, before, moved), wanted);
    let gradients = I::Values::entries_of(gradients);
    let mut parts = changes;
    for (part, gradient) in parts.as_mut_slice().iter_mut().zip(gradients) {
        *part = R::from_f64(part_of_rounding(*part, sizes.terms(gradient)));
    }
    let least = parts.as_slice().iter().fold(1.0, |least, part| part.magnitude().min(least));
    let mut beside = invariants.gradients(system, &sizes.beside(&sum(before, moved), rounding::<R>() / least));
    let slopes = gradients.iter().zip(I::Values::entries(&mut beside));
    let mut explained = S::Phase::zero();
    explained.as_mut_slice().fill(R::from_f64(1.0));
    for (part, (gradient, beside)) in parts.as_slice().iter().zip(slopes) {
        let slopes = gradient.as_slice().iter().zip(beside.as_slice());
        for (least, (slope, beside)) in explained.as_mut_slice().iter_mut().zip(slopes) {
            let is_linear = (*beside - *slope).magnitude() <= 0.5 * slope.magnitude();
            let part = if is_linear { *part } else { R::from_f64(0.0) };
            if slope.magnitude() > 0.0 && part.magnitude() < least.magnitude() {
                *least = part;
            }
        }
    }
    explained
}

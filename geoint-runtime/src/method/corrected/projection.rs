//! x₁ = y + Σ λᵢ D²∇Iᵢ(y): a step of any method, and back to where the invariants were. If that fails, the gradients are those at each iterate.

use super::range::is_representable;
use super::scales::Scales;
use super::turns::check_turns;
use super::way_back::way_back;
use super::{kept, rounded};
use crate::method::corrected::invariants::Invariants;
use crate::method::{And, Claims, Method, Name, Probe, Refusal, Step, check_conditions, check_poles, outer_step};
use crate::scalar::Real;
use crate::space::vector::{difference, sum};
use crate::space::{Array, Compensated, Record, Summation, Tape};
use crate::system::{Evaluations, Poles, VectorField};

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
/// more than half a turn in a step, [`StepError::LedAstray`](crate::StepError::LedAstray) if a correction is longer than half of the step, and
/// [`StepError::OutOfRange`](crate::StepError::OutOfRange) if an invariant underflows or overflows. A step of an explicit method that is far too large
/// may end near another part of the surface of constant invariants, on which it is kept then.
///
/// E. Hairer, Ch. Lubich & G. Wanner, *Geometric Numerical Integration* (2006), section IV.4, algorithm 4.2.
///
/// Taylor series are projected, too: `system.taylor(Projection(Taylor { tolerance: 1e-8 }, Energy), state)`. Each step is led back to the
/// values of the invariants at the start of the run, so that neither errors of the series nor roundings add up. States between the ends of steps are
/// those of the series.
#[doc(alias("manifold projection", "standard projection"))]
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
        check_poles(poles, Evaluations::AtPoints, &(before, ()), Step::at(t, (system, &mut *x, probe)))?;
        rounded::check_correction(system, [t, later], invariants, [&before, &end, &x.z])
    }
}

//! Projection onto invariants: x₁ = y + Σ λᵢ D²∇Iᵢ(y), where y is the result of a step of any method. The multipliers λᵢ restore the invariants.
//! If this fails, Newton's iteration uses the gradients at each iterate.

use super::range::is_representable;
use super::scales::Scales;
use super::turns::check_turns;
use super::way_back::way_back;
use super::{kept, rounded};
use crate::method::corrected::invariants::Invariants;
use crate::method::{
    And, Claims, Failure, Handling, Method, Name, Probe, Step, check_conditions, check_poles, outer_step,
};
use crate::scalar::Real;
use crate::space::vector::{difference, sum};
use crate::space::{Array, Compensated, Record, Summation, Tape};
use crate::system::{Evaluations, Poles, VectorField};

/// A method, and the invariants that each of its steps is projected onto: `Projection(RK4, Energy)`.
///
/// The order is that of the method. Invariants are kept to rounding. This holds also if their gradients depend on each other, like those of energy
/// and angular momentum on a circular orbit. The method is neither symmetric nor symplectic. Other invariants drift, even the momentum of a cyclic
/// coordinate.
///
/// The correction is the shortest one if each coordinate is measured in its unit D:
///
/// - D is the largest recent magnitude of the coordinate,
/// - but at most 1024 times its recent increment, because the value of an angle means nothing after many turns,
/// - and at least large enough for the corrections that the coordinate's own rounding explains.
///
/// The correction does not depend on the units of q and p, and a coordinate that has always been zero stays zero.
///
/// An angle `atan2(y, x)` in an invariant is continued across its cut. Limit: a far too large step of an explicit method may end near another part of
/// the surface of constant invariants. Later steps then stay on that part.
///
/// # Errors
/// - [`Failure::Turned`] if such an angle moves by more than half a turn in a step.
/// - [`Failure::LedAstray`] if a correction is longer than half of the step.
/// - [`Failure::OutOfRange`] if an invariant underflows or overflows.
///
/// # Source
///
/// E. Hairer, Ch. Lubich & G. Wanner, *Geometric Numerical Integration* (2006), section IV.4, algorithm 4.2.
///
/// # Taylor series
/// Write `system.taylor(Projection(Taylor { tolerance: 1e-8 }, Energy), state)`. Each step is projected to the values of the invariants at the start of
/// the run, so neither truncation nor rounding errors add up. States between the ends of steps come from the series without projection.
#[doc(alias("manifold projection", "standard projection"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Projection<M, I>(pub M, pub I);

/// Data that a step passes to the next one.
#[derive(Clone, Copy, Debug)]
pub struct Memory<M, A: Array> {
    method: M,
    scales: Scales<A>,
    /// Compensated sums: corrections may be smaller than the last digit of a coordinate, and all of one sign.
    sums: Compensated<A>,
}

impl<M: Record<A::Real>, A: Array> Record<A::Real> for Memory<M, A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.method.record(tape);
        self.scales.record(tape);
        self.sums.record(tape);
    }
}

/// Coefficients of the method, the poles of the system, and the invariants.
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
    const HANDLING: Handling =
        Handling { scales_steps: M::HANDLING.scales_steps, keeps_invariants: I::Values::LEN > 0, ..Handling::PLAIN };

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
            conserves_energy: I::ORIGIN.keeps_energy(),
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

    fn memory(z: &S::Phase) -> Self::Memory {
        Memory { method: M::memory(z), scales: Scales::new(), sums: Compensated::new() }
    }

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { method, poles, invariants }: &Self::Prepared,
        memory: &mut Self::Memory,
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
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
        if I::ORIGIN.keeps_energy() {
            check_conditions(system, t, &sum(&before, &way.decided), x)?;
        }
        check_poles(poles, Evaluations::AtPoints, &(before, ()), Step::at(t, (system, &mut *x, probe)))?;
        rounded::check_correction(system, [t, later], invariants, [&before, &end, &x.z])
    }
}

//! Steps by Taylor series, projected to invariants.
//!
//! Every step is led back to the invariants at the start of the run, so that errors do not add up from step to step. The reference is a stored state, the
//! origin. If rounding dominates the change since the origin, the last state becomes the new origin, and the error that is left there is remembered. If
//! an invariant reads an angle (`atan2`), only the sum over all steps knows its change: each step then corrects the errors of the steps before.

use super::invariants::Invariants;
use super::projection::Projection;
use super::range::is_representable;
use super::rounded::check_correction;
use super::scales::Scales;
use super::turns::check_turns;
use super::way_back::way_back;
use crate::method::Refusal;
use crate::scalar::Real;
use crate::sealed::Sealed;
use crate::solving::size::Sizes;
use crate::space::vector::{difference, sum};
use crate::space::{Array, PerCoordinate, Record, Tape};
use crate::system::{Jets, VectorField};
use crate::taylor::{Steps, TaylorMethod};
use core::fmt::Debug;

impl<M: Sealed, I> Sealed for Projection<M, I> {}

/// The memory of a projected step.
#[derive(Clone, Copy, Debug)]
pub struct Memory<A, V> {
    scales: Scales<A>,
    /// The start of the run, or a later point if rounding decides the changes since the start. Changes are those since the origin, because rounding would
    /// add up from step to step.
    origin: A,
    /// Whether changes since the origin are summed over the steps. After a full turn an angle is back at the origin, so only the sum over steps knows
    /// its change.
    summed: bool,
    /// The changes since the origin, or in the next step if changes are summed, that lead back to the invariants at the start of the run.
    wanted: V,
}

impl<A: Array, V: Array<Real = A::Real>> Record<A::Real> for Memory<A, V> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.scales.record(tape);
        tape.array(&mut self.origin);
        tape.flag(&mut self.summed);
        tape.array(&mut self.wanted);
    }
}

/// A change since the origin that differs from the sum over the steps by more than this many ε of its terms contains a turn.
const TURN: f64 = 1024.0;

impl<A: Array, V: Array<Real = A::Real>> Memory<A, V> {
    /// Returns whether the change of an invariant from the origin to `z` differs from the sum over the steps.
    fn has_turned<S: VectorField<R, Phase = A>, R: Real, I: Invariants<S, R, Values = V>>(
        &self,
        system: &S,
        invariants: &I,
        [before, z]: [&A; 2],
    ) -> bool {
        let since = |from: &A| invariants.changes(system, from, &difference(z, from));
        let apart = difference(&since(&self.origin), &since(before));
        let mut sizes = Sizes::new();
        sizes.include(&self.origin, &difference(z, &self.origin));
        let gradients = [before, z].map(|z| invariants.gradients(system, z));
        let [first, last] = gradients.each_ref().map(V::entries_of);
        let terms = first.iter().zip(last).map(|(first, last)| sizes.terms(first) + sizes.terms(last));
        apart.as_slice().iter().zip(terms).any(|(apart, terms)| apart.magnitude() > TURN * R::epsilon() * terms)
    }
}

/// Returns the change of each invariant from one point to another.
///
/// The increment between the points is rounded by ε times the larger of both. This error matters least if the increment starts at the point at which the
/// invariant is steeper.
fn changes_from_steep_end<S: VectorField<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    from: &S::Phase,
    to: &S::Phase,
) -> I::Values {
    let mut sizes = Sizes::at(from);
    sizes.include(&S::Phase::zero(), to);
    let gradients = [from, to].map(|z| invariants.gradients(system, z));
    let [first, last] = gradients.each_ref().map(I::Values::entries_of);
    let mut changes = invariants.changes(system, from, &difference(to, from));
    let back = invariants.changes(system, to, &difference(from, to));
    for (i, change) in changes.as_mut_slice().iter_mut().enumerate() {
        if sizes.terms(&last[i]) > sizes.terms(&first[i]) {
            *change = -back.as_slice()[i];
        }
    }
    changes
}

impl<S, R, M, I> TaylorMethod<S, R> for Projection<M, I>
where
    S: Jets<R, Action = ()> + VectorField<R>,
    R: Real,
    M: TaylorMethod<S, R>,
    I: Invariants<S, R> + Debug,
{
    type Orders<X: Copy + Debug> = M::Orders<X>;
    type Series = M::Series;
    type Memory = Memory<S::Phase, I::Values>;

    #[inline(always)]
    fn steps(&self) -> Steps {
        self.0.steps()
    }
    #[inline(always)]
    fn order(&self) -> usize {
        self.0.order()
    }
    fn memory(origin: &S::Phase) -> Self::Memory {
        Memory { scales: Scales::new(), origin: *origin, summed: S::ANGLES, wanted: I::Values::zero() }
    }
    #[inline]
    fn correction(
        &self,
        memory: &mut Self::Memory,
        system: &S,
        time: [R; 2],
        [before, z]: [&S::Phase; 2],
    ) -> Result<Option<S::Phase>, Refusal> {
        memory.scales.include(before, &difference(z, before));
        let is_first = difference(&memory.origin, before).as_slice().iter().all(|moved| moved.magnitude() == 0.0);
        if is_first && !is_representable(system, &self.1, before) {
            return Err(Refusal::OutOfRange);
        }
        check_turns(system, time, [before, z])?;
        if !memory.summed && !I::DERIVED && memory.has_turned(system, &self.1, [before, z]) {
            // The step before has been led back to the invariants of the start.
            (memory.summed, memory.wanted) = (true, I::Values::zero());
        }
        let Memory { scales, origin, summed, wanted } = memory;
        let ends_in_time = [time[0], time[0] + time[1]];
        let back = |from: &S::Phase, wanted: &I::Values| {
            let back = way_back(system, &self.1, wanted, scales, [from, z])?.back;
            check_correction(system, ends_in_time, &self.1, [from, z, &sum(z, &back)]).map(|()| back)
        };
        if *summed {
            let back = back(before, wanted)?;
            let moved = difference(&sum(z, &back), before);
            *wanted = difference(wanted, &self.1.changes(system, before, &moved));
            return Ok(Some(back));
        }
        let way = match back(origin, wanted) {
            // Rounding dominates the change since the origin. `before` is the new origin, and `wanted` keeps the error that is left there.
            Err(Refusal::Rounded) => {
                *wanted = difference(wanted, &changes_from_steep_end(system, &self.1, origin, before));
                *origin = *before;
                back(before, wanted)
            }
            way => way,
        };
        way.map(Some)
    }
    fn series(coefficient: impl FnMut(usize) -> R) -> M::Series {
        M::series(coefficient)
    }
    fn coefficients(series: &M::Series) -> &[R] {
        M::coefficients(series)
    }
    fn fill<X: Copy + Debug>(x: X) -> M::Orders<X> {
        M::fill(x)
    }
    #[inline]
    fn jet(
        order: usize,
        system: &S,
        start: [R; 2],
        x: (&S::Phase, &S::Action),
        jet: &mut M::Orders<PerCoordinate<S::Phase, S::Action>>,
        switches: &mut M::Orders<S::Switches>,
    ) {
        M::jet(order, system, start, x, jet, switches);
    }
}

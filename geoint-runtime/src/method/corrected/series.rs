//! Steps by Taylor series, projected to invariants.
//!
//! Every step is projected to the invariants at the start of the run, so that errors do not add up from step to step. A stored state, the reference,
//! represents the start. The reference is replaced in two cases. The remaining error at the new reference is then stored:
//!
//! - Rounding dominates the change of an invariant since the reference. The start of the step becomes the reference.
//! - An invariant reads an angle (`atan2`). After a full turn the angle has its old value, so the change since an old state is not known. Every step
//!   then has its own start as reference.

use super::invariants::Invariants;
use super::projection::Projection;
use super::range::is_representable;
use super::rounded::check_correction;
use super::scales::Scales;
use super::turns::check_turns;
use super::way_back::way_back;
use crate::method::Failure;
use crate::scalar::Real;
use crate::sealed::Sealed;
use crate::solving::size::Sizes;
use crate::space::vector::{difference, sum};
use crate::space::{Array, PerCoordinate, Record, Tape};
use crate::system::{Jets, Origin, VectorField};
use crate::taylor::{Steps, TaylorMethod};
use core::fmt::Debug;

impl<M: Sealed, I> Sealed for Projection<M, I> {}

/// Data that a projected step passes to the next one.
#[derive(Clone, Copy, Debug)]
pub struct Memory<A, V> {
    scales: Scales<A>,
    /// The state to which changes of the invariants refer.
    reference: A,
    /// The changes since the reference that restore the invariants at the start of the run.
    wanted: V,
    /// Whether the start of every step becomes the reference.
    moves_on: bool,
}

impl<A: Array, V: Array<Real = A::Real>> Record<A::Real> for Memory<A, V> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.scales.record(tape);
        tape.array(&mut self.reference);
        tape.array(&mut self.wanted);
        tape.flag(&mut self.moves_on);
    }
}

/// The previous step was projected. Thus an invariant has changed by the same amount since the start of this step and since the reference. If the two
/// amounts differ by more than this many ε of the invariant's terms, an angle has made a full turn. Rounding is much smaller.
const TURN: f64 = 1024.0;

impl<A: Array, V: Array<Real = A::Real>> Memory<A, V> {
    /// Returns whether an angle in an invariant has made a full turn between the reference and `z`, the end of a step from `before`.
    fn has_turned<S: VectorField<R, Phase = A>, R: Real, I: Invariants<S, R, Values = V>>(
        &self,
        system: &S,
        invariants: &I,
        [before, z]: [&A; 2],
    ) -> bool {
        let since = |from: &A| invariants.changes(system, from, &difference(z, from));
        let apart = difference(&since(&self.reference), &since(before));
        let sizes = Sizes::along([&self.reference, &difference(z, &self.reference)]);
        let gradients = [before, z].map(|z| invariants.gradients(system, z));
        let [first, last] = gradients.each_ref().map(V::entries_of);
        let terms = first.iter().zip(last).map(|(first, last)| sizes.terms(first) + sizes.terms(last));
        apart.as_slice().iter().zip(terms).any(|(apart, terms)| apart.magnitude() > TURN * R::epsilon() * terms)
    }
}

/// Returns the change of each invariant from one point to another.
///
/// The function `changes` takes one point exactly, and the other one as an increment, which is rounded. The exact point is here the one at which the invariant
/// is steeper, because the same rounding changes the invariant more there.
fn changes_from_steep_end<S: VectorField<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    from: &S::Phase,
    to: &S::Phase,
) -> I::Values {
    let sizes = Sizes::along([from, to]);
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
    fn memory(start: &S::Phase) -> Self::Memory {
        Memory { scales: Scales::new(), reference: *start, wanted: I::Values::zero(), moves_on: S::ANGLES }
    }
    #[inline]
    fn correction(
        &self,
        memory: &mut Self::Memory,
        system: &S,
        [t, h]: [R; 2],
        [before, z]: [&S::Phase; 2],
    ) -> Result<Option<S::Phase>, Failure> {
        memory.scales.include(before, &difference(z, before));
        // The first step after the reference, or an orbit that has returned to it.
        let at_reference =
            difference(&memory.reference, before).as_slice().iter().all(|moved| moved.magnitude() == 0.0);
        if at_reference && !is_representable(system, &self.1, before) {
            return Err(Failure::OutOfRange);
        }
        check_turns(system, [t, h], [before, z])?;
        // `S::ANGLES` covers the invariants that are derived. Those implemented by hand may read an angle, too.
        if !memory.moves_on && !matches!(I::ORIGIN, Origin::Derived) && memory.has_turned(system, &self.1, [before, z])
        {
            // The previous step was projected to the invariants of the start, so the wanted change since then is zero.
            (memory.wanted, memory.moves_on) = (I::Values::zero(), true);
        }
        let Memory { scales, reference, wanted, moves_on } = memory;
        if *moves_on {
            *reference = *before;
        }
        let back = |reference: &S::Phase, wanted: &I::Values| {
            let back = way_back(system, &self.1, wanted, scales, [reference, z])?.back;
            check_correction(system, [t, t + h], &self.1, [reference, z, &sum(z, &back)]).map(|()| back)
        };
        let way = match back(reference, wanted) {
            Err(Failure::Rounded) if !*moves_on => {
                *wanted = difference(wanted, &changes_from_steep_end(system, &self.1, reference, before));
                *reference = *before;
                back(reference, wanted)?
            }
            way => way?,
        };
        if *moves_on {
            let moved = difference(&sum(z, &way), reference);
            *wanted = difference(wanted, &self.1.changes(system, reference, &moved));
        }
        Ok(Some(way))
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

//! Steps by Taylor series, projected to invariants.

use super::invariants::Invariants;
use super::projection::{Projection, way_back};
use super::rounded::check_correction;
use super::scales::Scales;
use crate::method::Refusal;
use crate::scalar::Real;
use crate::sealed::Sealed;
use crate::space::vector::{difference, sum};
use crate::space::{Array, PerCoordinate, Record, Tape};
use crate::system::{Jets, VectorField};
use crate::taylor::{Steps, TaylorMethod};
use core::fmt::Debug;

impl<M: Sealed, I> Sealed for Projection<M, I> {}

/// What a projected step hands on to the next one.
#[derive(Clone, Copy, Debug)]
pub struct Memory<A> {
    scales: Scales<A>,
    /// Where the run began, as long as rounding does not decide what has changed since. Steps are long: each is projected to what invariants were there,
    /// because rounding would add up from step to step.
    origin: A,
}

impl<A: Array> Record<A::Real> for Memory<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.scales.record(tape);
        tape.array(&mut self.origin);
    }
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
    type Memory = Memory<S::Phase>;

    #[inline(always)]
    fn steps(&self) -> Steps {
        self.0.steps()
    }
    #[inline(always)]
    fn order(&self) -> usize {
        self.0.order()
    }
    fn memory(origin: &S::Phase) -> Memory<S::Phase> {
        Memory { scales: Scales::new(), origin: *origin }
    }
    #[inline]
    fn correction(
        &self,
        Memory { scales, origin }: &mut Memory<S::Phase>,
        system: &S,
        before: &S::Phase,
        z: &S::Phase,
    ) -> Result<Option<S::Phase>, Refusal> {
        scales.include(before, &difference(z, before));
        let back = |from: &S::Phase| {
            let back = way_back(system, &self.1, scales, [from, z], &difference(z, from))?.back;
            check_correction(system, &self.1, [from, z, &sum(z, &back)]).map(|()| back)
        };
        let way = match back(origin) {
            // So far from there that rounding decides what has changed: from here on, then.
            Err(Refusal::Rounded) => {
                *origin = *before;
                back(before)
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

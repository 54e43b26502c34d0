//! Steps by Taylor series, projected to invariants.

use super::invariants::Invariants;
use super::projection::{Projection, way_back};
use super::scales::Scales;
use crate::method::Refusal;
use crate::scalar::Real;
use crate::sealed::Sealed;
use crate::space::PerCoordinate;
use crate::space::vector::difference;
use crate::system::{Jets, VectorField};
use crate::taylor::{Steps, TaylorMethod};
use core::fmt::Debug;

impl<M: Sealed, I> Sealed for Projection<M, I> {}

impl<S, R, M, I> TaylorMethod<S, R> for Projection<M, I>
where
    S: Jets<R, Action = ()> + VectorField<R>,
    R: Real,
    M: TaylorMethod<S, R>,
    I: Invariants<S, R> + Debug,
{
    type Orders<X: Copy + Debug> = M::Orders<X>;
    type Series = M::Series;
    type Memory = Scales<S::Phase>;

    #[inline(always)]
    fn steps(&self) -> Steps {
        self.0.steps()
    }
    #[inline(always)]
    fn order(&self) -> usize {
        self.0.order()
    }
    fn memory() -> Scales<S::Phase> {
        Scales::new()
    }
    #[inline]
    fn correction(
        &self,
        scales: &mut Scales<S::Phase>,
        system: &S,
        before: &S::Phase,
        z: &S::Phase,
    ) -> Result<Option<S::Phase>, Refusal> {
        let moved = difference(z, before);
        scales.include(before, &moved);
        way_back(system, &self.1, scales, [before, z], &moved).map(|way| Some(way.back))
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

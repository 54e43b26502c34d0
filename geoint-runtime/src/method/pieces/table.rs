//! Tables for any number of pieces.

use super::driver::{self, Splitting, pass};
use super::splittings::ContactSplitting;
use crate::method::tables::total::adds_up;
use crate::method::{Claims, Method, Name, Probe, Refusal, Step};
use crate::scalar::Real;
use crate::space::Summation;
use crate::system::Pieces;
use core::marker::PhantomData;

/// A table for any number of pieces: Φ*(β_K h) Φ(α_K h) … Φ*(β₁h) Φ(α₁h), K flows of the last piece a step.
///
/// Of the pieces of a contact system, or by [`of`](PieceComposition::of) of those of another splitting. For three pieces and more these
/// are better than compositions of [`ContactSplitting`]. S. Blanes, F. Casas & A. Murua,
/// arXiv:2006.06317; that tables for two pieces serve for any number: R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PieceComposition<const K: usize, M = ContactSplitting> {
    name: Name,
    order: u32,
    /// (α, β), in order of application.
    weights: [[f64; 2]; K],
    splitting: PhantomData<M>,
}

impl<const K: usize> PieceComposition<K> {
    /// A palindrome α₁, β₁, α₂, …, β_K given by its first half.
    pub(crate) const fn palindrome(name: &'static str, order: u32, half: [f64; K]) -> Self {
        let mut weights = [[0.0; 2]; K];
        let mut i = 0;
        while i < 2 * K {
            weights[i / 2][i % 2] = half[if i < K { i } else { 2 * K - 1 - i }];
            i += 1;
        }
        assert!(adds_up(weights.as_flattened(), 1.0), "the weights add up to 1");
        PieceComposition { name: Name::new(name), order, weights, splitting: PhantomData }
    }

    /// The same table for the pieces of another splitting.
    pub const fn of<M: Splitting>(self, _: M) -> PieceComposition<K, M> {
        let Self { name, order, weights, .. } = self;
        PieceComposition { name: name.of(Name::new(M::NAME)), order, weights, splitting: PhantomData }
    }
}

impl<const K: usize, M> PieceComposition<K, M> {
    /// The order.
    pub const fn order(&self) -> u32 {
        self.order
    }

    /// (α, β), in order of application.
    pub const fn weights(&self) -> &[[f64; 2]; K] {
        &self.weights
    }
}

/// Φ(αh), then Φ*(βh).
#[derive(Clone, Copy, Debug)]
pub struct Pair<F, R> {
    forth: F,
    back: F,
    /// Where Φ begins, and where it meets Φ*, after the start of the step.
    at: [R; 2],
}

impl<S: Pieces<M, R>, M: Splitting, R: Real, const K: usize> Method<S, R> for PieceComposition<K, M> {
    type Proof = <S as Pieces<M, R>>::Proof;
    type Prepared = [Pair<S::Flows, R>; K];
    type Memory = ();

    fn claims(&self) -> Claims {
        driver::claims::<S, M, R>(self.order, K as u32)
    }

    fn name(&self) -> Name {
        self.name
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        core::array::from_fn(|i| {
            let [alpha, beta] = self.weights[i];
            let before: f64 = self.weights[..i].as_flattened().iter().sum();
            let part = |fraction: f64| R::from_f64(fraction) * h;
            Pair {
                forth: system.prepare_flows(part(alpha), part(alpha + beta)),
                back: system.prepare_flows(part(beta), part(beta)),
                at: [part(before), part(before + alpha)],
            }
        })
    }

    fn memory() {}

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        (): &mut (),
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let all = S::PIECES.len();
        for Pair { forth, back, at: [start, middle] } in prepared {
            let (start, middle) = (step.t + *start, step.t + *middle);
            let frozen = [forth, back].map(|flows| step.system.freeze(flows, middle));
            step.probe.visit(start, &step.x.z, &step.x.s);
            pass::<S, M, R, C, P>(0..all, (forth, &frozen[0]), step.part(start));
            pass::<S, M, R, C, P>((0..all - 1).rev(), (back, &frozen[1]), step.part(middle));
        }
        Ok(())
    }
}

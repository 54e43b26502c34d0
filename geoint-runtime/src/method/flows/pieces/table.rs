//! Tables of splitting methods for any number of pieces.

use super::splittings::{ContactSplitting, ExactFlows, PieceKind, PieceSplitting};
use crate::method::Name;
use crate::method::composition::Composition;
use crate::method::flows::{DriftFirst, Nystrom};
use crate::method::tables::total::adds_up;
use core::marker::PhantomData;

/// A table for any number of pieces: Φ*(β_K h) Φ(α_K h) … Φ*(β₁h) Φ(α₁h), with K flows of the last piece a step. Φ applies the flows of
/// all pieces in order, Φ* in reverse order.
///
/// It applies to the pieces of a contact system, or by [`of`](PieceComposition::of) to the pieces of another splitting. For three or more
/// pieces these tables are more efficient than compositions of [`ContactSplitting`]. S. Blanes, F. Casas & A. Murua,
/// arXiv:2006.06317. Tables for two pieces hold for any number of pieces: R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PieceComposition<const K: usize, M = ContactSplitting> {
    name: Name,
    order: u32,
    /// (α, β), in order of application.
    weights: [[f64; 2]; K],
    splitting: PhantomData<M>,
}

impl<const K: usize> PieceComposition<K> {
    /// Returns the palindrome α₁, β₁, α₂, …, β_K, given by its first half.
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

    /// Returns this table for the pieces of another splitting.
    pub const fn of<M: ExactFlows>(self, _: M) -> PieceComposition<K, M> {
        let Self { name, order, weights, .. } = self;
        PieceComposition { name: name.of(Name::new(M::NAME)), order, weights, splitting: PhantomData }
    }
}

impl<M: PieceKind> PieceComposition<1, M> {
    /// The splitting of order 2: all flows for h/2 in order, then in reverse order.
    pub(super) const SPLITTING: Self =
        PieceComposition { name: Name::new(M::NAME), order: 2, weights: [[0.5; 2]], splitting: PhantomData };
}

impl<const K: usize, M: PieceKind> PieceComposition<K, M> {
    /// Returns the table of a composition of steps of order 2.
    pub(super) fn of_steps(composition: &Composition<K>) -> Self {
        let weights = composition.weights().map(|gamma| [0.5 * gamma; 2]);
        let name = composition.name().of(Name::new(M::NAME));
        PieceComposition { name, order: composition.order(), weights, splitting: PhantomData }
    }
}

impl<const K: usize, M> PieceComposition<K, M> {
    /// The name of the table and of the splitting.
    pub(super) const fn table_name(&self) -> Name {
        self.name
    }

    /// The order.
    pub const fn order(&self) -> u32 {
        self.order
    }

    /// (α, β), in order of application.
    pub const fn weights(&self) -> &[[f64; 2]; K] {
        &self.weights
    }
}

/// A table of Runge–Kutta–Nyström type for two pieces, A outside and B inside. Its order conditions use {B, {B, {B, A}}} = 0.
///
/// For a drift and a kick with quadratic T it equals the [`Nystrom`] table. For other pieces the condition is proven from their formulas.
/// An example is a charge in a field that depends on one coordinate: one piece moves this coordinate, and the other piece the others.
/// Created by [`Nystrom::of`](crate::Nystrom::of).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PieceNystrom<const K: usize>(PieceComposition<K, PieceSplitting>);

impl<const K: usize> Nystrom<K, DriftFirst> {
    /// Returns this table for the two pieces of [`PieceSplitting`].
    pub const fn of(self, _: PieceSplitting) -> PieceNystrom<K> {
        let table = self.table();
        let (outer, _, inner) = table.coefficients();
        let (mut weights, mut back, mut i) = ([[0.0; 2]; K], 0.0, 0);
        while i < K {
            let forth = outer[i] - back;
            back = inner[i] - forth;
            weights[i] = [forth, back];
            i += 1;
        }
        let name = table.name().of(Name::new(PieceSplitting::NAME));
        PieceNystrom(PieceComposition { name, order: table.claims().order, weights, splitting: PhantomData })
    }
}

impl<const K: usize> PieceNystrom<K> {
    /// The table as a composition of two pieces.
    pub(super) const fn composition(&self) -> PieceComposition<K, PieceSplitting> {
        self.0
    }
}

//! Splittings, and Nyström tables of two pieces, as methods: their steps are those of a [`PieceComposition`].

use super::splittings::{PieceKind, PieceSplitting, PlanarDiscreteGradient, PlanarSplitting, PoissonSplitting};
use super::table::{PieceComposition, PieceNystrom};
use crate::method::composition::{Composition, SymmetricMap};
use crate::method::flows::delegate;
use crate::method::{Claims, Clock, Failure, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::space::{Point, Summation};
use crate::system::{NystromPieces, Pieces};

/// Makes a symmetric method of each splitting. Its compositions are tables, with neighbouring flows merged.
macro_rules! splittings {
    ($($name:ident)*) => { $(
        impl PieceKind for $name {
            const NAME: &'static str = stringify!($name);
        }

        impl SymmetricMap for $name {
            type Composed<const K: usize> = PieceComposition<K, $name>;

            fn compose<const K: usize>(self, composition: Composition<K>) -> Self::Composed<K> {
                PieceComposition::of_steps(&composition)
            }
        }

        delegate!([] $name, [Pieces<$name, R>], PieceComposition<1, $name>, |_this| PieceComposition::<1, $name>::SPLITTING);
    )* };
}

splittings!(PieceSplitting PoissonSplitting PlanarSplitting PlanarDiscreteGradient);

delegate!([const K: usize,] PieceNystrom<K>, [NystromPieces<R>], PieceComposition<K, PieceSplitting>, |this| this.composition());

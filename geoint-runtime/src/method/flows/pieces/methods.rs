//! Splittings, and Nyström tables of two pieces, as methods: their steps are those of a [`PieceComposition`].

use super::splittings::{
    ContactSplitting, PieceSplitting, PlanarDiscreteGradient, PlanarSplitting, PoissonSplitting, Splitting,
};
use super::table::{PieceComposition, PieceNystrom};
use crate::method::composition::{Composition, SymmetricMap};
use crate::method::flows::{delegate, steps_of};
use crate::method::{Claims, Clock, Failure, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::space::{Point, Summation};
use crate::system::{NystromPieces, Pieces};

/// Makes a symmetric method of each splitting. Its compositions are tables, with neighbouring flows merged.
macro_rules! splittings {
    ($($name:ident)*) => { $(
        impl Splitting for $name {
            const NAME: &'static str = stringify!($name);
        }

        impl SymmetricMap for $name {
            type Composed<const K: usize> = PieceComposition<K, $name>;

            fn compose<const K: usize>(self, composition: Composition<K>) -> Self::Composed<K> {
                PieceComposition::of_steps(&composition)
            }
        }

        impl<S: Pieces<$name, R>, R: Real> Method<S, R> for $name {
            type Proof = <S as Pieces<$name, R>>::Proof;
            type Prepared = <PieceComposition<1, $name> as Method<S, R>>::Prepared;
            type Memory = <PieceComposition<1, $name> as Method<S, R>>::Memory;

            fn claims(&self) -> Claims {
                Method::<S, R>::claims(&PieceComposition::<1, $name>::SPLITTING)
            }

            fn name(&self) -> Name {
                Name::new(Self::NAME)
            }

            fn prepare(&self, system: &S, h: R) -> Self::Prepared {
                PieceComposition::<1, $name>::SPLITTING.prepare(system, h)
            }

            fn memory() -> Self::Memory {
                <PieceComposition<1, $name> as Method<S, R>>::memory()
            }

            steps_of!(PieceComposition<1, $name>, |prepared| prepared);
        }
    )* };
}

splittings!(PieceSplitting ContactSplitting PoissonSplitting PlanarSplitting PlanarDiscreteGradient);

delegate!([const K: usize,] PieceNystrom<K>, NystromPieces, PieceComposition<K, PieceSplitting>, |this| this.composition());

//! [`ContactSplitting`] and its compositions, for contact systems with and without constraints.

use super::splittings::{ContactSplitting, PieceKind};
use super::table::PieceComposition;
use crate::method::composition::{Composition, SymmetricMap};
use crate::method::flows::delegate;
use crate::method::{Claims, Clock, Failure, Method, Name, Probe, Step, SteppedAs};
use crate::scalar::Real;
use crate::space::{Point, Summation};

impl PieceKind for ContactSplitting {
    const NAME: &'static str = "ContactSplitting";
}

delegate!([] ContactSplitting, [SteppedAs<ContactSplitting, R>], Steps<S, R>, |this| Steps::<S, R>::from(*this));

impl SymmetricMap for ContactSplitting {
    type Composed<const K: usize> = ComposedContact<K>;

    fn compose<const K: usize>(self, composition: Composition<K>) -> Self::Composed<K> {
        ComposedContact(composition)
    }
}

/// A symmetric composition of [`ContactSplitting`]. Neighbouring flows are merged, unless there are constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComposedContact<const K: usize>(Composition<K>);

delegate!(
    [const K: usize,] ComposedContact<K>, [SteppedAs<ContactSplitting, R>], <Steps<S, R> as SymmetricMap>::Composed<K>,
    |this| this.0.of(Steps::<S, R>::from(ContactSplitting))
);

/// The steps of [`ContactSplitting`] for a system.
type Steps<S, R> = <S as SteppedAs<ContactSplitting, R>>::Steps;

/// The steps without constraints.
impl From<ContactSplitting> for PieceComposition<1, ContactSplitting> {
    fn from(_: ContactSplitting) -> Self {
        PieceComposition::<1, ContactSplitting>::SPLITTING
    }
}

/// Compositions of the steps without constraints are tables, with neighbouring flows merged.
impl SymmetricMap for PieceComposition<1, ContactSplitting> {
    type Composed<const K: usize> = PieceComposition<K, ContactSplitting>;

    fn compose<const K: usize>(self, composition: Composition<K>) -> Self::Composed<K> {
        PieceComposition::of_steps(&composition)
    }
}

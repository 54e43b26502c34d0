//! The table of methods whose steps are a [`MeanStep`]: x₁ = x₀ + h J g with a mean gradient g. [`DiscreteGradient`](crate::DiscreteGradient) and
//! `FourthOrder(DiscreteGradient)` have steps of their own, and are not in the table.
//!
//! Orders and symmetries in the table hold for every H. For H = T(p) + V(q) some methods have a higher order, which their documentation states.

use super::mean::{FourthOrderBase, MeanGradient, MeanStep};
use super::{CoordinateIncrement, FourthOrder, Gonzalez, ItohAbe, ItohAbeAdjoint, MeanValue, SymmetrisedItohAbe};
use crate::implicit_method;
use crate::method::Claims;
use crate::method::composition::SymmetricMap;
use crate::method::gauss::{Gauss, GaussTableau};
use crate::method::implicit::ImplicitMethod;
use crate::scalar::Real;
use crate::system::{Conservative, DiscreteField};

// The symmetric means of the table below that `FourthOrder` accepts.
impl FourthOrderBase for Gonzalez {}
impl<const K: usize> FourthOrderBase for MeanValue<K> where MeanValue<K>: MeanGradient + SymmetricMap {}
impl FourthOrderBase for SymmetrisedItohAbe {}

/// Implements methods for mean gradients, with their order and symmetry. A row is `[generic parameters] mean (where type: bound)?: claims;`. [`MeanStep`] adds
/// the claims of a kept energy and of symplecticity, because both depend on the system.
macro_rules! methods {
    ($([$($generic:tt)*] $mean:ty $(where $bounded:ty: $bound:path)?: $claims:expr;)*) => { $(
        impl<S, R, $($generic)*> ImplicitMethod<S, R> for $mean
        where
            S: DiscreteField<R> + Conservative<R>,
            R: Real,
            $($bounded: $bound,)?
        {
            // Only canonical systems without damping and other forces have this proof.
            type Proof = <S as Conservative<R>>::Proof;
            type Step = MeanStep<Self>;

            fn step(self) -> MeanStep<Self> {
                MeanStep(self)
            }
        }

        implicit_method!([$($generic)*] $mean, |mean| MeanGradient::mean_name(mean), $claims $(, $bounded: $bound)?);
    )* };
}

// `FourthOrder` has a row for each mean, not one generic row: with one implementation per type, the compiler can name the bound that fails.
// Both bounds of `MeanValue<K>` admit K = 1 to 6. The second one follows from the first.
methods! {
    [] ItohAbe: Claims::of_order(1);
    [] ItohAbeAdjoint: Claims::of_order(1);
    [] SymmetrisedItohAbe: Claims::of_order(2).symmetric();
    [] Gonzalez: Claims::of_order(2).symmetric();
    [] CoordinateIncrement: Claims::of_order(1);
    [const K: usize] MeanValue<K> where Gauss<K>: GaussTableau<K>: Claims::of_order(2).symmetric();
    [] FourthOrder<Gonzalez>: Claims::of_order(4).symmetric();
    [] FourthOrder<SymmetrisedItohAbe>: Claims::of_order(4).symmetric();
    [const K: usize] FourthOrder<MeanValue<K>> where MeanValue<K>: FourthOrderBase: Claims::of_order(4).symmetric();
}

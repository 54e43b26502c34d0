//! The table of methods whose steps are a [`MeanStep`]: x₁ = x₀ + h J g with a mean gradient g.
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

impl FourthOrderBase for Gonzalez {}
impl<const K: usize> FourthOrderBase for MeanValue<K> where MeanValue<K>: MeanGradient + SymmetricMap {}
impl FourthOrderBase for SymmetrisedItohAbe {}

/// Implements methods for mean gradients, with their order and symmetry. [`MeanStep`] adds the claim that a method keeps the energy, or is symplectic,
/// because it depends on the system.
macro_rules! methods {
    ($([$($generic:tt)*] $mean:ty $(where $bounded:ty: $bound:path)?: $claims:expr;)*) => { $(
        impl<S, R, $($generic)*> ImplicitMethod<S, R> for $mean
        where
            S: DiscreteField<R> + Conservative<R>,
            R: Real,
            $($bounded: $bound,)?
        {
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

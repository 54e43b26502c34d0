//! The number of stages of a Gauss method selects its tableau.

use super::Gauss;
use crate::method::explicit::tableau::Tableau;
use crate::method::tables::gauss::{GAUSS_1, GAUSS_2, GAUSS_3, GAUSS_4, GAUSS_5, GAUSS_6};
use crate::sealed::Sealed;

/// Number of stages of a Gauss method, 1 to 6.
///
/// Sealed: the tableaux are Gauss's tableaux.
pub trait GaussTableau<const S: usize>: Sealed {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// The tableau.
    const TABLEAU: Tableau<S>;
}

impl<const S: usize> Sealed for Gauss<S> {}

macro_rules! tableaux {
    ($($stages:literal: $tableau:ident,)*) => { $(
        impl GaussTableau<$stages> for Gauss<$stages> {
            type Proof = ();
            const TABLEAU: Tableau<$stages> = $tableau;
        }
    )* };
}

tableaux! { 1: GAUSS_1, 2: GAUSS_2, 3: GAUSS_3, 4: GAUSS_4, 5: GAUSS_5, 6: GAUSS_6, }

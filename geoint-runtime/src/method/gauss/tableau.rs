//! The number of stages of a Gauss method selects its tableau.

use super::Gauss;
use crate::method::explicit::tableau::Tableau;
use crate::method::tables::gauss::{GAUSS_1, GAUSS_2, GAUSS_3, GAUSS_4, GAUSS_5, GAUSS_6};
use crate::sealed::Sealed;

/// The tableau of the Gauss method with `S` stages, 1 to 6. Any other number is a type error.
///
/// `S` occurs twice in `Gauss<S>: GaussTableau<S>`, because the type of `TABLEAU` needs it, and cannot read it from `Self`. Sealed, because the claims of
/// [`Gauss`] hold for these tableaux only.
pub trait GaussTableau<const S: usize>: Sealed {
    /// `()`, a part of [`Method::Proof`](crate::Method::Proof): with another number of stages, rustc reports the missing tableau only.
    type Proof;
    /// The coefficients a, the weights b and the nodes c, each rounded once to `f64`.
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

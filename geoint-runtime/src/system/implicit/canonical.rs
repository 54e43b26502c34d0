//! Flows that are canonical in other coordinates than those of their states.

use crate::scalar::Real;
use crate::space::Square;
use crate::system::VectorField;

/// x' = S ∇H with functions y of x, as many as coordinates, in which S is the canonical matrix: half of the coordinates, and their momenta.
///
/// Of a Lagrangian ϑ(q)·v − H(q) the momenta are entries of ϑ, and no inverse of y is needed: stages are solved for x.
pub trait CanonicalForm<R: Real = f64>: VectorField<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// What depends on parameters only.
    type CanonicalConstants: Copy + core::fmt::Debug;

    /// What depends on parameters only.
    fn canonical_constants(&self) -> Self::CanonicalConstants;
    /// [y, y'] at a point, and the derivatives of both by x.
    fn canonical(
        &self,
        constants: &Self::CanonicalConstants,
        t: R,
        z: &Self::Phase,
        values: [&mut Self::Phase; 2],
        derivatives: &mut [Square<Self::Phase>; 2],
    );
}

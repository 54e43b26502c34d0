//! Flows that are canonical in other coordinates than the coordinates of their states.

use crate::scalar::Real;
use crate::space::Square;
use crate::system::VectorField;

/// x' = S ∇H with functions y of x, as many as coordinates, in which S is the canonical matrix. Half of the functions are coordinates, the other half
/// are their momenta.
///
/// The momenta of a Lagrangian ϑ(q)·v − H(q) are entries of ϑ. Stages are solved for x, so that no inverse of y is needed.
pub trait CanonicalForm<R: Real = f64>: VectorField<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Coefficients that depend on parameters only.
    type CanonicalConstants: Copy + core::fmt::Debug;

    /// Computes the coefficients that depend on parameters only.
    fn canonical_constants(&self) -> Self::CanonicalConstants;
    /// Computes [y, y'] at a point, and the derivatives of both by x.
    fn canonical(
        &self,
        constants: &Self::CanonicalConstants,
        t: R,
        z: &Self::Phase,
        values: [&mut Self::Phase; 2],
        derivatives: &mut [Square<Self::Phase>; 2],
    );
}

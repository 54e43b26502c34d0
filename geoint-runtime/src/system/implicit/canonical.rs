//! Systems that are canonical in other coordinates y(x) than those of their states x. Gauss methods are symplectic for them if they advance y.

use crate::scalar::Real;
use crate::space::Square;
use crate::system::VectorField;

/// x' = S(x) ∇H, and functions y of x in which the structure matrix S becomes the canonical matrix. There are as many functions as coordinates. Half of
/// them are positions, and the other half are their momenta.
///
/// The macros implement it for Lagrangians ϑ(q)·v − H(q, t) with x = q. They must find a function f(q) for which half of the entries of ϑ + ∇f vanish. The
/// other entries are the momenta. Stages are solved for x, so that no formula for x(y) is needed.
pub trait CanonicalForm<R: Real = f64>: VectorField<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Coefficients that depend on parameters only.
    type CanonicalConstants: Copy + core::fmt::Debug;

    /// Computes the coefficients that depend on parameters only.
    fn canonical_constants(&self) -> Self::CanonicalConstants;
    /// Computes [y, dy/dt] at a point x = `z`, and the derivatives of both by x.
    fn canonical(
        &self,
        constants: &Self::CanonicalConstants,
        t: R,
        z: &Self::Phase,
        values: [&mut Self::Phase; 2],
        derivatives: &mut [Square<Self::Phase>; 2],
    );
}

//! Systems that were written as a Lagrangian L(q, v, s, t).

use super::Cotangent;
use crate::scalar::Real;

/// The energy H(q, p, s, t) of a system is p·v − L(q, v, s, t) with p = ∂L/∂v.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no system of `#[lagrangian]`",
    label = "velocities belong to a Lagrangian; of an energy H(q, p) they are ∂H/∂p"
)]
pub trait Lagrangian<R: Real = f64>: Cotangent<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// L.
    fn lagrangian(&self, t: R, q: &Self::Array, v: &Self::Array, s: &Self::Action) -> R;
    /// p = ∂L/∂v.
    fn momentum(&self, t: R, q: &Self::Array, v: &Self::Array, s: &Self::Action) -> Self::Array;
    /// v = ∂H/∂p at a point; not a number where the point has none.
    fn velocity(&self, t: R, z: &Self::Phase, s: &Self::Action) -> Self::Array;
}

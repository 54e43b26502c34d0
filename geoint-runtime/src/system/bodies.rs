//! Rigid bodies.

use super::{Cotangent, QuadraticKinetic};
use crate::scalar::Real;

/// Rigid bodies in their frames of principal axes: T = Σ mᵢ²/2Iᵢ of each. Rotations about the three axes are then exact flows of the three
/// terms.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to be of rigid bodies in their principal axes",
    label = "`FiveRotations` turns bodies about their principal axes",
    note = "for bodies with a full tensor of inertia: `StormerVerlet`, whose drift is exact; for other systems there are no rotations"
)]
pub trait PrincipalAxes<R: Real = f64>: QuadraticKinetic<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Five rotations of every body in place of a drift, of order 2.
    fn rotate(&self, drift: &Self::Drift, q: &mut <Self as Cotangent<R>>::Array, p: &mut <Self as Cotangent<R>>::Array);
}

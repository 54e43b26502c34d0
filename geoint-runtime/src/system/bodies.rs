//! Rigid bodies.

use super::{Cotangent, QuadraticKinetic};
use crate::scalar::Real;

/// Rigid bodies in their frames of principal axes: T = Σ mᵢ²/2Iᵢ for each body, with angular momenta mᵢ and moments of inertia Iᵢ. The exact flows of
/// the three terms are rotations about the three axes.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to be of rigid bodies in their principal axes",
    label = "`FiveRotations` turns bodies about their principal axes",
    note = "for bodies with a full tensor of inertia: `StormerVerlet`, whose drift is exact; for other systems there are no rotations"
)]
pub trait PrincipalAxes<R: Real = f64>: QuadraticKinetic<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Applies five rotations to each body, in place of a drift. The order is 2.
    fn rotate(&self, drift: &Self::Drift, q: &mut <Self as Cotangent<R>>::Array, p: &mut <Self as Cotangent<R>>::Array);
}

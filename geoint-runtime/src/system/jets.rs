//! Taylor coefficients of solutions.

use super::PhaseSpace;
use crate::scalar::Real;
use crate::space::{Array, PerCoordinate, Snapshot};

/// A system with Taylor coefficients of its solutions to any order. Recurrences give them, which follow from the energy or the field.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Taylor series",
    label = "its rates are not known as formulas of its coordinates",
    note = "methods for such systems: see `integrator` and `adaptive`"
)]
pub trait Jets<R: Real = f64>: PhaseSpace<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// One number for each condition in the rates. The sign of the number decides the condition.
    type Switches: Array<Real = R>;
    /// States of this system over another scalar.
    type Over<T: Real>: Snapshot<Real = T>;
    /// The number of sums with n terms in all coefficients of order n. It measures the cost of an order.
    const CONVOLUTIONS: usize;

    /// Computes x⁽ⁿ⁾ unitⁿ/n! of all coordinates at a point for n = 1, …, P, and of the switches for n = 0, …, P − 1.
    ///
    /// These are the coefficients of the series in (time since the point)/`unit`. With a unit near the step length they have the size of x, and none
    /// of them overflows. If a condition selects a branch, the series is that of the branch at the point.
    fn jet<const P: usize>(
        &self,
        unit: R,
        t: R,
        z: &Self::Phase,
        s: &Self::Action,
        jet: &mut [PerCoordinate<Self::Phase, Self::Action>; P],
        switches: &mut [Self::Switches; P],
    );
}

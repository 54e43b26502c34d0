//! The Taylor coefficients of a solution.

use super::PhaseSpace;
use crate::scalar::Real;
use crate::space::{Array, PerCoordinate, Snapshot};

/// A system whose solutions have Taylor coefficients of any order, by recurrences that follow from its energy or field.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Taylor series",
    label = "its rates are not known as formulas of its coordinates",
    note = "methods for such systems: see `integrator` and `adaptive`"
)]
pub trait Jets<R: Real = f64>: PhaseSpace<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// What decides the conditions in the rates, by signs: a number each.
    type Switches: Array<Real = R>;
    /// States of this system over another scalar.
    type Over<T: Real>: Snapshot<Real = T>;
    /// Sums of n terms in all coefficients of order n: what an order costs.
    const CONVOLUTIONS: usize;

    /// x⁽ⁿ⁾ unitⁿ/n! of all coordinates at a point, for n = 1, …, P; and of the switches for n = 0, …, P − 1: the coefficients in time
    /// since the point over `unit`. With a unit near the length of a step they have the size of x, and none of them overflows.
    ///
    /// Where a condition decides between branches, the series is that of the branch that is taken at the point.
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

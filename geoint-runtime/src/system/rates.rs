//! The rates of all coordinates, for systems with and without an action.

use super::{Contact, PhaseSpace, VectorField};
use crate::scalar::Real;
use crate::space::PerCoordinate;

/// A system as a differential equation. The trait is implemented for each [`VectorField`] and each [`Contact`] system. The parameter `S` distinguishes
/// both implementations.
#[diagnostic::on_unimplemented(
    message = "the rates of `{Self}` are no functions of its state",
    label = "explicit methods and adaptive runs need them, and those of a system with constraints follow from multipliers",
    note = "methods that keep a `constraint`: `Rattle`, `DiscreteGradient`"
)]
pub trait Rates<R: Real = f64, S = <Self as PhaseSpace<R>>::Action>: PhaseSpace<R> {
    /// `()`; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Returns z' and s' at a point.
    fn rates(&self, t: R, x: &PerCoordinate<Self::Phase, Self::Action>) -> PerCoordinate<Self::Phase, Self::Action>;
}

impl<R: Real, F: VectorField<R>> Rates<R, ()> for F {
    type Proof = F::Proof;
    #[inline(always)]
    fn rates(&self, t: R, x: &PerCoordinate<F::Phase>) -> PerCoordinate<F::Phase> {
        let mut rates = PerCoordinate::zero();
        self.rate(t, &x.z, &mut rates.z);
        rates
    }
}

impl<R: Real, F: Contact<R>> Rates<R, R> for F {
    type Proof = F::Proof;
    #[inline(always)]
    fn rates(&self, t: R, x: &PerCoordinate<F::Phase, R>) -> PerCoordinate<F::Phase, R> {
        let mut rates = PerCoordinate::zero();
        self.rate(t, &x.z, &x.s, &mut rates.z, &mut rates.s);
        rates
    }
}

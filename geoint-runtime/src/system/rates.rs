//! The rates of all coordinates, of every kind of system.

use super::{Contact, PhaseSpace, VectorField};
use crate::scalar::Real;
use crate::space::PerCoordinate;

/// A system as a differential equation: every [`VectorField`] and every [`Contact`] system is one. `S` keeps both apart.
#[diagnostic::on_unimplemented(
    message = "steps of `{Self}` cannot adapt",
    label = "an adaptive run begins with the rates of a system, and those of one with constraints follow from multipliers"
)]
pub trait Rates<R: Real = f64, S = <Self as PhaseSpace<R>>::Action>: PhaseSpace<R> {
    /// z' and s' at a point.
    fn rates(&self, t: R, x: &PerCoordinate<Self::Phase, Self::Action>) -> PerCoordinate<Self::Phase, Self::Action>;
}

impl<R: Real, F: VectorField<R>> Rates<R, ()> for F {
    #[inline(always)]
    fn rates(&self, t: R, x: &PerCoordinate<F::Phase>) -> PerCoordinate<F::Phase> {
        let mut rates = PerCoordinate::zero();
        self.rate(t, &x.z, &mut rates.z);
        rates
    }
}

impl<R: Real, F: Contact<R>> Rates<R, R> for F {
    #[inline(always)]
    fn rates(&self, t: R, x: &PerCoordinate<F::Phase, R>) -> PerCoordinate<F::Phase, R> {
        let mut rates = PerCoordinate::zero();
        self.rate(t, &x.z, &x.s, &mut rates.z, &mut rates.s);
        rates
    }
}

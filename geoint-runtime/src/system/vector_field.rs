//! The rates of all coordinates, of both kinds of systems.

use super::{Contact, Hamiltonian, PhaseSpace};
use crate::scalar::Real;
use crate::space::PerCoordinate;

/// A system as a differential equation: every [`Hamiltonian`] and every [`Contact`] system is one. `Z` keeps both apart.
pub trait VectorField<R: Real = f64, Z = <Self as PhaseSpace<R>>::Action>: PhaseSpace<R> {
    /// q', p' and s' at a point.
    fn rates(&self, t: R, x: &PerCoordinate<Self::Array, Self::Action>) -> PerCoordinate<Self::Array, Self::Action>;
}

impl<R: Real, S: Hamiltonian<R>> VectorField<R, ()> for S {
    #[inline(always)]
    fn rates(&self, t: R, x: &PerCoordinate<S::Array>) -> PerCoordinate<S::Array> {
        let mut rates = PerCoordinate::zero();
        self.rate(t, &x.q, &x.p, &mut rates.q, &mut rates.p);
        rates
    }
}

impl<R: Real, S: Contact<R>> VectorField<R, R> for S {
    #[inline(always)]
    fn rates(&self, t: R, x: &PerCoordinate<S::Array, R>) -> PerCoordinate<S::Array, R> {
        self.rate(t, x)
    }
}

//! The energy that a step keeps in place of H.

use super::{PhaseSpace, StateOf};
use crate::scalar::Real;
use crate::space::Snapshot;

/// What a step of order 2 keeps in place of H, to the next order.
///
/// Of [`StormerVerlet`](crate::StormerVerlet), or of [`ContactSplitting`](crate::ContactSplitting) for a contact system: the steps are
/// those of the exact flow of H + h²H₂, but for an error of h⁵ a step. Thus h²H₂ says how far H itself goes off, and what
/// H + h²H₂ goes off by how long the step still is. E. Hairer, Ch. Lubich & G. Wanner, *Geometric Numerical Integration* (2006),
/// section IX.4.
pub trait ModifiedEnergy<R: Real = f64>: PhaseSpace<R> {
    /// H + h²H₂ at a point.
    fn modified_hamiltonian(&self, h: R, t: R, z: &Self::Phase, s: &Self::Action) -> R;

    /// H + h²H₂ of a state.
    fn modified_energy(&self, h: R, state: &StateOf<Self, R>) -> R {
        let (t, z, s) = state.parts();
        self.modified_hamiltonian(h, t, &z, &s)
    }
}

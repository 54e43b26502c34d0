//! The modified energy H + h²H₂ of methods of order 2.

use super::{PhaseSpace, StateOf};
use crate::scalar::Real;
use crate::space::Snapshot;

/// A system with a known modified energy H + h²H₂, which a step of order 2 keeps in place of H, to the next order.
///
/// The method is [`StormerVerlet`](crate::StormerVerlet), or [`ContactSplitting`](crate::ContactSplitting) for a contact system. Its steps are those of
/// the exact flow of H + h²H₂, except for an error of order h⁵ in each step. Thus h²H₂ estimates the error of H. The change of H + h²H₂
/// along a run estimates the error of the next order. E. Hairer, Ch. Lubich & G. Wanner, *Geometric Numerical Integration* (2006), section IX.4.
pub trait ModifiedEnergy<R: Real = f64>: PhaseSpace<R> {
    /// Returns H + h²H₂ at a point.
    fn modified_hamiltonian(&self, h: R, t: R, z: &Self::Phase, s: &Self::Action) -> R;

    /// Returns H + h²H₂ of a state.
    fn modified_energy(&self, h: R, state: &StateOf<Self, R>) -> R {
        let (t, z, s) = state.parts();
        self.modified_hamiltonian(h, t, &z, &s)
    }
}

//! The space of the scaled gradients D∇I of invariants, and the multipliers of a correction in this space. D holds the units of the coordinates.

use super::basis::{Basis, Excluded};
use crate::scalar::{Real, zero};
use crate::solving::size::Sizes;
use crate::space::Array;
use crate::space::vector::sum_of_products;

/// An orthogonal basis of the scaled gradients of invariants at a point.
pub(super) struct Frame<V: Array, Z: Array<Real = V::Real>> {
    /// D: the unit of length of each coordinate.
    units: Sizes<Z>,
    /// The basis of the vectors D∇I, each divided by its `terms`.
    basis: Basis<V, Z>,
    /// The sum of the magnitudes of the entries of D∇I.
    terms: V,
    /// Σ size·|∂I/∂z| of each invariant, divided by its `terms`. Times ε, it is the rounding of the invariant in units of `terms`.
    digits: Sizes<V>,
}

impl<V: Array, Z: Array<Real = V::Real>> Frame<V, Z> {
    /// Computes the basis from the gradients at a point. `sizes` are the magnitudes of the coordinates, which determine their rounding.
    pub(super) fn new(mut gradients: V::Map<Z>, units: Sizes<Z>, sizes: &Sizes<Z>, excluded: Excluded) -> Self {
        let (mut terms, mut digits) = (V::zero(), Sizes::equal());
        for (i, gradient) in V::entries(&mut gradients).iter_mut().enumerate() {
            let whole = sizes.normalise(&mut gradient.clone());
            let part = units.normalise(gradient);
            terms.as_mut_slice()[i] = part;
            digits.entries()[i] = if part.magnitude() > 0.0 { whole / part } else { zero() };
        }
        Frame { units, basis: Basis::new(gradients, excluded, |vector| *vector), terms, digits }
    }

    /// Returns the correction Σ λᵢ D wᵢ, which is a combination of the vectors D²∇Iᵢ.
    pub(super) fn back(&self, multipliers: &V) -> Z {
        let mut back = Z::zero();
        for (multiplier, vector) in multipliers.as_slice().iter().zip(V::entries_of(&self.basis.vectors)) {
            back.add_scaled(*multiplier, vector);
        }
        self.units.multiply(&mut back);
        back
    }

    /// Converts changes of invariants to the multipliers that cause them. Returns the largest change relative to the terms of its invariant, of which ε is
    /// rounding.
    ///
    /// If the basis excludes the gradient of an invariant, only the part of its change that the invariants before it do not explain is counted. No
    /// correction reduces this part.
    pub(super) fn multipliers(&self, changes: &mut V) -> f64 {
        let (changes, reciprocals) = (changes.as_mut_slice(), self.basis.reciprocals.as_slice());
        let mut greatest = 0.0_f64;
        for (i, row) in V::entries_of::<V>(&self.basis.coefficients).iter().enumerate() {
            // No 0/0 if the gradient vanishes and the invariant has not changed.
            let part = |change: V::Real, terms| if change.magnitude() == 0.0 { change } else { change / terms };
            let whole = part(changes[i], self.terms.as_slice()[i]);
            // The change along wᵢ: earlier entries of `changes` are the changes along earlier vectors.
            let rest = whole - sum_of_products(&row.as_slice()[..i], changes);
            let is_excluded = reciprocals[i].magnitude() == 0.0;
            let relative = part(if is_excluded { rest } else { whole }, self.digits.as_slice()[i]).magnitude();
            // Not `max`, which would drop a NaN.
            greatest = if relative <= greatest { greatest } else { relative };
            changes[i] = if is_excluded { zero() } else { rest };
        }
        for (change, reciprocal) in changes.iter_mut().zip(reciprocals) {
            *change *= *reciprocal;
        }
        greatest
    }
}

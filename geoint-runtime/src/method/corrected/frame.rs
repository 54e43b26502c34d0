//! An orthonormal basis of the scaled gradients D∇I of invariants, and the multipliers of a correction in this basis. D holds the units of the
//! coordinates.

use crate::scalar::{Real, zero};
use crate::solving::size::Sizes;
use crate::space::vector::dot;
use crate::space::{Array, Square};

/// An orthonormal basis of the scaled gradients of invariants at a point.
pub(super) struct Frame<A: Array, Z: Array<Real = A::Real>> {
    /// D: the unit of length of each coordinate.
    units: Sizes<Z>,
    /// The orthonormal directions eᵢ, and the triangular matrix that gives the normalised D∇I from them.
    directions: A::Map<Z>,
    triangle: Square<A>,
    /// The sum of the magnitudes of the entries of D∇I. The gradient is divided by it.
    terms: A,
    /// Σ size·|∂I/∂z| of each invariant, divided by its `terms`. Times ε, it is the rounding of the invariant in units of `terms`.
    digits: Sizes<A>,
}

impl<A: Array, Z: Array<Real = A::Real>> Frame<A, Z> {
    /// Computes the basis from the gradients at a point. `sizes` are the magnitudes of the coordinates, which determine their rounding.
    pub(super) fn new(mut gradients: A::Map<Z>, units: Sizes<Z>, sizes: &Sizes<Z>) -> Self {
        let (mut terms, mut digits) = (A::zero(), Sizes::equal());
        for (i, direction) in A::entries(&mut gradients).iter_mut().enumerate() {
            let whole = sizes.normalise(&mut direction.clone());
            let part = units.normalise(direction);
            terms.as_mut_slice()[i] = part;
            digits.entries()[i] = if part.magnitude() > 0.0 { whole / part } else { zero() };
        }
        let triangle = orthonormalise::<A, Z>(A::entries(&mut gradients));
        Frame { units, directions: gradients, triangle, terms, digits }
    }

    /// Returns the correction Σ λᵢ D eᵢ, which is a combination of the vectors D²∇Iᵢ.
    pub(super) fn back(&self, multipliers: &A) -> Z {
        let mut back = Z::zero();
        for (multiplier, direction) in multipliers.as_slice().iter().zip(A::entries_of(&self.directions)) {
            back.add_scaled(*multiplier, direction);
        }
        self.units.multiply(&mut back);
        back
    }

    /// Converts changes of invariants to the multipliers that cause them. Returns the largest change relative to the terms of its invariant, of which ε is
    /// rounding.
    pub(super) fn multipliers(&self, changes: &mut A) -> f64 {
        for (change, terms) in changes.as_mut_slice().iter_mut().zip(self.terms.as_slice()) {
            // No 0/0 if the gradient vanishes and the invariant has not changed.
            *change = if change.magnitude() == 0.0 { *change } else { *change / *terms };
        }
        along(&self.triangle, &self.digits, changes)
    }
}

/// Makes directions orthonormal by the Gram–Schmidt method with reorthogonalisation. Returns the triangular matrix that gives the original directions
/// from the new ones.
///
/// A direction that depends on earlier ones to √ε becomes zero, and so does its diagonal entry.
/// Its function then differs by less than rounding from a function of the others.
fn orthonormalise<A: Array, Z: Array<Real = A::Real>>(directions: &mut [Z]) -> Square<A> {
    let mut triangle = A::fill(A::zero());
    for (i, row) in A::entries::<A>(&mut triangle).iter_mut().enumerate() {
        let (before, rest) = directions.split_at_mut(i);
        let direction = &mut rest[0];
        let length = dot(direction, direction).sqrt();
        let row = row.as_mut_slice();
        for (j, other) in before.iter().enumerate().chain(before.iter().enumerate()) {
            let part = dot(direction, other);
            row[j] += part;
            direction.add_scaled(-part, other);
        }
        let left = dot(direction, direction).sqrt();
        // NaN is kept.
        let agrees = left.magnitude() <= length.magnitude() * A::Real::epsilon().sqrt();
        for x in direction.as_mut_slice() {
            *x = if agrees { zero() } else { *x / left };
        }
        row[i] = if agrees { zero() } else { left };
    }
    triangle
}

/// Converts changes of functions to multipliers of orthonormal directions. Returns the largest change relative to `digits`.
///
/// If a function depends on earlier ones, only the part of its change that they do not explain is counted. No correction reduces this part.
fn along<A: Array>(triangle: &Square<A>, digits: &Sizes<A>, changes: &mut A) -> f64 {
    let mut greatest = 0.0_f64;
    for (i, row) in A::entries_of::<A>(triangle).iter().enumerate() {
        let (row, changes) = (row.as_slice(), changes.as_mut_slice());
        let (whole, mut rest) = (changes[i], changes[i]);
        for j in 0..i {
            rest -= row[j] * changes[j];
        }
        let has_direction = row[i].magnitude() != 0.0;
        let change = if has_direction { whole.magnitude() } else { rest.magnitude() };
        let change = if change == 0.0 { change } else { change / digits.of(i) };
        // Not `max`, which would drop a NaN.
        greatest = if change <= greatest { greatest } else { change };
        changes[i] = if has_direction { rest / row[i] } else { zero() };
    }
    greatest
}

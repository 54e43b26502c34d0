//! The directions in which invariants change, and how far along them a change is undone.

use crate::scalar::{Real, zero};
use crate::solving::size::Sizes;
use crate::space::vector::dot;
use crate::space::{Array, Square};

/// The directions in which invariants change at a point.
pub(super) struct Frame<A: Array, Z: Array<Real = A::Real>> {
    /// D, in which the distance of each coordinate is measured.
    units: Sizes<Z>,
    /// D∇I, orthonormal, and the triangle that takes them back to what they were.
    directions: A::Map<Z>,
    triangle: Square<A>,
    /// The sum of the magnitudes of the entries of D∇I, by which it is divided.
    terms: A,
    /// By ε times the same sum over sizes, in units of those terms, rounding changes an invariant.
    digits: Sizes<A>,
}

impl<A: Array, Z: Array<Real = A::Real>> Frame<A, Z> {
    /// At a point with these gradients, whose coordinates are rounded as these sizes are.
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

    /// Σ λᵢ D²∇Iᵢ.
    pub(super) fn back(&self, multipliers: &A) -> Z {
        let mut back = Z::zero();
        for (multiplier, direction) in multipliers.as_slice().iter().zip(A::entries_of(&self.directions)) {
            back.add_scaled(*multiplier, direction);
        }
        self.units.multiply(&mut back);
        back
    }

    /// From changes of invariants to the multipliers that cause them; the largest change, relative to what rounding changes.
    pub(super) fn multipliers(&self, changes: &mut A) -> f64 {
        for (change, terms) in changes.as_mut_slice().iter_mut().zip(self.terms.as_slice()) {
            // Also where gradients vanish there may be nothing to do.
            *change = if change.magnitude() == 0.0 { *change } else { *change / *terms };
        }
        along(&self.triangle, &self.digits, changes)
    }
}

/// Makes directions orthonormal, by Gram's and Schmidt's method, each twice; the triangle that takes them back to what they were.
///
/// Directions that agree to √ε with those before them are zero then, and so are their rows: the functions that they are gradients of differ by
/// less than rounding from functions of the others.
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
        // What is not a number stays so.
        let agrees = left.magnitude() <= length.magnitude() * A::Real::epsilon().sqrt();
        for x in direction.as_mut_slice() {
            *x = if agrees { zero() } else { *x / left };
        }
        row[i] = if agrees { zero() } else { left };
    }
    triangle
}

/// Turns changes of functions into multipliers of orthonormal directions. Returns the largest change relative to `digits`. A function without a direction
/// of its own counts with the part of its change that the other functions leave: no correction reduces this part.
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
        // Not `max`: that would lose what is not a number.
        greatest = if change <= greatest { greatest } else { change };
        changes[i] = if has_direction { rest / row[i] } else { zero() };
    }
    greatest
}

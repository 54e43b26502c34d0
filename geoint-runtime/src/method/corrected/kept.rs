//! Removal of the drift of invariants that rounding errors cause.
//!
//! A method keeps an invariant to rounding in each step. The rounding errors of many steps add up. [`way_back`] returns a correction that undoes
//! their sum.

use super::basis::Excluded;
use super::frame::Frame;
use super::scales::{Scales, part_of_rounding};
use crate::scalar::{Real, zero};
use crate::solving::rounding::ROUNDINGS;
use crate::solving::size::Sizes;
use crate::space::Array;
use crate::space::vector::{difference, opposite, sum};
use crate::system::{Invariants, PhaseSpace};

/// The largest rounding of the 1024 steps between two corrections, in ε of the terms.
const MOST_ROUNDING: f64 = 1024.0 * ROUNDINGS;

/// The drift is not removed if the path from the origin is rounded so much that it no longer determines an invariant.
///
/// The rounding of an invariant I by the path is ε r with r = Σ sᵢ |∂I/∂zᵢ|, where s are the sizes of the coordinates along the path. At `z`, r may be at most this
/// many times r at the origin. It may also be at most this many times the same sum with the magnitudes at both ends. It is larger near a collision, and if one
/// coordinate has grown and another one has shrunk by orders of magnitude.
const MOST_STEEPENING: f64 = 16.0;

/// Returns the correction of `z` that leads, to first order, to the values of `invariants` at `origin`.
///
/// The correction is a combination of gradients at `z`. Nearly dependent gradients are excluded, such as those of angular momentum and energy on a circular
/// orbit. A correction along them would amplify the rounding of one evaluation beyond the rounding of many steps. An invariant that has changed by more than
/// the rounding of many steps is not corrected, because the method does not keep it.
///
/// A coordinate that is equal to its value at the origin does not change. Thus a momentum without a force keeps its bits. Returns zero if
/// the path is rounded too much, if the correction would be longer than the rounding of many steps, or if it would increase the change of an invariant beyond rounding, as
/// at a jump.
pub(crate) fn way_back<S: PhaseSpace<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    origin: &S::Phase,
    z: &S::Phase,
) -> S::Phase {
    let moved = difference(z, origin);
    let (sizes, ends) = (Sizes::along([origin, &moved]), [origin, z].map(Sizes::at));
    let [first, mut last] = [origin, z].map(|z| invariants.gradients(system, z));
    let mut changes = invariants.changes(system, origin, &moved);
    let (mut largest_after, mut explained) = (changes, 1.0_f64);
    let gradients = I::Values::entries_of(&first).iter().zip(I::Values::entries(&mut last));
    let changed = changes.as_mut_slice().iter_mut().zip(largest_after.as_mut_slice());
    for ((first, last), (change, largest_after)) in gradients.zip(changed) {
        let terms = sizes.terms(last);
        if terms > MOST_STEEPENING * sizes.terms(first).min(ends[0].terms(first) + ends[1].terms(last)) {
            return S::Phase::zero();
        }
        *largest_after = R::from_f64(change.magnitude() + ROUNDINGS * R::epsilon() * terms);
        if change.magnitude() <= MOST_ROUNDING * R::epsilon() * terms {
            // The strictest invariant decides for all coordinates.
            explained = explained.min(part_of_rounding(*change, terms));
        } else {
            (*change, *last) = (zero(), S::Phase::zero());
        }
    }
    let mut units = Scales::along(sizes, &moved).units(|| {
        let mut parts = S::Phase::zero();
        parts.as_mut_slice().fill(R::from_f64(explained));
        parts
    });
    for (unit, moved) in units.entries().iter_mut().zip(moved.as_slice()) {
        *unit = if moved.magnitude() == 0.0 { zero() } else { *unit };
    }
    let frame = Frame::<I::Values, S::Phase>::new(last, units, &sizes, Excluded::NearlyDependent);
    frame.multipliers(&mut changes);
    let back = opposite(&frame.back(&changes));
    let after = invariants.changes(system, origin, &sum(&moved, &back));
    let is_short = sizes.all_within(&back, MOST_ROUNDING * R::epsilon());
    let grows = |(after, largest): (&R, &R)| after.magnitude() > largest.magnitude();
    let improves = is_short && !after.as_slice().iter().zip(largest_after.as_slice()).any(grows);
    if improves { back } else { S::Phase::zero() }
}

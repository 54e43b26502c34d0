//! Removal of the drift of invariants that rounding errors cause.
//!
//! A method keeps an invariant to rounding in each step. The rounding errors of many steps add up. [`way_back`] returns a correction that undoes
//! their sum.

use super::scales::{STEPS, part_of_rounding, unit_of};
use crate::scalar::Real;
use crate::solving::rounding::ROUNDINGS;
use crate::space::Array;
use crate::space::vector::{difference, sum, sum_of_products};
use crate::system::{Invariants, PhaseSpace};

/// The drift is not removed if the path from the origin is rounded so much that it no longer determines an invariant.
///
/// Compared is the rounding of an invariant at `z` by the last digits of the path. It may be at most this many times the same rounding at the origin,
/// and at most this many times the rounding by the coordinates at both ends. The bound is exceeded near a collision. It is also exceeded if one
/// coordinate has grown and another one has shrunk by orders of magnitude.
const MOST_STEEPENING: f64 = 16.0;

/// Returns the correction of `z` that gives `invariants` their values at `origin`.
///
/// The correction is a combination of gradients at `z`. They are made orthogonal by the method of E. Schmidt, Math. Ann. 63 (1907) 442, so the
/// correction of an invariant does not change the invariants before it. An invariant that has changed by more than the rounding of many steps is not
/// corrected, because the method does not keep it.
///
/// A coordinate that is equal to its value at the origin does not change. Thus a momentum without a force keeps its bits. Returns zero if
/// the correction would be longer than the rounding of many steps, or if it would increase the change of an invariant beyond rounding, as
/// at a jump.
pub(crate) fn way_back<S: PhaseSpace<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    origin: &S::Phase,
    z: &S::Phase,
) -> S::Phase {
    let moved = difference(z, origin);
    let changes = invariants.changes(system, origin, &moved);
    let mut gradients = invariants.gradients(system, z);
    let first = invariants.gradients(system, origin);
    let way = [origin.as_slice(), moved.as_slice()];
    let mut most = changes;
    for (most, gradient) in most.as_mut_slice().iter_mut().zip(I::Values::entries_of(&gradients)) {
        *most = R::from_f64(most.magnitude() + ROUNDINGS * R::epsilon() * steepness(way, gradient.as_slice()));
    }
    let mut back = S::Phase::zero();
    undo_all(
        (S::Phase::flatten_mut(I::Values::entries(&mut gradients)), S::Phase::flatten(I::Values::entries_of(&first))),
        changes.as_slice(),
        way,
        back.as_mut_slice(),
    );
    let after = invariants.changes(system, origin, &sum(&moved, &back));
    let grows = |(after, most): (&R, &R)| after.magnitude() > most.magnitude();
    if after.as_slice().iter().zip(most.as_slice()).any(grows) { S::Phase::zero() } else { back }
}

/// Writes the correction to `back`, one invariant after the other, from the gradients at `z` and at the origin. The function does not depend on the
/// system, so it is compiled once for each scalar.
#[inline(never)]
fn undo_all<R: Real>((gradients, first): (&mut [R], &[R]), changes: &[R], way: [&[R]; 2], back: &mut [R]) {
    let n = back.len();
    let mut both = gradients.chunks_exact(n).zip(first.chunks_exact(n));
    let is_lost = |(here, there): (&[R], &[R])| {
        steepness(way, here) > MOST_STEEPENING * steepness(way, there).min(steepness_at_ends(way, [there, here]))
    };
    if both.any(is_lost) {
        return;
    }
    let mut explained: f64 = 1.0;
    for (gradient, change) in gradients.chunks_exact(n).zip(changes) {
        let terms = steepness(way, gradient);
        if change.magnitude() <= most_rounding::<R>(terms) {
            explained = explained.min(part_of_rounding(*change, terms));
        }
    }
    let unit = |i: usize| unit(way, i, explained);
    for (k, change) in changes.iter().enumerate() {
        let (before, gradient) = gradients.split_at_mut(k * n);
        undo((&mut gradient[..n], *change), way, unit, before.chunks_exact(n), back);
    }
    for (i, back) in back.iter_mut().enumerate() {
        *back *= R::from_f64(unit(i));
    }
    if !back.iter().enumerate().all(|(i, x)| x.magnitude() <= most_rounding::<R>(size(way, i))) {
        back.fill(R::from_f64(0.0));
    }
}

/// Returns the largest rounding of many steps in a sum of terms of this size.
fn most_rounding<R: Real>(terms: f64) -> f64 {
    STEPS * ROUNDINGS * R::epsilon() * terms
}

/// Returns a bound of the size of coordinate `i` on a path: the sum of its magnitudes.
fn size<R: Real, const N: usize>(way: [&[R]; N], i: usize) -> f64 {
    way.iter().map(|z| z[i].magnitude()).sum()
}

/// Returns the unit of a coordinate, or zero if it has not moved. `explained` is the part of its correction that rounding explains.
fn unit<R: Real>(way: [&[R]; 2], i: usize, explained: f64) -> f64 {
    let moved = way[1][i].magnitude();
    if moved == 0.0 { 0.0 } else { unit_of(size(way, i), moved, explained) }
}

/// Returns Σ size(i)·|∂I/∂zᵢ|. The rounding of the invariant I is ε times this sum.
pub(super) fn steepness<R: Real, const N: usize>(way: [&[R]; N], gradient: &[R]) -> f64 {
    gradient.iter().enumerate().map(|(i, slope)| size(way, i) * slope.magnitude()).sum()
}

/// Returns Σ |zᵢ ∂I/∂zᵢ| over both ends of the path. The rounding of I by the coordinates at the ends is ε times this sum.
fn steepness_at_ends<R: Real>([origin, moved]: [&[R]; 2], [there, here]: [&[R]; 2]) -> f64 {
    let at = |i: usize| {
        origin[i].magnitude() * there[i].magnitude() + (origin[i] + moved[i]).magnitude() * here[i].magnitude()
    };
    (0..origin.len()).map(at).sum()
}

/// Adds to `back` the correction that undoes `change` along its gradient, if the change is rounding. `back` is in units of the coordinates.
///
/// On return, `gradient` is its own component orthogonal to `others`, in units of the coordinates. It is zero if the change is not rounding, or if the
/// gradient nearly depends on the others. The gradients of angular momentum and energy on a circular orbit are an example. A correction there would
/// amplify the rounding of one evaluation beyond the rounding of many steps.
fn undo<'a, R: Real>(
    (gradient, change): (&mut [R], R),
    way: [&[R]; 2],
    unit: impl Fn(usize) -> f64,
    others: impl Iterator<Item = &'a [R]>,
    back: &mut [R],
) {
    let most = most_rounding::<R>(steepness(way, gradient));
    let terms: f64 = gradient.iter().enumerate().map(|(i, slope)| unit(i) * slope.magnitude()).sum();
    let is_rounding = change.magnitude() <= most && terms.is_finite() && terms > 0.0;
    let scale = R::from_f64(if is_rounding { 1.0 / terms } else { 0.0 });
    for (i, slope) in gradient.iter_mut().enumerate() {
        *slope = if is_rounding { *slope * R::from_f64(unit(i)) * scale } else { scale };
    }
    let rest = change * scale + sum_of_products(gradient, back);
    let whole = sum_of_products(gradient, gradient);
    for other in others {
        let square = sum_of_products(other, other);
        if square.magnitude() > 0.0 {
            add(gradient, -(sum_of_products(gradient, other) / square), other);
        }
    }
    let square = sum_of_products(gradient, gradient);
    if square.magnitude() * STEPS > whole.magnitude() {
        add(back, -(rest / square), gradient);
    } else {
        gradient.fill(R::from_f64(0.0));
    }
}

/// x ← x + w·d.
fn add<R: Real>(x: &mut [R], w: R, d: &[R]) {
    for (x, d) in x.iter_mut().zip(d) {
        *x = w.multiply_add(*d, *x);
    }
}

/// Returns the address of the function that is compiled once for each scalar.
pub(crate) fn compiled<R: Real>() -> *const () {
    undo_all::<R> as *const ()
}

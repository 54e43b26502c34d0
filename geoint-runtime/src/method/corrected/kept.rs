//! What steps keep to rounding, kept so for ever: what rounding adds up to is taken away now and then.

use super::scales::{STEPS, part_of_rounding, unit_of};
use crate::scalar::Real;
use crate::solving::rounding::ROUNDINGS;
use crate::space::Array;
use crate::space::vector::{difference, sum, sum_of_products};
use crate::system::{Invariants, PhaseSpace};

/// Where an invariant changes so many times as much with the last digits of the way from the origin as where the run began, or as with those of
/// coordinates at both ends, nothing is settled: near a collision, or where one coordinate has grown and another one shrunk by orders of magnitude,
/// the way from there to here has lost what decides.
const STEEPER: f64 = 16.0;

/// Returns the way from `z` back to where `invariants` are what they were at `origin`, along their gradients. No invariant moves those before it
/// (E. Schmidt, Math. Ann. 63 (1907) 442). An invariant that has changed by more than the rounding of many steps is left alone: the method does
/// not keep it.
///
/// A coordinate that is where it was at the origin stays there, so that a momentum that nothing changes is the same to the last bit. The way is
/// zero if it were longer than the rounding of many steps explains, or led across a jump of an invariant.
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

/// Writes the way back from gradients here and at the origin, one invariant after the other. No system is known here: it is compiled once for a
/// scalar.
#[inline(never)]
fn undo_all<R: Real>((gradients, first): (&mut [R], &[R]), changes: &[R], way: [&[R]; 2], back: &mut [R]) {
    let n = back.len();
    let mut both = gradients.chunks_exact(n).zip(first.chunks_exact(n));
    let is_lost = |(here, there): (&[R], &[R])| {
        steepness(way, here) > STEEPER * steepness(way, there).min(of_ends(way, [there, here]))
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

/// How large a coordinate has been on a way.
fn size<R: Real, const N: usize>(way: [&[R]; N], i: usize) -> f64 {
    way.iter().map(|z| z[i].magnitude()).sum()
}

/// Returns the unit of a coordinate, of whose correction rounding explains the part `explained`; zero if it has not moved.
fn unit<R: Real>(way: [&[R]; 2], i: usize, explained: f64) -> f64 {
    let moved = way[1][i].magnitude();
    if moved == 0.0 { 0.0 } else { unit_of(size(way, i), moved, explained) }
}

/// How much an invariant changes with its coordinates, each by its size: times the last digit this is its rounding.
pub(super) fn steepness<R: Real, const N: usize>(way: [&[R]; N], gradient: &[R]) -> f64 {
    gradient.iter().enumerate().map(|(i, slope)| size(way, i) * slope.magnitude()).sum()
}

/// The same with its coordinates at both ends alone: by this much an invariant is rounded itself.
fn of_ends<R: Real>([origin, moved]: [&[R]; 2], [there, here]: [&[R]; 2]) -> f64 {
    let at = |i: usize| {
        origin[i].magnitude() * there[i].magnitude() + (origin[i] + moved[i]).magnitude() * here[i].magnitude()
    };
    (0..origin.len()).map(at).sum()
}

/// Adds to the way `back`, in units of coordinates, what undoes a change along its gradient, if the change is rounding. What is left of the gradient
/// is the direction in which `others` do not change.
///
/// There is none where it nearly depends on them, as that of an angular momentum does on that of the energy on a circle: the rounding of one
/// evaluation would grow beyond that of as many steps.
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

/// x + w·d.
fn add<R: Real>(x: &mut [R], w: R, d: &[R]) {
    for (x, d) in x.iter_mut().zip(d) {
        *x = w.multiply_add(*d, *x);
    }
}

/// The address of what is compiled once for a scalar.
pub(crate) fn compiled<R: Real>() -> *const () {
    undo_all::<R> as *const ()
}

//! What steps keep to rounding, kept so for ever: what rounding adds up to is taken away now and then.

use super::scales::STEPS;
use crate::scalar::Real;
use crate::solving::rounding::ROUNDINGS;
use crate::space::Array;
use crate::space::vector::{difference, sum_of_products};
use crate::system::{Invariants, PhaseSpace};

/// Where an invariant changes so many times as much with the last digits of the way from the origin as where the run began, or as with those of
/// coordinates at both ends, nothing is settled: near a collision, or where one coordinate has grown and another one shrunk by orders of magnitude,
/// the way from there to here has lost what decides.
const STEEPER: f64 = 16.0;

/// What leads from `z` back to where `invariants` are what they were at `origin`, along their gradients: none moves the ones before it (E. Schmidt,
/// Math. Ann. 63 (1907) 442). One that has changed by more than the rounding of many steps is left alone: the method does not keep it.
///
/// A coordinate that is where it was at the origin stays there, so that a momentum that nothing changes is the same to the last bit.
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
    let mut back = S::Phase::zero();
    undo_all(
        (S::Phase::flatten_mut(I::Values::entries(&mut gradients)), S::Phase::flatten(I::Values::entries_of(&first))),
        changes.as_slice(),
        [origin.as_slice(), moved.as_slice()],
        back.as_mut_slice(),
    );
    back
}

/// The way back from gradients here and at the origin, one after the other. No system is known here: it is compiled once for a scalar.
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
    for (k, change) in changes.iter().enumerate() {
        let (before, gradient) = gradients.split_at_mut(k * n);
        undo((&mut gradient[..n], *change), way, before.chunks_exact(n), back);
    }
    for (i, back) in back.iter_mut().enumerate() {
        *back *= R::from_f64(unit(way, i));
    }
    if !back.iter().all(|x| x.magnitude().is_finite()) {
        back.fill(R::from_f64(0.0));
    }
}

/// How large a coordinate has been on a way.
fn size<R: Real, const N: usize>(way: [&[R]; N], i: usize) -> f64 {
    way.iter().map(|z| z[i].magnitude()).sum()
}

/// What a coordinate is measured in: its distance from zero may mean nothing.
fn unit<R: Real>(way: [&[R]; 2], i: usize) -> f64 {
    f64::min(size(way, i), STEPS * way[1][i].magnitude())
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
    others: impl Iterator<Item = &'a [R]>,
    back: &mut [R],
) {
    let most = STEPS * ROUNDINGS * R::epsilon() * steepness(way, gradient);
    let terms: f64 = gradient.iter().enumerate().map(|(i, slope)| unit(way, i) * slope.magnitude()).sum();
    let is_rounding = change.magnitude() <= most && terms.is_finite() && terms > 0.0;
    let scale = R::from_f64(if is_rounding { 1.0 / terms } else { 0.0 });
    for (i, slope) in gradient.iter_mut().enumerate() {
        *slope = if is_rounding { *slope * R::from_f64(unit(way, i)) * scale } else { scale };
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

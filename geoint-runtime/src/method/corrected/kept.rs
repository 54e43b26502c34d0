//! What steps keep to rounding, kept so for ever: what rounding adds up to is taken away now and then.

use super::scales::STEPS;
use crate::scalar::Real;
use crate::solving::rounding::ROUNDINGS;
use crate::space::Array;
use crate::space::vector::difference;
use crate::system::{Invariants, PhaseSpace};

/// A correction of one invariant changes the others, which are corrected again (S. Kaczmarz, Bull. Acad. Polon. Sci. A 35 (1937) 355).
const SWEEPS: usize = 8;

/// Where an invariant changes so many times as much with the last digits of coordinates as where the run began, it is not settled: near a
/// collision the way from there to here has lost what decides.
const STEEPER: f64 = 16.0;

/// What leads from `z` back to where `invariants` are what they were at `origin`, along their gradients. Nothing where they differ by more than
/// rounding of many steps: then it is not rounding.
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
    let gradients = invariants.gradients(system, z);
    let first = invariants.gradients(system, origin);
    let points = [origin.as_slice(), moved.as_slice()];
    let both = I::Values::entries_of(&gradients).iter().zip(I::Values::entries_of(&first));
    for (here, there) in both {
        if is_steeper(points, [here.as_slice(), there.as_slice()]) {
            return S::Phase::zero();
        }
    }
    let mut back = S::Phase::zero();
    for _ in 0..SWEEPS {
        for (gradient, change) in I::Values::entries_of(&gradients).iter().zip(changes.as_slice()) {
            if !undo((gradient.as_slice(), *change), points, back.as_mut_slice()) {
                return S::Phase::zero();
            }
        }
    }
    if back.is_finite() { back } else { S::Phase::zero() }
}

/// Whether the last digits of coordinates change an invariant much more by the first gradient than by the second.
#[inline(never)]
fn is_steeper<R: Real>([origin, moved]: [&[R]; 2], gradients: [&[R]; 2]) -> bool {
    let [here, there] = gradients.map(|gradient| {
        let terms = gradient.iter().enumerate();
        terms.map(|(i, slope)| (origin[i].magnitude() + moved[i].magnitude()) * slope.magnitude()).sum::<f64>()
    });
    here > STEEPER * there
}

/// Adds to the way `back` what undoes the rest of a change along a gradient; whether the change is rounding.
#[inline(never)]
fn undo<R: Real>((gradient, change): (&[R], R), [origin, moved]: [&[R]; 2], back: &mut [R]) -> bool {
    let unit = |i: usize| {
        let size = origin[i].magnitude() + moved[i].magnitude();
        (size, f64::min(size, STEPS * moved[i].magnitude()))
    };
    let (mut rest, mut rounding, mut terms) = (change, 0.0, 0.0);
    for (i, slope) in gradient.iter().enumerate() {
        let (size, unit) = unit(i);
        rounding += size * slope.magnitude();
        terms += unit * slope.magnitude();
        rest += *slope * back[i];
    }
    // Rounding of as many steps. Not a number is no rounding either.
    if !(change.magnitude() <= STEPS * ROUNDINGS * R::epsilon() * rounding && terms.is_finite()) {
        return false;
    }
    // Where the gradient vanishes there is nothing to do.
    let [scale, mut square] = [R::from_f64(if terms > 0.0 { 1.0 / terms } else { 0.0 }), R::from_f64(0.0)];
    for (i, slope) in gradient.iter().enumerate() {
        let part = *slope * R::from_f64(unit(i).1) * scale;
        square += part * part;
    }
    if square.magnitude() > 0.0 {
        let multiplier = rest * scale / square;
        for (i, slope) in gradient.iter().enumerate() {
            let unit = R::from_f64(unit(i).1);
            back[i] += -(multiplier * unit * (*slope * unit * scale));
        }
    }
    true
}

/// The address of what is compiled once for a scalar.
pub(crate) fn compiled<R: Real>() -> *const () {
    undo::<R> as *const ()
}

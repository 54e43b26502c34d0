//! What steps keep to rounding, kept so for ever: what rounding adds up to is taken away now and then.

use super::frame::Frame;
use super::scales::Scales;
use crate::scalar::{Real, zero};
use crate::solving::rounding::ROUNDINGS;
use crate::space::Array;
use crate::space::vector::{difference, opposite};
use crate::system::{Invariants, PhaseSpace};

/// Steps in which rounding adds up.
const STEPS: f64 = 1024.0;

/// What leads from `z` back to where `invariants` are what they were at `origin`, along their gradients. Nothing where they differ by more than
/// rounding of many steps: then it is not rounding.
///
/// A coordinate that is where it was at the origin stays there, so that a momentum that nothing changes is the same to the last bit.
#[cold]
#[inline(never)]
pub(crate) fn way_back<S: PhaseSpace<R>, R: Real, I: Invariants<S, R>>(
    system: &S,
    invariants: &I,
    origin: &S::Phase,
    z: &S::Phase,
) -> S::Phase {
    let mut scales = Scales::new();
    let moved = difference(z, origin);
    scales.include(origin, &moved);
    let mut units = scales.units();
    for (unit, moved) in units.entries().iter_mut().zip(moved.as_slice()) {
        if moved.magnitude() == 0.0 {
            *unit = zero();
        }
    }
    let frame = Frame::<I::Values, S::Phase>::new(invariants.gradients(system, z), units, &scales.sizes);
    let mut changes = invariants.changes(system, origin, &moved);
    // Not a number is no rounding either.
    let is_rounding = frame.multipliers(&mut changes) <= STEPS * ROUNDINGS * R::epsilon();
    let back = opposite(&frame.back(&changes));
    if is_rounding && back.is_finite() { back } else { S::Phase::zero() }
}

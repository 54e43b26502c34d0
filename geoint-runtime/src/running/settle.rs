//! Removes the drift by rounding over many steps.

use crate::method::Method;
use crate::scalar::Real;
use crate::space::{Point, Snapshot, Summation, normalisation};
use crate::system::PhaseSpace;

/// Number of steps between two removals of drift, and between two checks that the state is finite. A non-finite number remains so under every flow q
/// ← q + …, p ← p + …, so rare checks find it.
pub(super) const STEPS_BETWEEN_CHECKS: u64 = 1024;

/// Returns whether there is drift to remove: attitudes, or invariants that the method keeps.
pub(super) const fn has_drift<S: PhaseSpace<R>, M: Method<S, R>, R: Real>() -> bool {
    S::State::ATTITUDES || M::HANDLING.keeps_invariants
}

/// Returns the point with attitudes normalised to length 1, and with the kept invariants at their values at the origin of the run.
pub(super) fn without_drift<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>>(
    (system, prepared): (&S, &M::Prepared),
    origin: &S::Phase,
    x: &Point<S::Phase, C, S::Action>,
) -> Point<S::Phase, C, S::Action> {
    let mut x = *x;
    if S::State::ATTITUDES {
        x.add(&normalisation::<S, R>(&x.z));
    }
    if M::HANDLING.keeps_invariants {
        x.add(&M::way_back(prepared, system, origin, &x.z));
    }
    x
}

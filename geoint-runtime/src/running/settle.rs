//! What rounding changes over many steps, taken away.

use crate::method::Method;
use crate::scalar::Real;
use crate::space::{Point, Snapshot, Summation, normalisation};
use crate::system::PhaseSpace;

/// Steps between two times that a run is settled, and between two looks at whether its state is still finite. A number that is not finite stays so
/// under every flow q ← q + …, p ← p + …, so looking now and then misses nothing; the price of a look is paid once in so many steps.
pub(super) const STEPS_BETWEEN_LOOKS: u64 = 1024;

/// Whether there is anything to settle.
pub(super) const fn settles<S: PhaseSpace<R>, M: Method<S, R>, R: Real>() -> bool {
    S::State::ATTITUDES || M::KEEPS
}

/// The point with attitudes of length 1, and what the method keeps as it was at the origin.
pub(super) fn settled<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>>(
    (system, prepared): (&S, &M::Prepared),
    origin: &S::Phase,
    x: &Point<S::Phase, C, S::Action>,
) -> Point<S::Phase, C, S::Action> {
    let mut x = *x;
    if S::State::ATTITUDES {
        x.add(&normalisation::<S, R>(&x.z));
    }
    if M::KEEPS {
        x.add(&M::way_back(prepared, system, origin, &x.z));
    }
    x
}

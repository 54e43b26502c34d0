//! What sees the points at which a step evaluates the energy.

use crate::scalar::Real;
use crate::solving::Refusal;
use crate::system::PhaseSpace;

/// Is shown every point at which a step evaluates the energy.
pub trait Probe<S: PhaseSpace<R>, R: Real> {
    /// Whether a step that finds no solution is to search for one from afar. What is searched for has to be in memory, which all
    /// other steps would pay for: the fast path refuses, and the step is repeated, watched.
    const PATIENT: bool = true;

    /// The energy is about to be evaluated here.
    fn visit(&mut self, t: R, q: &S::Array, p: &S::Array, s: &S::Action);

    /// An exact flow of a piece of the energy has been applied, with a result that is finite or not.
    #[inline(always)]
    fn flown(&mut self, piece: &'static str, finite: impl FnOnce() -> bool) {
        let _ = (piece, finite);
    }
}

/// Sees nothing: the probe of the fast path.
#[derive(Clone, Copy, Debug)]
pub struct Unwatched;

impl<S: PhaseSpace<R>, R: Real> Probe<S, R> for Unwatched {
    const PATIENT: bool = false;

    #[inline(always)]
    fn visit(&mut self, _: R, _: &S::Array, _: &S::Array, _: &S::Action) {}
}

/// Whether the energy is defined at the end of a step, and on the same side of its poles as at the start, for methods that look at
/// it in between only.
#[inline(always)]
pub(crate) fn check_end<S: PhaseSpace<R>, R: Real>(
    system: &S,
    t: [R; 2],
    q: [&S::Array; 2],
    p: [&S::Array; 2],
    s: [&S::Action; 2],
) -> Result<(), Refusal> {
    Refusal::outside(system.outside_domain(t[1], q[1], p[1], s[1]))?;
    Refusal::outside(system.pole_between(t, q, p, s))
}

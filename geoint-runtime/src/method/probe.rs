//! What sees the points at which a step evaluates the energy.

use crate::scalar::Real;
use crate::solving::Refusal;
use crate::system::{Ends, Guarded, PhaseSpace};

/// Sees every point at which a step looks at the energy.
pub trait Probe<S: PhaseSpace<R>, R: Real> {
    /// Whether a step that finds no solution is to search for one from afar. What is searched for has to be in memory, which all
    /// other steps would pay for: the fast path refuses, and the step is repeated, watched.
    const PATIENT: bool = true;

    /// The energy is about to be looked at here.
    fn look(&mut self, t: R, q: &S::Array, p: &S::Array, s: &S::Action);

    /// The same, where there is no action.
    #[inline(always)]
    fn visit(&mut self, t: R, q: &S::Array, p: &S::Array)
    where
        S: PhaseSpace<R, Action = ()>,
    {
        self.look(t, q, p, &());
    }

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
    fn look(&mut self, _: R, _: &S::Array, _: &S::Array, _: &S::Action) {}
}

/// Whether the energy is defined at the end of a step, and has no pole on the way there, for methods that look at it in between only.
#[inline(always)]
pub(crate) fn check_end<S: PhaseSpace<R>, R: Real>(guarded: &Guarded<S>, ends: Ends<'_, S, R>) -> Result<(), Refusal> {
    let (t, q, p, s) = ends;
    Refusal::outside(guarded.system.outside_domain(t[1], q[1], p[1], s[1]))?;
    Refusal::outside(guarded.pole_between(false, ends))
}

//! What a method is: coefficients prepared once for a step size, and a step in place.

use crate::real::Real;
use crate::system::Hamiltonian;

/// What a method promises; the tests run over the list of all methods and hold each to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Claims {
    /// Global error O(hᵖ).
    pub order: u32,
    /// Φ(−h) ∘ Φ(h) is the identity.
    pub symmetric: bool,
    /// The step is a symplectic map.
    pub symplectic: bool,
    /// The step keeps H of an autonomous system to rounding.
    pub conserves_energy: bool,
}

/// A one-step method for the system `S`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a method for `{S}`",
    note = "a composition becomes a method with the map that it composes: `Yoshida4.of(StormerVerlet)`",
    note = "`Gauss` has 1 to 6 stages"
)]
pub trait Method<S: Hamiltonian<R>, R: Real = f64>: Copy {
    /// Everything that depends on the method, the parameters and h.
    type Prepared: Copy;

    /// What the method promises.
    fn claims(&self) -> Claims;

    /// Coefficients for steps of length `h`.
    fn prepare(&self, system: &S, h: R) -> Self::Prepared;

    /// One step from time `t`, in place.
    ///
    /// Every point at which the energy is looked at is shown to `probe`.
    fn step<P: Probe<S, R>>(
        prepared: &Self::Prepared,
        t: R,
        q: &mut S::Array,
        p: &mut S::Array,
        probe: &mut P,
    ) -> Result<(), NotConverged>;

    /// `steps` steps, of which the `i`-th starts at `clock.at(i)`.
    #[inline(always)]
    fn advance(
        prepared: &Self::Prepared,
        clock: &Clock<R>,
        steps: u64,
        q: &mut S::Array,
        p: &mut S::Array,
    ) -> Result<(), NotConverged> {
        for i in 0..steps {
            Self::step(prepared, clock.at(i), q, p, &mut Unwatched)?;
        }
        Ok(())
    }
}

/// The times at which steps start.
#[derive(Clone, Copy, Debug)]
pub struct Clock<R> {
    pub(crate) t0: R,
    pub(crate) h: R,
    pub(crate) first: u64,
}

impl<R: Real> Clock<R> {
    /// The time at which step `i` starts: t₀ + (n + i)·h.
    #[inline(always)]
    pub fn at(&self, i: u64) -> R {
        R::time(self.t0, self.first + i, self.h)
    }
}

/// Newton's iteration gave up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotConverged {
    /// Iterations spent.
    pub iterations: u32,
    /// The last correction relative to the increment.
    pub correction: f64,
}

/// Sees every point at which a step looks at the energy.
pub trait Probe<S: Hamiltonian<R>, R: Real> {
    /// The energy is about to be looked at here.
    fn visit(&mut self, t: R, q: &S::Array, p: &S::Array);
}

/// Sees nothing: the probe of the fast path.
#[derive(Clone, Copy, Debug)]
pub struct Unwatched;

impl<S: Hamiltonian<R>, R: Real> Probe<S, R> for Unwatched {
    #[inline(always)]
    fn visit(&mut self, _: R, _: &S::Array, _: &S::Array) {}
}

/// Remembers the first point outside the domain of the energy.
pub(crate) struct DomainWatch<'a, S> {
    pub(crate) system: &'a S,
    pub(crate) found: Option<&'static str>,
}

impl<S: Hamiltonian<R>, R: Real> Probe<S, R> for DomainWatch<'_, S> {
    fn visit(&mut self, t: R, q: &S::Array, p: &S::Array) {
        if self.found.is_none() {
            self.found = self.system.outside_domain(t, q, p);
        }
    }
}

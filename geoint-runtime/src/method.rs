//! What a method is: coefficients prepared once for a step size, and a step in place.

use crate::point::{Point, Summation};
use crate::real::Real;
use crate::system::Hamiltonian;

/// What a method promises where nothing is damped; the tests run over the list of all methods and hold each to it.
///
/// Damping leaves order and symmetry as they are. The step is then no symplectic map, and the energy falls.
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
    /// Everything that depends on the method, the parameters and h; and what implicit methods remember of earlier steps to
    /// guess the next one.
    type Prepared: Copy;

    /// What the method promises.
    fn claims(&self) -> Claims;

    /// Coefficients for steps of length `h`.
    fn prepare(&self, system: &S, h: R) -> Self::Prepared;

    /// One step from time `t`, in place.
    ///
    /// Every point at which the energy is looked at is shown to `probe`.
    fn step<C: Summation<S::Array>, P: Probe<S, R>>(
        prepared: &mut Self::Prepared,
        t: R,
        x: &mut Point<S::Array, C>,
        probe: &mut P,
    ) -> Result<(), Refusal>;

    /// `steps` steps, of which the `i`-th starts at `clock.at(i)`.
    #[inline(always)]
    fn advance<C: Summation<S::Array>>(
        prepared: &mut Self::Prepared,
        clock: &Clock<R>,
        steps: u64,
        x: &mut Point<S::Array, C>,
    ) -> Result<(), Refusal> {
        for i in 0..steps {
            let t = clock.at(i) + x.ahead;
            Self::step(prepared, t, x, &mut Unwatched)?;
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

/// Why a step has no result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refusal {
    /// The iteration gave up.
    NotConverged {
        /// Iterations spent.
        iterations: u32,
        /// The last correction relative to what it corrects.
        correction: f64,
    },
    /// The equation of the step has no solution that is continuous in h from h = 0 on: its matrix is singular, or changed its
    /// orientation on the way.
    Singular,
    /// An increment is orthogonal to the direction along which it is to change the energy.
    SingularDirection,
    /// The energy is not defined, or has a pole, on the way.
    OutsideDomain {
        /// The function and the term.
        what: &'static str,
    },
}

impl Refusal {
    /// Nothing wrong if nothing was found.
    #[inline(always)]
    pub(crate) fn outside(found: Option<&'static str>) -> Result<(), Refusal> {
        found.map_or(Ok(()), |what| Err(Refusal::OutsideDomain { what }))
    }
}

/// Whether the energy is defined at the end of a step, and on the same side of its poles as at the start, for methods that look at
/// it in between only.
#[inline(always)]
pub(crate) fn check_end<S: Hamiltonian<R>, R: Real>(
    system: &S,
    t: [R; 2],
    [q0, p0]: [&S::Array; 2],
    [q1, p1]: [&S::Array; 2],
) -> Result<(), Refusal> {
    Refusal::outside(system.outside_domain(t[1], q1, p1))?;
    Refusal::outside(system.pole_between(t, [q0, q1], [p0, p1]))
}

/// Sees every point at which a step looks at the energy.
pub trait Probe<S: Hamiltonian<R>, R: Real> {
    /// Whether a step that finds no solution is to search for one from afar. What is searched for has to be in memory, which all
    /// other steps would pay for: the fast path refuses, and the step is repeated, watched.
    const PATIENT: bool = true;

    /// The energy is about to be looked at here.
    fn visit(&mut self, t: R, q: &S::Array, p: &S::Array);
}

/// Sees nothing: the probe of the fast path.
#[derive(Clone, Copy, Debug)]
pub struct Unwatched;

impl<S: Hamiltonian<R>, R: Real> Probe<S, R> for Unwatched {
    const PATIENT: bool = false;

    #[inline(always)]
    fn visit(&mut self, _: R, _: &S::Array, _: &S::Array) {}
}

/// Remembers the first point outside the domain of the energy, or beyond a pole as seen from the start of the step.
pub(crate) struct DomainWatch<'a, S, A, R> {
    system: &'a S,
    start: (R, A, A),
    found: Option<&'static str>,
}

impl<'a, S: Hamiltonian<R>, R: Real> DomainWatch<'a, S, S::Array, R> {
    pub(crate) fn new<C>(system: &'a S, t: R, x: &Point<S::Array, C>) -> Self {
        DomainWatch { system, start: (t, x.q, x.p), found: None }
    }

    /// What explains best why a step was refused.
    pub(crate) fn reason(&self, refusal: Option<Refusal>) -> Option<&'static str> {
        match refusal {
            Some(Refusal::OutsideDomain { what }) => Some(what),
            _ => self.found,
        }
    }
}

impl<S: Hamiltonian<R>, R: Real> Probe<S, R> for DomainWatch<'_, S, S::Array, R> {
    fn visit(&mut self, t: R, q: &S::Array, p: &S::Array) {
        if self.found.is_none() {
            let (t0, q0, p0) = &self.start;
            let pole = || self.system.pole_between([*t0, t], [q0, q], [p0, p]);
            self.found = self.system.outside_domain(t, q, p).or_else(pole);
        }
    }
}

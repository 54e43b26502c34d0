//! What a method is: coefficients prepared once for a step size, and a step in place.

use crate::point::{Point, Summation};
use crate::real::Real;
use crate::system::PhaseSpace;

/// What a method promises where nothing is damped; the tests run over the list of all methods and hold each to it.
///
/// Damping leaves order and symmetry as they are. The step is then no symplectic map, and the energy falls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Claims {
    /// Global error O(hᵖ).
    pub order: u32,
    /// Φ(−h) ∘ Φ(h) is the identity.
    pub symmetric: bool,
    /// The step is a symplectic map; of a contact system a contact map, which multiplies the form ds − p dq by a positive factor.
    pub symplectic: bool,
    /// The step keeps H of an autonomous system to rounding; of a contact system it keeps the law of its decay, as that of
    /// [`ContactDiscreteGradient`](crate::ContactDiscreteGradient), H₁ = H₀ exp(−h g_s).
    pub conserves_energy: bool,
}

/// A one-step method for the system `S`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a method for `{S}`",
    note = "a composition becomes a method with the map that it composes: `Yoshida4.of(StormerVerlet)`",
    note = "`Gauss` has 1 to 6 stages"
)]
pub trait Method<S: PhaseSpace<R>, R: Real = f64>: Copy {
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
        x: &mut Point<S::Array, C, S::Action>,
        probe: &mut P,
    ) -> Result<(), Refusal>;

    /// `steps` steps, of which the `i`-th starts at `clock.at(i)`.
    #[inline(always)]
    fn advance<C: Summation<S::Array>>(
        prepared: &mut Self::Prepared,
        clock: &Clock<R>,
        steps: u64,
        x: &mut Point<S::Array, C, S::Action>,
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

/// Remembers the first point outside the domain of the energy, or beyond a pole as seen from the start of the step; or the first flow
/// that ended before it was through.
pub(crate) struct Watch<'a, S, X> {
    system: &'a S,
    start: X,
    found: Option<Found>,
}

/// What a watch has seen first.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Found {
    /// The energy is not defined.
    OutsideDomain(&'static str),
    /// The flow of this piece ends.
    Pole(&'static str),
}

/// Where a step starts: its time, and q, p, s.
type Start<S, R> = (R, <S as PhaseSpace<R>>::Array, <S as PhaseSpace<R>>::Array, <S as PhaseSpace<R>>::Action);

impl<'a, S: PhaseSpace<R>, R: Real> Watch<'a, S, Start<S, R>> {
    pub(crate) fn new<C>(system: &'a S, t: R, x: &Point<S::Array, C, S::Action>) -> Self {
        Watch { system, start: (t, x.q, x.p, x.s), found: None }
    }
}

impl<S, X> Watch<'_, S, X> {
    /// What explains best why a step was refused.
    pub(crate) fn reason(&self, refusal: Option<Refusal>) -> Option<Found> {
        match refusal {
            Some(Refusal::OutsideDomain { what }) => Some(Found::OutsideDomain(what)),
            _ => self.found,
        }
    }
}

impl<S: PhaseSpace<R>, R: Real> Probe<S, R> for Watch<'_, S, Start<S, R>> {
    fn look(&mut self, t: R, q: &S::Array, p: &S::Array, s: &S::Action) {
        if self.found.is_none() {
            let (t0, q0, p0, s0) = &self.start;
            let pole = || self.system.pole_between([*t0, t], [q0, q], [p0, p], [s0, s]);
            self.found = self.system.outside_domain(t, q, p, s).or_else(pole).map(Found::OutsideDomain);
        }
    }

    fn flown(&mut self, piece: &'static str, finite: impl FnOnce() -> bool) {
        if self.found.is_none() && !finite() {
            self.found = Some(Found::Pole(piece));
        }
    }
}

//! What explains a refused step: the step is repeated, and every point at which it evaluates the energy is examined.

use crate::method::Probe;
use crate::running::error::StepError;
use crate::scalar::Real;
use crate::solving::Refusal;
use crate::solving::equation::Observer;
use crate::space::Point;
use crate::system::{Evaluations, Known, PhaseSpace, Poles};

/// Remembers the first point outside the domain of the energy, or beyond a pole as seen from the start of the step; or the first flow
/// that ended before it was through.
pub(crate) struct Watch<'a, S, X> {
    system: &'a S,
    poles: Poles,
    start: X,
    seen: Seen,
    paused: bool,
}

/// What a watch has seen. No system is known here: it is compiled once for all of them.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Seen {
    found: Option<Found>,
    /// The first term that was evaluated where it has no derivative.
    edge: Option<&'static str>,
}

/// What a watch has seen first.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Found {
    /// The energy is not defined.
    OutsideDomain(&'static str),
    /// The flow of this piece ends.
    Pole(&'static str),
    /// The equation of this plane was not solved.
    Unsolved(&'static str),
}

/// Where a step starts: its time, and q, p, s.
type Start<S, R> = (R, <S as PhaseSpace<R>>::Phase, <S as PhaseSpace<R>>::Action);

impl<'a, S: PhaseSpace<R>, R: Real> Watch<'a, S, Start<S, R>> {
    pub(crate) fn new<C>(system: &'a S, t: R, x: &Point<S::Phase, C, S::Action>) -> Self {
        Watch { system, poles: Poles::of(system), start: (t, x.z, x.s), seen: Seen::default(), paused: false }
    }
}

impl<S: PhaseSpace<R>, R: Real> Watch<'_, S, Start<S, R>> {
    #[inline(always)]
    fn examine(&mut self, t: R, z: &S::Phase, s: &S::Action) {
        if self.looks() {
            let (t0, z0, s0) = &self.start;
            let pole = || self.poles.between(self.system, Evaluations::AtPoints, ([*t0, t], [z0, z], [s0, s]));
            self.seen.found = self.system.outside_domain(t, z, s).or_else(pole).map(Found::OutsideDomain);
            self.seen.edge = self.seen.edge.or_else(|| self.system.edge(t, z, s));
        }
    }

    /// The same, here once: a step evaluates the energy in many places, and what is asked of poles is long.
    #[cold]
    #[inline(never)]
    fn examine_apart(&mut self, t: R, z: &S::Phase, s: &S::Action) {
        self.examine(t, z, s);
    }
}

impl<S, X> Watch<'_, S, X> {
    /// Whether what it sees now may explain the step.
    fn looks(&self) -> bool {
        self.seen.found.is_none() && !self.paused
    }

    /// What it has seen.
    pub(crate) fn seen(&self) -> Seen {
        self.seen
    }
}

impl Seen {
    /// Why a step from a time on has no good end.
    #[cold]
    #[inline(never)]
    pub(crate) fn error(self, outcome: Result<(), Refusal>, t: f64) -> StepError {
        match (outcome, self.reason(outcome.err())) {
            (_, Some(Found::OutsideDomain(what))) => StepError::OutsideDomain { t, what },
            (_, Some(Found::Pole(piece))) => StepError::Pole { t, piece },
            (_, Some(Found::Unsolved(plane))) => StepError::Unsolved { t, plane },
            (Ok(()), None) => StepError::NonFinite { t },
            (Err(refusal), None) => StepError::refused(refusal, t),
        }
    }

    /// What explains best why a step was refused.
    pub(crate) fn reason(self, refusal: Option<Refusal>) -> Option<Found> {
        match refusal {
            Some(Refusal::OutsideDomain { what }) => Some(Found::OutsideDomain(what)),
            // A step may end at an edge: that explains nothing but numbers that are none.
            None | Some(Refusal::NotConverged { .. } | Refusal::Singular) => {
                self.found.or(self.edge.map(Found::OutsideDomain))
            }
            _ => self.found,
        }
    }
}

impl<S, X> Observer for Watch<'_, S, X> {
    fn pause(&mut self, paused: bool) {
        self.paused = paused;
    }
}

impl<S: PhaseSpace<R>, R: Real> Probe<S, R> for Watch<'_, S, Start<S, R>> {
    fn visit(&mut self, t: R, z: &S::Phase, s: &S::Action) {
        if Known::<S, R>::NONE { self.examine(t, z, s) } else { self.examine_apart(t, z, s) }
    }

    fn flown(&mut self, piece: &'static str, finite: impl FnOnce() -> bool) {
        // What is not defined at the start, as with parameters that are no numbers, has no flow that could end.
        let (t, z, s) = &self.start;
        let defined = || self.system.hamiltonian(*t, z, s).magnitude() < f64::INFINITY;
        if self.looks() && !finite() && defined() {
            self.seen.found = Some(Found::Pole(piece));
        }
    }

    fn unsolved(&mut self, plane: &'static str) {
        if self.looks() {
            self.seen.found = Some(self.seen.edge.map_or(Found::Unsolved(plane), Found::OutsideDomain));
        }
    }
}

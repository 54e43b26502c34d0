//! Finds the cause of a refused step: the step is repeated, and every point at which it evaluates the energy is checked.

use crate::method::Probe;
use crate::scalar::Real;
use crate::solving::Failure;
use crate::solving::equation::Observer;
use crate::space::Point;
use crate::system::{Evaluations, Known, PhaseSpace, Poles};

/// Records the first cause: a point outside the domain of the energy, a pole between the start of the step and a point, or a flow that ended early.
pub(crate) struct Watch<'a, S, X> {
    system: &'a S,
    poles: Poles,
    start: X,
    seen: Seen,
    paused: bool,
}

/// Findings of the checks. The type does not depend on the system, so its code is compiled once.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Seen {
    /// First cause that was found.
    found: Option<Failure>,
    /// First term that was evaluated where it has no derivative.
    edge: Option<&'static str>,
}

/// Start of a step: its time, z = (q, p), and s.
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
            self.seen.found = self.system.outside_domain(t, z, s).or_else(pole).map(outside);
            self.seen.edge = self.seen.edge.or_else(|| self.system.edge(t, z, s));
        }
    }

    /// Calls `examine` without inlining, because a step evaluates the energy in many places.
    #[cold]
    #[inline(never)]
    fn examine_apart(&mut self, t: R, z: &S::Phase, s: &S::Action) {
        self.examine(t, z, s);
    }
}

impl<S, X> Watch<'_, S, X> {
    /// Returns whether a check is due: no cause is known yet, and checks are not paused.
    fn looks(&self) -> bool {
        self.seen.found.is_none() && !self.paused
    }

    /// Returns the findings.
    pub(crate) fn seen(&self) -> Seen {
        self.seen
    }
}

impl Seen {
    /// Returns the most likely failure of a step without a good end: the cause that was found, or else the failure that the method returned.
    #[cold]
    #[inline(never)]
    pub(crate) fn failure(self, of_method: Option<Failure>) -> Failure {
        let cause = match of_method {
            Some(Failure::OutsideDomain { .. }) => of_method,
            // A step may end on the boundary of the domain. Report the boundary as the cause only if there is no finite or converged result.
            None | Some(Failure::NotConverged { .. } | Failure::Singular) => self.cause(),
            _ => self.found,
        };
        cause.or(of_method).unwrap_or(Failure::NonFinite)
    }

    /// Returns the cause that was found, or else the boundary of the domain, if the step meets it.
    pub(crate) fn cause(self) -> Option<Failure> {
        self.found.or(self.edge.map(outside))
    }
}

fn outside(what: &'static str) -> Failure {
    Failure::OutsideDomain { what }
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
        // If the energy is undefined at the start, for example with parameters that are not numbers, there is no flow that could end.
        let (t, z, s) = &self.start;
        let defined = || self.system.hamiltonian(*t, z, s).magnitude() < f64::INFINITY;
        if self.looks() && !finite() && defined() {
            self.seen.found = Some(Failure::Pole { piece });
        }
    }

    fn unsolved(&mut self, plane: &'static str) {
        if self.looks() {
            self.seen.found = Some(self.seen.edge.map_or(Failure::Unsolved { plane }, outside));
        }
    }
}

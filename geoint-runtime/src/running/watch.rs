//! What explains a refused step: the step is repeated, and every point at which it evaluates the energy is examined.

use crate::method::Probe;
use crate::scalar::Real;
use crate::solving::Refusal;
use crate::space::Point;
use crate::system::{Known, PhaseSpace, Poles};

/// Remembers the first point outside the domain of the energy, or beyond a pole as seen from the start of the step; or the first flow
/// that ended before it was through.
pub(crate) struct Watch<'a, S, X> {
    system: &'a S,
    poles: Poles,
    start: X,
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
}

/// Where a step starts: its time, and q, p, s.
type Start<S, R> = (R, <S as PhaseSpace<R>>::Phase, <S as PhaseSpace<R>>::Action);

impl<'a, S: PhaseSpace<R>, R: Real> Watch<'a, S, Start<S, R>> {
    pub(crate) fn new<C>(system: &'a S, t: R, x: &Point<S::Phase, C, S::Action>) -> Self {
        Watch { system, poles: Poles::of(system), start: (t, x.z, x.s), found: None, edge: None }
    }
}

impl<S: PhaseSpace<R>, R: Real> Watch<'_, S, Start<S, R>> {
    #[inline(always)]
    fn examine(&mut self, t: R, z: &S::Phase, s: &S::Action) {
        if self.found.is_none() {
            let (t0, z0, s0) = &self.start;
            let pole = || self.poles.between(self.system, false, ([*t0, t], [z0, z], [s0, s]));
            self.found = self.system.outside_domain(t, z, s).or_else(pole).map(Found::OutsideDomain);
            self.edge = self.edge.or_else(|| self.system.edge(t, z, s));
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
    /// What explains best why a step was refused.
    pub(crate) fn reason(&self, refusal: Option<Refusal>) -> Option<Found> {
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

impl<S: PhaseSpace<R>, R: Real> Probe<S, R> for Watch<'_, S, Start<S, R>> {
    fn visit(&mut self, t: R, z: &S::Phase, s: &S::Action) {
        if Known::<S, R>::NONE { self.examine(t, z, s) } else { self.examine_apart(t, z, s) }
    }

    fn flown(&mut self, piece: &'static str, finite: impl FnOnce() -> bool) {
        // What is not defined at the start, as with parameters that are no numbers, has no flow that could end.
        let (t, z, s) = &self.start;
        let defined = || self.system.hamiltonian(*t, z, s).magnitude() < f64::INFINITY;
        if self.found.is_none() && !finite() && defined() {
            self.found = Some(Found::Pole(piece));
        }
    }
}

//! H = A + B as a system of drifts and kicks: the flow of A is the drift, the flow of B is the kick.

use crate::method::Probe;
use crate::scalar::Real;
use crate::solving::{Effort, Observer};
use crate::space::PerCoordinate;
use crate::system::{
    Cotangent, FlowKind, ForceGradient, Perturbed, PerturbedGradient, PhaseSpace, QuadraticKinetic, Separable,
};

/// A system in the coordinates in which its parts A and B move.
#[derive(Clone, Copy, Debug)]
pub struct Inner<S>(pub(super) S);

impl<S: Perturbed<R>, R: Real> PhaseSpace<R> for Inner<S> {
    type State = S::State;
    type Phase = S::Phase;
    type Action = ();

    fn hamiltonian(&self, t: R, z: &S::Phase, s: &()) -> R {
        self.0.hamiltonian(t, &to_state(&self.0, z), s)
    }

    fn outside_domain(&self, t: R, z: &S::Phase, s: &()) -> Option<&'static str> {
        self.0.outside_domain(t, &to_state(&self.0, z), s)
    }
}

/// Returns the point of a state, from inner coordinates.
#[inline(always)]
fn to_state<S: Perturbed<R>, R: Real>(system: &S, z: &S::Phase) -> S::Phase {
    let mut z = *z;
    system.leave(&mut z);
    z
}

impl<S: Perturbed<R>, R: Real> Cotangent<R> for Inner<S> {
    type Coordinates = S::Coordinates;
    type Array = S::Array;
}

impl<S: Perturbed<R>, R: Real> Separable<R> for Inner<S> {
    type Proof = <S as Perturbed<R>>::Proof;
    type Kick = S::Rest;
    type Drift = S::Exact;
    const KICK: FlowKind = S::REST;
    const DRIFT: FlowKind = S::EXACT;

    #[inline]
    fn prepare_kick(&self, h: R) -> S::Rest {
        self.0.prepare_rest(h)
    }
    #[inline]
    fn prepare_drift(&self, h: R) -> S::Exact {
        self.0.prepare_exact(h)
    }
    #[inline(always)]
    fn kick(&self, kick: &S::Rest, t: R, q: &mut S::Array, p: &mut S::Array, s: &mut ()) {
        self.0.rest(kick, t, q, p, s);
    }
    #[inline(always)]
    fn drift(&self, flow: &S::Exact, t: R, q: &mut S::Array, p: &mut S::Array, s: &mut ()) {
        self.0.exact(flow, t, q, p, s);
    }
    #[inline(always)]
    fn kick_increments(&self, kick: &S::Rest, t: R, x: &PerCoordinate<S::Phase, ()>) -> PerCoordinate<S::Phase, ()> {
        self.0.rest_increments(kick, t, x)
    }
    #[inline(always)]
    fn drift_increments(&self, flow: &S::Exact, t: R, x: &PerCoordinate<S::Phase, ()>) -> PerCoordinate<S::Phase, ()> {
        self.0.exact_increments(flow, t, x)
    }
}

impl<S: PerturbedGradient<R>, R: Real> QuadraticKinetic<R> for Inner<S> {
    type Proof = <S as PerturbedGradient<R>>::Proof;
}

impl<S: PerturbedGradient<R>, R: Real> ForceGradient<R> for Inner<S> {
    type GradientKick = S::GradientKick;
    fn prepare_gradient_kick(&self, h: R, g: R) -> S::GradientKick {
        self.0.prepare_gradient_kick(h, g)
    }
    #[inline(always)]
    fn gradient_kick(&self, kick: &S::GradientKick, t: R, q: &mut S::Array, p: &mut S::Array, _: &mut ()) {
        self.0.gradient_kick(kick, t, q, p);
    }
}

/// A probe that receives inner points and reports the points of states.
#[derive(Debug)]
pub(super) struct StateProbe<'a, S, P> {
    pub(super) system: &'a S,
    pub(super) probe: &'a mut P,
}

impl<S, P: Observer> Observer for StateProbe<'_, S, P> {
    fn pause(&mut self, paused: bool) {
        self.probe.pause(paused);
    }
}

impl<S: Perturbed<R>, R: Real, P: Probe<S, R>> Probe<Inner<S>, R> for StateProbe<'_, S, P> {
    const EFFORT: Effort = P::EFFORT;

    #[inline(always)]
    fn visit(&mut self, t: R, z: &S::Phase, s: &()) {
        // Fast steps ignore all points, so they do not compute them.
        if P::EFFORT.is_thorough() {
            self.probe.visit(t, &to_state(self.system, z), s);
        }
    }

    #[inline(always)]
    fn flown(&mut self, piece: &'static str, finite: impl FnOnce() -> bool) {
        self.probe.flown(piece, finite);
    }
}

//! One flow of a table, prepared for steps of one length, and its application to a point.

use super::Coordinates;
use super::kinds::Flows;
use super::table::{Entry, Flow};
use crate::method::{Probe, Step};
use crate::scalar::{Real, zero};
use crate::space::{Action, Array, Point, Summation};
use crate::system::Separable;

/// The coefficients of a kick or a drift.
#[derive(Clone, Copy)]
pub(super) enum Coefficients<K, D> {
    /// p ← p − h ∂V/∂q, or the flow of B.
    Kick(K),
    /// q ← q + h ∂T/∂p, or what replaces it: the flow of A, or rotations.
    Drift(D),
}

/// A flow of a table, and its time.
#[derive(Clone, Copy)]
pub struct Operation<S: Separable<R>, R: Real, F: Flows<S, R>> {
    flow: Coefficients<F::Kick, S::Drift>,
    /// The time after the start of the step at which the flow evaluates explicit time dependence.
    at: R,
}

/// The fractions of h that flows have reached when another flow begins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reached {
    /// The sum of the flows of the same part.
    pub(super) own: f64,
    /// The sum of the flows of the other part.
    pub(super) other: f64,
}

impl<S: Separable<R>, R: Real, F: Flows<S, R>> Operation<S, R, F> {
    /// Prepares a flow for steps of length `h`.
    pub(super) fn prepare(system: &S, h: R, Entry { flow, gradient }: Entry, reached: Reached) -> Self {
        let part = |fraction: f64| R::from_f64(fraction) * h;
        let flow = match flow {
            Flow::Kick(fraction) => {
                let gradient = if gradient == 0.0 { zero() } else { R::from_f64(gradient) * (h * h * h) };
                Coefficients::Kick(F::prepare_kick(system, part(fraction), gradient))
            }
            Flow::Drift(fraction) => Coefficients::Drift(system.prepare_drift(part(fraction))),
        };
        Operation { flow, at: zero() }.at_time(h, reached)
    }

    /// Returns the same flow at another time.
    ///
    /// A flow reads the time that the flows of the other part have reached. A drift that is exact in time starts at its own time.
    pub(super) fn at_time(self, h: R, Reached { own, other }: Reached) -> Self {
        let at = match &self.flow {
            Coefficients::Drift(_) if S::DRIFT.is_exact_in_time() => own,
            _ => other,
        };
        Operation { at: R::from_f64(at) * h, ..self }
    }

    /// Returns whether the flow is a kick.
    pub(super) fn is_kick(&self) -> bool {
        matches!(self.flow, Coefficients::Kick(_))
    }

    /// Applies the flow in the step that starts at the time of `step`. The probe sees the start of the flow, and the parts of a drift that may end early.
    #[inline(always)]
    pub(super) fn apply<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        Step { system, t, x, probe, .. }: Step<'_, S, R, C, P>,
    ) {
        let t = t + self.at;
        probe.visit(t, &x.z, &x.s);
        // The constant condition stands twice, so that fast steps contain no code for parts that end.
        let may_end = P::EFFORT.is_thorough() && const { !S::DRIFT.parts.is_empty() };
        let reports = may_end && !self.is_kick() && x.is_finite();
        // An action that is not followed goes to a copy, so that the optimiser removes its computation.
        let mut unread = x.s;
        let s = if C::ACTION { &mut x.s } else { &mut unread };
        let [q, p] = &mut x.z;
        match &self.flow {
            Coefficients::Kick(kick) if C::PLAIN => F::kick(system, kick, t, q, p, s),
            Coefficients::Drift(drift) if C::PLAIN => F::drift(system, drift, t, q, p, s),
            // A compensated sum applies a flow that only adds to zeros.
            Coefficients::Kick(kick) if S::Action::LEN == 0 && S::KICK.adds() => {
                x.sums.add_part(S::Array::LEN, p, |p| F::kick(system, kick, t, q, p, s));
            }
            Coefficients::Drift(drift) if S::Action::LEN == 0 && S::DRIFT.adds() => {
                x.sums.add_part(0, q, |q| F::drift(system, drift, t, q, p, s));
            }
            Coefficients::Kick(kick) => {
                let d = F::kick_increments(system, kick, t, &Coordinates::<S, R>::of(x));
                add::<S, R, C>(x, &d);
            }
            Coefficients::Drift(drift) => {
                let d = F::drift_increments(system, drift, t, &Coordinates::<S, R>::of(x));
                add::<S, R, C>(x, &d);
            }
        }
        if may_end && reports {
            for part in S::DRIFT.parts {
                probe.flown(part.name, || part.is_finite(&x.z));
            }
        }
    }

    /// Applies a flow. For a kick, adds its impulse to the momenta and returns it; `known` is the impulse, if another step has computed it.
    ///
    /// Precondition: kicks only add to the momenta.
    #[inline]
    pub(super) fn apply_and_report<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        step: Step<'_, S, R, C, P>,
        known: Option<S::Array>,
    ) -> Option<S::Array> {
        let Coefficients::Kick(kick) = &self.flow else {
            self.apply(step);
            return None;
        };
        let Step { system, t, x, probe, .. } = step;
        let t = t + self.at;
        probe.visit(t, &x.z, &x.s);
        let impulse = known.unwrap_or_else(|| F::kick_increments(system, kick, t, &Coordinates::<S, R>::of(x)).z[1]);
        add_impulse::<S, R, C>(x, &impulse);
        Some(impulse)
    }
}

/// p ← p + dp, by the sums of the point.
#[inline(always)]
fn add_impulse<S: Separable<R>, R: Real, C: Summation<S::Phase>>(x: &mut Point<S::Phase, C, S::Action>, dp: &S::Array) {
    x.sums.add_part(S::Array::LEN, &mut x.z[1], |p| p.add_scaled(R::from_f64(1.0), dp));
}

/// Adds increments to positions, momenta and action.
#[inline(always)]
fn add<S: Separable<R>, R: Real, C: Summation<S::Phase>>(x: &mut Point<S::Phase, C, S::Action>, d: &Coordinates<S, R>) {
    x.sums.add_part(0, &mut x.z[0], |q| q.add_scaled(R::from_f64(1.0), &d.z[0]));
    add_impulse::<S, R, C>(x, &d.z[1]);
    x.add_action(d.s);
}

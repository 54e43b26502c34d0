//! The two flows that a table alternates: kick and drift, kick with a force gradient and drift, or kick and rotations.

use super::Coordinates;
use crate::scalar::Real;
use crate::sealed::Sealed;
use crate::space::{Array, PerCoordinate};
use crate::system::{ForceGradient, PrincipalAxes, QuadraticKinetic, Separable};
use core::fmt::Debug;

/// The kicks and drifts of a table, for systems of the type `S`.
///
/// Sealed: the type of a table names the kind of its flows.
pub trait Flows<S: Separable<R>, R: Real>: Sealed + Copy + Debug {
    /// The property of the system that these flows need; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Coefficients of a kick.
    type Kick: Copy;
    /// Whether a kick at a point where the energy is not defined makes the state after it non-finite.
    const SHOWS_DOMAIN: bool = S::KICK.shows_domain;

    /// Prepares a kick of length `h`, with a force gradient of the weight `gradient` unless that is zero.
    fn prepare_kick(system: &S, h: R, gradient: R) -> Self::Kick;
    /// Takes a kick.
    fn kick(system: &S, kick: &Self::Kick, t: R, q: &mut S::Array, p: &mut S::Array, s: &mut S::Action);
    /// Returns the increments of a kick from `x`.
    fn kick_increments(system: &S, kick: &Self::Kick, t: R, x: &Coordinates<S, R>) -> Coordinates<S, R>;

    /// Takes a drift.
    #[inline(always)]
    fn drift(system: &S, drift: &S::Drift, t: R, q: &mut S::Array, p: &mut S::Array, s: &mut S::Action) {
        system.drift(drift, t, q, p, s);
    }
    /// Returns the increments of a drift from `x`.
    #[inline(always)]
    fn drift_increments(system: &S, drift: &S::Drift, t: R, x: &Coordinates<S, R>) -> Coordinates<S, R> {
        system.drift_increments(drift, t, x)
    }
}

/// The flows of V and of T.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KickAndDrift;

/// The flows of V and of T. Some kicks have a force gradient: they are the flow of hV − g F·M⁻¹F with the force F = −∂V/∂q and the mass matrix M.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithGradient;

/// The flow of V, and rotations of rigid bodies about their principal axes in place of the flow of T. The rotations have order 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KickAndRotations;

impl Sealed for KickAndDrift {}
impl Sealed for WithGradient {}
impl Sealed for KickAndRotations {}

impl<S: Separable<R>, R: Real> Flows<S, R> for KickAndDrift {
    type Proof = S::Proof;
    type Kick = S::Kick;

    fn prepare_kick(system: &S, h: R, _: R) -> S::Kick {
        system.prepare_kick(h)
    }
    #[inline(always)]
    fn kick(system: &S, kick: &S::Kick, t: R, q: &mut S::Array, p: &mut S::Array, s: &mut S::Action) {
        system.kick(kick, t, q, p, s);
    }
    #[inline(always)]
    fn kick_increments(system: &S, kick: &S::Kick, t: R, x: &Coordinates<S, R>) -> Coordinates<S, R> {
        system.kick_increments(kick, t, x)
    }
}

/// A kick of a table with force gradients.
#[derive(Clone, Copy, Debug)]
pub enum SomeKick<A, B> {
    /// The flow of V.
    WithoutGradient(A),
    /// The flow of V with a force gradient.
    WithGradient(B),
}

impl<S: ForceGradient<R>, R: Real> Flows<S, R> for WithGradient {
    type Proof = <S as QuadraticKinetic<R>>::Proof;
    type Kick = SomeKick<S::Kick, S::GradientKick>;

    fn prepare_kick(system: &S, h: R, gradient: R) -> Self::Kick {
        if gradient.magnitude() == 0.0 {
            SomeKick::WithoutGradient(system.prepare_kick(h))
        } else {
            SomeKick::WithGradient(system.prepare_gradient_kick(h, gradient))
        }
    }
    #[inline(always)]
    fn kick(system: &S, kick: &Self::Kick, t: R, q: &mut S::Array, p: &mut S::Array, s: &mut S::Action) {
        match kick {
            SomeKick::WithoutGradient(kick) => system.kick(kick, t, q, p, s),
            SomeKick::WithGradient(kick) => system.gradient_kick(kick, t, q, p, s),
        }
    }
    #[inline(always)]
    fn kick_increments(system: &S, kick: &Self::Kick, t: R, x: &Coordinates<S, R>) -> Coordinates<S, R> {
        match kick {
            SomeKick::WithoutGradient(kick) => system.kick_increments(kick, t, x),
            SomeKick::WithGradient(kick) => {
                // The flow only adds to momenta and action. Applied to zeros, it returns the increments.
                let mut d: Coordinates<S, R> = PerCoordinate::nothing();
                system.gradient_kick(kick, t, &mut x.z[0].clone(), &mut d.z[1], &mut d.s);
                d
            }
        }
    }
}

impl<S: PrincipalAxes<R>, R: Real> Flows<S, R> for KickAndRotations {
    type Proof = <S as PrincipalAxes<R>>::Proof;
    type Kick = S::Kick;
    const SHOWS_DOMAIN: bool = false;

    fn prepare_kick(system: &S, h: R, _: R) -> S::Kick {
        system.prepare_kick(h)
    }
    #[inline(always)]
    fn kick(system: &S, kick: &S::Kick, t: R, q: &mut S::Array, p: &mut S::Array, s: &mut S::Action) {
        system.kick(kick, t, q, p, s);
    }
    #[inline(always)]
    fn kick_increments(system: &S, kick: &S::Kick, t: R, x: &Coordinates<S, R>) -> Coordinates<S, R> {
        system.kick_increments(kick, t, x)
    }
    #[inline(always)]
    fn drift(system: &S, drift: &S::Drift, _: R, q: &mut S::Array, p: &mut S::Array, _: &mut S::Action) {
        system.rotate(drift, q, p);
    }
    #[inline(always)]
    fn drift_increments(system: &S, drift: &S::Drift, _: R, x: &Coordinates<S, R>) -> Coordinates<S, R> {
        // A rotation does not add an increment, so this is the difference of its end and its start.
        let mut d = *x;
        let [q, p] = &mut d.z;
        system.rotate(drift, q, p);
        q.add_scaled(R::from_f64(-1.0), &x.z[0]);
        p.add_scaled(R::from_f64(-1.0), &x.z[1]);
        PerCoordinate { s: PerCoordinate::<S::Phase, S::Action>::nothing().s, ..d }
    }
}

//! The kinds of kicks of a table: the flow of V, and the flow of V with a force gradient.

use crate::scalar::Real;
use crate::sealed::Sealed;
use crate::space::PerCoordinate;
use crate::system::{ForceGradient, PhaseSpace, QuadraticKinetic, Separable};
use core::fmt::Debug;

/// The length of a flow: a fraction of h, and for kicks with a force gradient also a fraction of h³.
#[derive(Clone, Copy, Debug)]
pub struct Weight<R> {
    pub(crate) h: R,
    pub(crate) gradient: Option<R>,
}

/// A kind of kick.
///
/// Sealed: the type of a table names the kind of its kicks.
pub trait Kicks<S: Separable<R>, R: Real>: Sealed + Copy + Debug {
    /// The property of the system that this kind needs; see [`Method::Proof`](crate::Method::Proof).
    type Proof;
    /// Coefficients of a kick.
    type Kick: Copy;
    /// Prepares a kick.
    fn prepare(system: &S, weight: Weight<R>) -> Self::Kick;
    /// Takes a kick.
    fn kick(system: &S, kick: &Self::Kick, t: R, q: &mut S::Array, p: &mut S::Array, s: &mut S::Action);
    /// Returns the increments of a kick from `x`.
    fn increments(system: &S, kick: &Self::Kick, t: R, x: &Coordinates<S, R>) -> Coordinates<S, R>;
}

/// The coordinates of a system, or their increments.
pub(crate) type Coordinates<S, R> = PerCoordinate<<S as PhaseSpace<R>>::Phase, <S as PhaseSpace<R>>::Action>;

/// The flow of V.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithoutGradient;

impl Sealed for WithoutGradient {}
impl Sealed for WithGradient {}

impl<S: Separable<R>, R: Real> Kicks<S, R> for WithoutGradient {
    type Proof = S::Proof;
    type Kick = S::Kick;
    fn prepare(system: &S, weight: Weight<R>) -> S::Kick {
        system.prepare_kick(weight.h)
    }
    #[inline(always)]
    fn kick(system: &S, kick: &S::Kick, t: R, q: &mut S::Array, p: &mut S::Array, s: &mut S::Action) {
        system.kick(kick, t, q, p, s);
    }
    #[inline(always)]
    fn increments(system: &S, kick: &S::Kick, t: R, x: &Coordinates<S, R>) -> Coordinates<S, R> {
        system.kick_increments(kick, t, x)
    }
}

/// The flow of V, or of V with a force gradient where the table has a weight for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WithGradient;

/// A kick of a table with force gradients.
#[derive(Clone, Copy, Debug)]
pub enum SomeKick<A, B> {
    /// The flow of V.
    WithoutGradient(A),
    /// With a force gradient.
    WithGradient(B),
}

impl<S: ForceGradient<R>, R: Real> Kicks<S, R> for WithGradient {
    type Proof = <S as QuadraticKinetic<R>>::Proof;
    type Kick = SomeKick<S::Kick, S::GradientKick>;
    fn prepare(system: &S, weight: Weight<R>) -> Self::Kick {
        match weight.gradient {
            None => SomeKick::WithoutGradient(system.prepare_kick(weight.h)),
            Some(gradient) => SomeKick::WithGradient(system.prepare_gradient_kick(weight.h, gradient)),
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
    fn increments(system: &S, kick: &Self::Kick, t: R, x: &Coordinates<S, R>) -> Coordinates<S, R> {
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

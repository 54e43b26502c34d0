//! Where runs start, for systems written by hand and in other scalars: generated systems have the same functions of their own.

use super::{Adaptive, Integrator};
use crate::method::Method;
use crate::scalar::Real;
use crate::system::{PhaseSpace, Rates, StateOf};

/// A system that can be put under a method.
pub trait IntoIntegrator<R: Real = f64>: PhaseSpace<R> {
    /// This system under a method, with step size `h` (negative to go back in time), from `state` on.
    ///
    /// Nothing is checked yet: an unusable `h` or state is reported by the first step.
    fn integrator<M: Method<Self, R>>(self, method: M, h: R, state: StateOf<Self, R>) -> Integrator<Self, M, R> {
        Integrator::new(self, method, h, state)
    }

    /// This system under a method with steps as long as the tolerance of a step's error allows, from `state` on.
    ///
    /// Nothing is checked yet: an unusable tolerance or state is reported by the first step.
    fn adaptive<M: Method<Self, R>>(self, method: M, tolerance: f64, state: StateOf<Self, R>) -> Adaptive<Self, M, R>
    where
        Self: Rates<R>,
    {
        Adaptive::new(self, method, tolerance, state)
    }
}

impl<S: PhaseSpace<R>, R: Real> IntoIntegrator<R> for S {}

//! Starts runs of systems that are written by hand, or that use other scalars. Generated systems have inherent functions of the same names, which
//! return [`Given`](super::Given) runs: a missing property is then one error.

use super::{Adaptive, Integrator};
use crate::method::Method;
use crate::scalar::Real;
use crate::system::{PhaseSpace, Rates, StateOf};

/// A system that an integrator can run.
pub trait IntoIntegrator<R: Real = f64>: PhaseSpace<R> {
    /// Integrates this system with a method and a fixed step size `h`, from `state` on. A negative `h` goes back in time.
    ///
    /// Nothing is checked yet: the first step reports an unusable `h` or state.
    fn integrator<M: Method<Self, R>>(self, method: M, h: R, state: StateOf<Self, R>) -> Integrator<Self, M, R> {
        Integrator::new(self, method, h, state)
    }

    /// Integrates this system with a method whose step size adapts to the tolerance, from `state` on.
    ///
    /// Nothing is checked yet: the first step reports an unusable tolerance or state.
    fn adaptive<M: Method<Self, R>>(self, method: M, tolerance: f64, state: StateOf<Self, R>) -> Adaptive<Self, M, R>
    where
        Self: Rates<R>,
    {
        Adaptive::new(self, method, tolerance, state)
    }
}

impl<S: PhaseSpace<R>, R: Real> IntoIntegrator<R> for S {}

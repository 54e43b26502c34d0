//! States on constraints.

use super::{Integrator, StepError};
use crate::method::Method;
use crate::scalar::{Real, signed};
use crate::space::{Array, Snapshot, Summation};
use crate::system::{Constrained, StateOf, projected};

/// The state nearest to another one that is on the constraints of a system.
///
/// # Errors
/// Where none is near, or constraints depend on each other.
pub fn state_on_constraint<S: Constrained<R>, R: Real>(
    system: &S,
    state: &StateOf<S, R>,
) -> Result<StateOf<S, R>, StepError> {
    let (t, z, s) = state.parts();
    let not_finite = Err(StepError::not_finite::<S, R>(t, &z));
    if !z.is_finite() {
        return not_finite;
    }
    match projected(system, t, &z) {
        Ok(z) if z.is_finite() => Ok(S::State::of(t, z, s)),
        Ok(_) => not_finite,
        Err(refusal) => Err(StepError::refused(refusal, signed(t))),
    }
}

impl<S: Constrained<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> Integrator<S, M, R, C> {
    /// The state now with its momenta made tangent to the constraints, and positions on them.
    ///
    /// Momenta of [`DiscreteGradient`](crate::DiscreteGradient) are off by O(h²) at the ends of steps: compositions have their order in
    /// these. The run goes on from the state that it has.
    ///
    /// # Errors
    /// Where constraints depend on each other.
    pub fn state_on_constraint(&self) -> Result<StateOf<S, R>, StepError> {
        state_on_constraint(self.system(), &self.state())
    }
}

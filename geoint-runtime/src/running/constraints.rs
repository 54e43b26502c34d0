//! Projects states onto constraints.

use super::{Integrator, StepError};
use crate::method::Method;
use crate::scalar::{Real, signed};
use crate::space::{Array, Snapshot, Summation};
use crate::system::{Constrained, StateOf, projected};

/// Returns the state nearest to `state` that satisfies the constraints of a system. Positions move, to first order, the shortest way in the metric of
/// the mass matrix. Momenta become tangent.
///
/// # Errors
/// Fails if no such state is near, or if constraints depend on each other.
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
    /// Returns the present state with positions on the constraints and momenta tangent to them.
    ///
    /// Momenta of [`DiscreteGradient`](crate::DiscreteGradient) are off by O(h²) at the ends of steps. Compositions reach their order in the
    /// projected momenta. The run itself continues from its own state.
    ///
    /// # Errors
    /// Fails if constraints depend on each other.
    pub fn state_on_constraint(&self) -> Result<StateOf<S, R>, StepError> {
        state_on_constraint(self.system(), &self.state())
    }
}

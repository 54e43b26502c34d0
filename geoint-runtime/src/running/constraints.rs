//! Projects states onto constraints.

use super::{Integrator, StepError};
use crate::method::Method;
use crate::running::error::not_finite;
use crate::scalar::{Real, signed};
use crate::space::{Array, Snapshot, Summation};
use crate::system::{Constrained, StateOf, projected};

/// Returns a state near `state` that satisfies the constraints of a system. Positions move along W Gᵀ, with the inverse mass matrix W and the gradients G of the
/// constraints: to first order, this is the shortest way in the metric of the mass matrix. Momenta become tangent. The action does not change.
///
/// # Errors
/// Fails if no such state is near, if constraints depend on each other, or if the state is not finite.
pub fn state_on_constraint<S: Constrained<R>, R: Real>(
    system: &S,
    state: &StateOf<S, R>,
) -> Result<StateOf<S, R>, StepError> {
    let (t, z, s) = state.parts();
    let error = |failure| StepError::without_step(failure, signed(t));
    let projected = if z.is_finite() { projected(system, t, &z).map_err(error)? } else { z };
    if !projected.is_finite() {
        return Err(error(not_finite::<S, R>(t, &z)));
    }
    Ok(S::State::of(t, projected, s))
}

impl<S: Constrained<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> Integrator<S, M, R, C> {
    /// Returns the present state with positions on the constraints and momenta tangent to them.
    ///
    /// Momenta of [`DiscreteGradient`](crate::DiscreteGradient) are off by O(h²) at the ends of steps. Compositions reach their order, at most 4, in
    /// the projected momenta. The run itself continues from its own state.
    ///
    /// # Errors
    /// Those of [`state_on_constraint`](crate::running::state_on_constraint).
    pub fn state_on_constraint(&self) -> Result<StateOf<S, R>, StepError> {
        state_on_constraint(self.system(), &self.state())
    }
}

//! Projects states onto constraints.

use super::pace::Pace;
use super::{Run, StepError};
use crate::running::error::not_finite;
use crate::scalar::{Real, signed};
use crate::space::state::Action;
use crate::space::{Array, Snapshot};
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
    if !s.is_finite() {
        return Err(error(not_finite::<S, R>(t, &z)));
    }
    let projected = if z.is_finite() { projected(system, t, &z).map_err(error)? } else { z };
    if !projected.is_finite() {
        return Err(error(not_finite::<S, R>(t, &z)));
    }
    Ok(S::State::of(t, projected, s))
}

impl<P: Pace> Run<P>
where
    P::System: Constrained<P::Real>,
{
    /// Returns the present state with positions on the constraints and momenta tangent to them.
    ///
    /// The states of most runs are there already. Momenta of [`DiscreteGradient`](crate::DiscreteGradient) are off by O(h²) if T is not quadratic in p:
    /// compositions reach their order, at most 4, in the projected momenta. The run itself continues from its own state.
    ///
    /// # Errors
    /// Those of [`state_on_constraint`](crate::running::state_on_constraint).
    pub fn state_on_constraint(&self) -> Result<StateOf<P::System, P::Real>, StepError> {
        state_on_constraint(self.system(), &self.state())
    }

    /// Returns the multipliers of the present state, in the order of the constraints: λ of the force −Gᵀλ for constraints of positions, such as tensions and
    /// forces in bearings, and μ of the force Aᵀμ for constraints of velocities. They follow from the equations of motion, and not from the last step.
    pub fn multipliers(&self) -> <P::System as Constrained<P::Real>>::Multipliers {
        let (t, z, _) = self.state().parts();
        self.system().multipliers(t, &z)
    }
}

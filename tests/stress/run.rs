//! A run, and the change of its energy.

use geoint_runtime::Real;
use geoint_runtime::prelude::*;
use geoint_runtime::running::Scalar;

/// The result of a run.
pub(crate) struct Outcome<S> {
    /// The largest observed change of the energy.
    pub(crate) energy: f64,
    /// The number of accepted steps.
    pub(crate) steps: u64,
    /// The last state.
    pub(crate) state: S,
    /// The error that ended the run early.
    pub(crate) refused: Option<StepError>,
}

impl<S> Outcome<S> {
    /// Describes the end of the run in words.
    pub(crate) fn end(&self) -> String {
        self.refused.as_ref().map_or("reached".into(), |error| format!("refused: {error}").replace('|', "\\|"))
    }
}

/// Advances a run by `part`, `looks` times, and checks the energy and the state after each part.
fn watched<T: Trajectory>(
    mut run: T,
    looks: u32,
    mut part: impl FnMut(&mut T, u32) -> Result<(), StepError>,
    mut see: impl FnMut(&T::State),
) -> Outcome<T::State> {
    let start = run.energy();
    let mut outcome = Outcome { energy: 0.0, steps: 0, state: run.state(), refused: None };
    for look in 1..=looks {
        outcome.refused = part(&mut run, look).err();
        let change = (run.energy() - start).magnitude();
        // A NaN counts as the worst error.
        outcome.energy = if change <= outcome.energy { outcome.energy } else { change };
        (outcome.steps, outcome.state) = (run.steps(), run.state());
        see(&outcome.state);
        if outcome.refused.is_some() {
            break;
        }
    }
    outcome
}

/// Takes `steps` steps of fixed length.
pub(crate) fn fixed<T: Trajectory>(run: T, steps: u64, looks: u32, see: impl FnMut(&T::State)) -> Outcome<T::State> {
    watched(run, looks, |run, _| run.advance(steps / u64::from(looks)), see)
}

/// Takes adaptive steps up to the time `end`.
pub(crate) fn adapting<T: Trajectory>(run: T, end: f64, looks: u32, see: impl FnMut(&T::State)) -> Outcome<T::State> {
    let at = |look: u32| Scalar::<T>::from_f64(end * f64::from(look) / f64::from(looks));
    watched(run, looks, |run, look| run.advance_to(at(look)), see)
}

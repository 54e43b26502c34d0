//! A run, and by how much its energy has moved.

use geoint_runtime::Real;
use geoint_runtime::prelude::*;
use geoint_runtime::running::Scalar;

/// What a run has come to.
pub(crate) struct Outcome<S> {
    /// The largest change of the energy that was seen.
    pub(crate) energy: f64,
    /// Steps that were taken.
    pub(crate) steps: u64,
    /// The last state.
    pub(crate) state: S,
    /// Why it ended before its time.
    pub(crate) refused: Option<StepError>,
}

impl<S> Outcome<S> {
    /// The end, in words.
    pub(crate) fn end(&self) -> String {
        self.refused.as_ref().map_or("reached".into(), |error| format!("refused: {error}").replace('|', "\\|"))
    }
}

/// A run by `part` for so many times. The energy is looked at after each of them, and so is the state.
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
        // A number that is none is worse than all others.
        outcome.energy = if change <= outcome.energy { outcome.energy } else { change };
        (outcome.steps, outcome.state) = (run.steps(), run.state());
        see(&outcome.state);
        if outcome.refused.is_some() {
            break;
        }
    }
    outcome
}

/// So many steps.
pub(crate) fn fixed<T: Trajectory>(run: T, steps: u64, looks: u32, see: impl FnMut(&T::State)) -> Outcome<T::State> {
    watched(run, looks, |run, _| run.advance(steps / u64::from(looks)), see)
}

/// Steps that adapt, up to the time `end`.
pub(crate) fn adapting<T: Trajectory>(run: T, end: f64, looks: u32, see: impl FnMut(&T::State)) -> Outcome<T::State> {
    let at = |look: u32| Scalar::<T>::from_f64(end * f64::from(look) / f64::from(looks));
    watched(run, looks, |run, look| run.advance_to(at(look)), see)
}

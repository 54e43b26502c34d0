//! Crossings, and the search loop for any run.

use crate::running::StepError;
use crate::scalar::{Real, signed};

/// Direction of the changes of sign that count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From negative to positive, in the direction of the run.
    Up,
    /// From positive to negative, in the direction of the run.
    Down,
    /// Both directions.
    Any,
}

impl Direction {
    /// Returns whether a change to this sign counts.
    pub(super) fn counts(self, to: f64) -> bool {
        match self {
            Direction::Up => to > 0.0,
            Direction::Down => to < 0.0,
            Direction::Any => true,
        }
    }
}

/// A change of sign of a function along a run.
#[doc(alias = "event")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<X> {
    /// State at the crossing. The function is zero there up to rounding. In runs that take partial steps, it is zero up to the rounding of time, too.
    pub state: X,
    /// Index of the function.
    pub which: usize,
    /// Whether the function rises.
    pub rises: bool,
}

/// After this many steps in a row with a zero function, the function counts as identically zero.
pub(super) const MOST_ZERO_STEPS: u32 = 1024;

/// A zero beyond this part of a step counts as a zero at its end.
pub(super) const NEAR_END: f64 = 1.0 - 1.0 / (1_u64 << 40) as f64;

/// Checks that a search can end at a time: it must be a number.
pub(super) fn check_end<R: Real>(end: Option<R>, now: R) -> Result<(), StepError> {
    match end {
        Some(t) if t.magnitude().is_nan() => Err(StepError::of_step_size(signed(now), signed(t - now))),
        _ => Ok(()),
    }
}

/// Returns the first zero found. Takes steps until one contains a zero. Returns `None` if no step is left.
pub(super) fn next<S, X>(
    search: &mut S,
    mut earliest: impl FnMut(&mut S) -> Option<Result<X, StepError>>,
    mut step: impl FnMut(&mut S) -> Result<bool, StepError>,
) -> Option<Result<X, StepError>> {
    loop {
        if let Some(found) = earliest(search) {
            return Some(found);
        }
        match step(search) {
            Ok(true) => {}
            Ok(false) => return None,
            Err(error) => return Some(Err(error)),
        }
    }
}

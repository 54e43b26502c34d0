//! What a crossing is, and how any run is searched for them.

use crate::running::StepError;
use crate::scalar::{Real, signed};

/// Which changes of sign count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From negative to positive, as time goes on in the run.
    Up,
    /// From positive to negative.
    Down,
    /// Both.
    Any,
}

impl Direction {
    /// Whether a change to this sign counts.
    pub(super) fn counts(self, to: f64) -> bool {
        match self {
            Direction::Up => to > 0.0,
            Direction::Down => to < 0.0,
            Direction::Any => true,
        }
    }
}

/// A change of sign.
#[doc(alias = "event")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<X> {
    /// Where and when: the function is zero there, to rounding, where steps have a part of the length also to that of time.
    pub state: X,
    /// Which of several functions it is.
    pub which: usize,
    /// Whether the function rises.
    pub rises: bool,
}

/// So many points in a row at which a function is zero are no accident.
pub(super) const ZEROS: u32 = 1024;

/// A zero so near to the end of a step is one at the end.
pub(super) const NEAR: f64 = 1.0 - 1.0 / (1_u64 << 40) as f64;

/// That a search can end at a time.
pub(super) fn check_end<R: Real>(end: Option<R>, now: R) -> Result<(), StepError> {
    match end {
        Some(t) if t.magnitude().is_nan() => Err(StepError::InvalidStepSize { h: signed(t - now) }),
        _ => Ok(()),
    }
}

/// The first zero that a step has, in as many steps as that takes; `None` where no step is left.
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

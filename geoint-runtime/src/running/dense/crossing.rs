//! Crossings, and their directions.

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

//! Detects runs that stall at a condition: sliding (both sides lead back to the surface), and bounces whose height tends to zero (Zeno behaviour).

use super::switches::Switch;
use crate::space::{Record, Tape};

/// Accepted number of immediate returns in a row, for each condition.
const MOST_RETURNS: u64 = 16;

/// A return is immediate if its time is at most this many times the number of accepted returns times the largest overshoot of the row. The overshoot
/// is the time by which the run may have passed its condition. Bounces that start from rounding become longer by four overshoots at each crossing.
const IMMEDIATE: u64 = 8;

/// A bounce is low if its time is below this part of the longest one.
const LOW_BOUNCE: f64 = 1.0 / (1 << 16) as f64;

/// Accepted number of low bounces in a row. After more of them, the height does not grow again.
const MOST_LOW_BOUNCES: u64 = 1 << 16;

/// Times and numbers of the changes of conditions.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Progress {
    /// Time since the last change.
    since: f64,
    /// Condition of the last change, counted from one; 0 for none.
    place: u64,
    /// Largest overshoot, as a time, in the present row of immediate returns.
    beyond: f64,
    /// Number of immediate returns in a row.
    stuck: u64,
    /// Longest time between two changes.
    longest: f64,
    /// Number of low bounces in a row.
    low: u64,
}

impl Progress {
    /// Includes a step of length `h`. `ended`: the change that ended the step, if any, and the overshoot. `conditions`: the number of conditions.
    ///
    /// Returns whether the run makes progress. If not, all counts are reset, so that the failure is reported once.
    pub(super) fn include(&mut self, h: f64, ended: Option<(Switch, f64)>, conditions: usize) -> bool {
        let time = self.since + h;
        let Some((switch, beyond)) = ended else {
            self.since = time;
            return true;
        };
        let (place, most) = (switch.place as u64 + 1, MOST_RETURNS * conditions as u64);
        let led_back = switch.back && self.place == place && self.since == 0.0;
        let back = switch.at == 0.0 || led_back || time <= (IMMEDIATE * most) as f64 * self.beyond;
        (self.stuck, self.beyond) = if back { (self.stuck + 1, self.beyond.max(beyond)) } else { (0, beyond) };
        self.low = if time < LOW_BOUNCE * self.longest { self.low + 1 } else { 0 };
        // The time to the first change is not that of a bounce.
        self.longest = if self.place == 0 { 0.0 } else { self.longest.max(time) };
        (self.since, self.place) = (0.0, place);
        let goes_on = self.stuck <= most && self.low <= MOST_LOW_BOUNCES;
        if !goes_on {
            *self = Progress::default();
        }
        goes_on
    }
}

impl<R> Record<R> for Progress {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        tape.number(&mut self.since);
        tape.steps(&mut self.place);
        tape.number(&mut self.beyond);
        tape.steps(&mut self.stuck);
        tape.number(&mut self.longest);
        tape.steps(&mut self.low);
    }
}

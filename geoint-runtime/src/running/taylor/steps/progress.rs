//! Whether a run that meets conditions again and again goes on: one at rest where both sides lead back does not, nor one that bounces ever lower.

use super::switches::Switch;
use crate::space::{Record, Tape};

/// So many times in a row, of each condition, that a run comes back at once are no accident.
const STUCK: u64 = 16;

/// A bounce comes back at once that takes no longer than so many times what one of those in a row may have gone beyond its condition, and so many
/// times those that are no accident: one that began with rounding grows by four times that at each crossing.
const NEAR: u64 = 8;

/// Bounces are low that take less than this part of the longest one.
const LOW: f64 = 1.0 / (1 << 16) as f64;

/// So many low ones in a row are no motion that grows again.
const BOUNCES: u64 = 1 << 16;

/// When a run has met conditions, and how often in a row.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Progress {
    /// Time since the last one was met.
    since: f64,
    /// The last one, counted from one; 0 for none.
    place: u64,
    /// How far the run may have gone beyond it, or beyond others in a row.
    beyond: f64,
    /// How many bounces of late have come back at once.
    stuck: u64,
    /// The longest time from one to the next.
    longest: f64,
    /// How many bounces of late were low.
    low: u64,
}

impl Progress {
    /// Includes a step of length `h` that one of so many conditions has ended, or none, and that may have gone so far beyond it. Whether the run
    /// goes on; that it does not is said once, and all is counted anew.
    pub(super) fn include(&mut self, h: f64, ended: Option<(Switch, f64)>, conditions: usize) -> bool {
        let time = self.since + h;
        let Some((switch, beyond)) = ended else {
            self.since = time;
            return true;
        };
        let (place, most) = (switch.place as u64 + 1, STUCK * conditions as u64);
        let led_back = switch.back && self.place == place && self.since == 0.0;
        let back = switch.at == 0.0 || led_back || time <= (NEAR * most) as f64 * self.beyond;
        (self.stuck, self.beyond) = if back { (self.stuck + 1, self.beyond.max(beyond)) } else { (0, beyond) };
        self.low = if time < LOW * self.longest { self.low + 1 } else { 0 };
        // The way to the first one is no bounce.
        self.longest = if self.place == 0 { 0.0 } else { self.longest.max(time) };
        (self.since, self.place) = (0.0, place);
        let goes_on = self.stuck <= most && self.low <= BOUNCES;
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

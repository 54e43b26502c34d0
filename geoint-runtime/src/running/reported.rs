//! Event functions that had their event at the present time.

use crate::scalar::{Real, zero};
#[cfg(feature = "alloc")]
use crate::space::{Record, Tape};

/// Functions that `until_event` has reported at one time.
///
/// Several functions may be zero at the same time, for example for a ball in a corner, or for bodies in contact. A search that starts at an event
/// reports the functions that were not reported yet, and does not report the others again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reported<R> {
    /// Whether there was an event.
    any: bool,
    t: R,
    /// A bit for each of the first 64 functions.
    functions: u64,
}

impl<R: Real> Reported<R> {
    pub(super) fn nothing() -> Self {
        Reported { any: false, t: zero(), functions: 0 }
    }

    /// Adds the event of a function at the time `t`.
    pub(super) fn add(&mut self, t: R, function: usize) {
        if !self.is_at(t) {
            *self = Reported { any: true, t, functions: 0 };
        }
        self.functions |= bit(function);
    }

    /// Returns whether the last event was at the time `t`.
    pub(super) fn is_at(&self, t: R) -> bool {
        self.any && self.t == t
    }

    /// Returns whether a function that leaves zero at the time of the last event has an event there, too. A function that was already reported has
    /// none. A function that leaves to the side that does not count may have an event there later.
    ///
    /// Functions from index 64 on have none.
    pub(super) fn takes(&mut self, function: usize, counts: bool) -> bool {
        if !counts {
            self.functions &= !bit(function);
        }
        counts && bit(function) != 0 && self.functions & bit(function) == 0
    }
}

/// Mask of the lower half of a word.
#[cfg(feature = "alloc")]
const LOWER: u64 = u32::MAX as u64;

#[cfg(feature = "alloc")]
impl<R: Real> Record<R> for Reported<R> {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        tape.flag(&mut self.any);
        tape.scalar(&mut self.t);
        // Stored in halves, so that no word has the bits of a number that is not finite.
        let mut halves = [self.functions & LOWER, self.functions >> 32];
        for half in &mut halves {
            tape.count(half);
            *half &= LOWER;
        }
        self.functions = halves[0] | halves[1] << 32;
    }
}

/// Returns the bit of a function; zero if it has none.
fn bit(function: usize) -> u64 {
    1_u64.checked_shl(function as u32).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::Reported;

    #[test]
    fn functions_are_reported_once_at_a_time() {
        let mut reported = Reported::nothing();
        assert!(!reported.is_at(0.0) && !reported.is_at(1.0));
        reported.add(1.0, 2);
        assert!(reported.is_at(1.0) && !reported.is_at(2.0));
        assert!(reported.takes(0, true) && !reported.takes(2, true));
        reported.add(1.0, 0);
        assert!(!reported.takes(0, true) && !reported.takes(2, true));
        // The function has changed its direction, and changes it again.
        assert!(!reported.takes(2, false) && reported.takes(2, true));
        reported.add(2.0, 63);
        assert!(!reported.is_at(1.0) && reported.takes(2, true));
        assert!(!reported.takes(63, true) && !reported.takes(64, true));
    }
}

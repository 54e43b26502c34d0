//! Search for poles of H that depend on time only.
//!
//! Such a pole does not depend on the state. Thus an interval of time without a pole needs one proof, which is valid for all steps within it. These
//! steps only compare their ends with the interval.

use super::PhaseSpace;
use super::poles::{Known, search_time};
use crate::scalar::{Real, zero};

/// The longest interval of a search, in units of the step.
const FARTHEST: f64 = 1024.0;

/// An interval of time, without its start and with its end, in which a system was proven to have no pole that depends on time only.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clear<R> {
    start: R,
    end: R,
    /// Half of the length of the next search, in units of its step. The length of the interval in steps, or 1 after a search that failed.
    reach: f64,
}

impl<R: Real> Clear<R> {
    /// The empty interval, before the first search.
    pub(crate) fn unknown() -> Self {
        Clear { start: zero(), end: zero(), reach: 1.0 }
    }

    /// Returns the first time-dependent pole that is not excluded in an interval of time. The interval is open at its start and closed at its end.
    #[inline(always)]
    pub(crate) fn pole<S: PhaseSpace<R>>(&mut self, system: &S, way: [R; 2]) -> Option<&'static str> {
        if !Known::<S, R>::TIMED || self.includes(way) { None } else { self.search(system, way) }
    }

    /// Returns whether the interval contains a step between two times.
    #[inline(always)]
    fn includes(&self, [from, to]: [R; 2]) -> bool {
        // Two comparisons, because the product of small differences may underflow.
        let is_between = |t: R, a: R, b: R| (t - a).all_at_least_zero() & (b - t).all_at_least_zero();
        let within = |t: R| is_between(t, self.start, self.end) | is_between(t, self.end, self.start);
        within(from) & within(to) && (to - self.start).magnitude() > 0.0
    }

    /// Searches an interval from the start of the step, twice as long as the last one in units of the step. If a pole is not excluded, its length is halved,
    /// down to one step. The end may lie before the start.
    #[cold]
    #[inline(never)]
    fn search<S: PhaseSpace<R>>(&mut self, system: &S, [from, to]: [R; 2]) -> Option<&'static str> {
        let mut reach = (2.0 * self.reach).min(FARTHEST);
        loop {
            let end = if reach > 1.0 { from + R::from_f64(reach) * (to - from) } else { to };
            let found = search_time(system, [from, end]);
            if found.is_none() {
                *self = Clear { start: from, end, reach };
                return None;
            }
            if reach <= 1.0 {
                self.reach = 1.0;
                return found;
            }
            reach *= 0.5;
        }
    }
}

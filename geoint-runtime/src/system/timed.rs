//! Poles in time alone: whether a step leads over one.
//!
//! Time passes whatever the state does. So a stretch of it that is proven to be clear holds for all steps within, and they compare their ends with
//! its own in place of a search.

use super::PhaseSpace;
use super::poles::{Known, search_time};
use crate::scalar::{Real, zero};

/// At most so many times as much as is asked for is proven at once.
const FARTHEST: f64 = 1024.0;

/// A stretch of time behind whose start, and up to whose end, a system was proven to have no pole in time alone.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clear<R> {
    start: R,
    end: R,
    /// How many times as much as was asked for it is.
    reach: f64,
}

impl<R: Real> Clear<R> {
    /// Nothing was asked for yet.
    pub(crate) fn unknown() -> Self {
        Clear { start: zero(), end: zero(), reach: 1.0 }
    }

    /// The first pole in time alone, if any, that cannot be ruled out behind one time and up to another, with it.
    #[inline(always)]
    pub(crate) fn pole<S: PhaseSpace<R>>(&mut self, system: &S, way: [R; 2]) -> Option<&'static str> {
        if !Known::<S, R>::TIMED || self.includes(way) { None } else { self.search(system, way) }
    }

    /// Whether a way from one time to another lies in the stretch.
    #[inline(always)]
    fn includes(&self, [from, to]: [R; 2]) -> bool {
        // Differences: a product of two small ones is zero.
        let is_between = |t: R, a: R, b: R| (t - a).all_at_least_zero() & (b - t).all_at_least_zero();
        let within = |t: R| is_between(t, self.start, self.end) | is_between(t, self.end, self.start);
        within(from) & within(to) && (to - self.start).magnitude() > 0.0
    }

    /// Proves a stretch from here on, twice as long as the last one; if that has a pole, half as long, and so on.
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

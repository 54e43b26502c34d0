//! Where an iteration ends whose corrections shrink until rounding stops them.

use crate::scalar::Real;
use crate::solving::Refusal;

/// Far more than a convergent iteration needs.
const MAX_ITERATIONS: u32 = 40;

/// Where corrections no longer shrink because of rounding, they are at least this small.
const STAGNATION: f64 = 1e-9;

/// Less than this is lost in every rounding.
const LEFT_OVER: f64 = 1.0 / 1024.0;

/// Counts iterations and compares corrections.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stagnation {
    iterations: u32,
    before: f64,
}

impl Stagnation {
    pub(crate) fn new() -> Self {
        Stagnation { iterations: 0, before: f64::INFINITY }
    }

    /// Whether a correction, relative to what it corrects, was the last one.
    pub(crate) fn reached<R: Real>(&mut self, correction: f64) -> Result<bool, Refusal> {
        self.iterations += 1;
        let shrinks = correction <= 0.5 * self.before;
        let done = correction <= LEFT_OVER * R::epsilon() || (!shrinks && correction <= STAGNATION);
        if !done && (correction.is_nan() || self.iterations == MAX_ITERATIONS) {
            return Err(Refusal::NotConverged { iterations: self.iterations, correction });
        }
        self.before = correction;
        Ok(done)
    }
}

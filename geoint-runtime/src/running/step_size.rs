//! Step size control.

use crate::scalar::Real;
use crate::solving::Failure;
use crate::space::{Record, Tape};

/// Step lengths of one octave: 2^(k/4) for k = 0 … 3.
const RUNGS: [f64; 4] = [1.0, 1.189_207_115_002_721, core::f64::consts::SQRT_2, 1.681_792_830_507_429];

/// Factor of the step length, so that few steps are rejected.
const SAFETY: f64 = 0.9;

/// Lower limit of the previous error in the controller. After a step that was far too short, the next length then follows from its own error.
const LEAST_PREVIOUS_ERROR: f64 = 1e-4;

/// Maximum change of the step size, in rungs, after an accepted or a rejected step.
const MOST_RUNGS: f64 = 8.0;

/// Shortest and longest step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    pub(crate) shortest: f64,
    pub(crate) longest: f64,
}

impl Default for Bounds {
    fn default() -> Self {
        Bounds { shortest: 0.0, longest: f64::INFINITY }
    }
}

impl Bounds {
    /// Returns bounds for steps that change the time `t`, and are at least ε⁴ times `pace`, the time in which a state changes, or ε⁴ if `pace` is above 1. Shorter
    /// steps would hardly ever end.
    pub(crate) fn at(&self, t: f64, epsilon: f64, pace: f64) -> Bounds {
        let negligible = epsilon * epsilon * epsilon * epsilon * pace.min(1.0);
        Bounds { shortest: self.shortest.max(4.0 * epsilon * t.abs()).max(negligible), ..*self }
    }

    /// Checks that the bounds admit a step.
    pub(crate) fn check(&self) -> Result<(), Failure> {
        let Bounds { shortest, longest } = *self;
        let good = longest > 0.0 && shortest <= longest && shortest < f64::INFINITY;
        if good { Ok(()) } else { Err(Failure::InvalidBounds { shortest, longest }) }
    }
}

/// Proportional-integral controller: h ← h·(1/e)^(0.7/(p+1))·e₋₁^(0.4/(p+1)), with the errors e and e₋₁ of the last two steps in units of the
/// tolerance. K. Gustafsson, M. Lundh & G. Söderlind, BIT 28 (1988) 270. The constants are those of Hairer & Wanner, *Solving Ordinary Differential
/// Equations II* (1996), section IV.2.
///
/// The length is multiplied by 0.9, and rounded down to a rung 2^(k/4). It changes by two octaves at most, and does not grow after a rejection. A length that
/// does not change keeps the coefficients of the method.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Controller {
    /// p + 1.
    exponent: f64,
    /// |h| = 2^(rung/4).
    rung: f64,
    /// The length of the rung. Computed in advance.
    length: f64,
    backwards: bool,
    before: f64,
    /// Previous error, expressed in rungs. Computed in advance.
    rungs_before: f64,
    rejected: bool,
    /// Time in which the first state changes; 1 if it is not known.
    pub(crate) pace: f64,
}

impl<R> Record<R> for Controller {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        tape.number(&mut self.rung);
        self.length = length(self.rung);
        tape.flag(&mut self.backwards);
        tape.number(&mut self.before);
        self.rungs_before = rungs(self.before.max(LEAST_PREVIOUS_ERROR));
        tape.flag(&mut self.rejected);
        tape.number(&mut self.pace);
    }
}

impl Controller {
    pub(crate) fn new(order: u32) -> Self {
        let exponent = f64::from(order) + 1.0;
        Controller {
            exponent,
            rung: 0.0,
            length: 1.0,
            backwards: false,
            before: 1.0,
            rungs_before: 0.0,
            rejected: false,
            pace: 1.0,
        }
    }

    /// Sets the first step from the time in which the state changes.
    pub(crate) fn start(&mut self, time: f64, tolerance: f64) {
        self.pace = if time > 0.0 && time < f64::INFINITY { time } else { 1.0 };
        let h = time * self.part(tolerance);
        self.set(if h > 0.0 && h < f64::INFINITY { h } else { 1.0 });
    }

    /// Returns the expected step length divided by the time in which the state changes, for an error equal to the tolerance.
    pub(crate) fn part(&self, tolerance: f64) -> f64 {
        Real::powf(tolerance, 1.0 / self.exponent)
    }

    pub(crate) fn set(&mut self, h: f64) {
        self.set_rung(rung(h));
        self.backwards = h < 0.0;
    }

    pub(crate) fn turn(&mut self, backwards: bool) {
        self.backwards = backwards;
    }

    /// Returns the first step if it is zero, infinite or not a number.
    pub(crate) fn unusable(&self) -> Option<f64> {
        (!self.rung.is_finite()).then(|| Real::exp2(self.rung / 4.0))
    }

    /// Returns the next step.
    pub(crate) fn step(&self, bounds: &Bounds) -> f64 {
        // A step that is refused can be shortened only if its length is finite.
        let h = self.length.max(bounds.shortest).min(bounds.longest).min(f64::MAX);
        if self.backwards { -h } else { h }
    }

    fn set_rung(&mut self, rung: f64) {
        (self.rung, self.length) = (rung, length(rung));
    }

    /// Updates the length after an accepted step `h` with this error. Precondition: `h` is the length of the controller within its bounds.
    pub(crate) fn accept(&mut self, h: f64, error: f64) {
        let in_rungs = rungs(error);
        // Infinite if the error is zero; clamped below.
        let wish = rungs(SAFETY) + (0.4 * self.rungs_before - 0.7 * in_rungs) / self.exponent;
        let most = if self.rejected { 0.0 } else { MOST_RUNGS };
        // Avoids a logarithm on the critical path if the rung is known.
        let rung = if h.abs() == self.length { self.rung } else { rung(h) };
        self.set_rung(rung + floor(wish).clamp(-MOST_RUNGS, most));
        (self.before, self.rejected) = (error, false);
        self.rungs_before = if error > LEAST_PREVIOUS_ERROR { in_rungs } else { rungs(LEAST_PREVIOUS_ERROR) };
    }

    /// Updates the length after a rejected step `h`. The error is `None` if the step had no result.
    pub(crate) fn reject(&mut self, h: f64, error: Option<f64>) {
        let fall = error.map_or(-4.0, |error| floor(rungs(SAFETY) - rungs(error) / self.exponent));
        self.set_rung(self.rung.min(rung(h)) + fall.clamp(-MOST_RUNGS, -1.0));
        self.rejected = true;
    }
}

/// Returns the length of a rung.
fn length(rung: f64) -> f64 {
    let octave = floor(rung / 4.0);
    power_of_two(octave) * RUNGS[((rung - 4.0 * octave) as usize).min(3)]
}

/// Returns 2ⁿ for an integer n. Sets the exponent bits if the result is a normal number.
fn power_of_two(n: f64) -> f64 {
    if n.abs() < f64::from(f64::MAX_EXP - 1) {
        f64::from_bits(((n as i64 + i64::from(f64::MAX_EXP - 1)) as u64) << (f64::MANTISSA_DIGITS - 1))
    } else {
        Real::exp2(n)
    }
}

/// Returns the number of rungs from length 1 to `length`.
fn rungs(length: f64) -> f64 {
    4.0 * Real::log2(length)
}

/// Returns the rung nearest to a step.
fn rung(h: f64) -> f64 {
    floor(rungs(h.abs()) + 0.5)
}

/// Rounds down. The core library has no such function.
fn floor(x: f64) -> f64 {
    libm::floor(x)
}

#[cfg(test)]
mod tests {
    use super::{length, power_of_two, rung};

    #[test]
    fn powers_of_two_are_those_of_the_library() {
        for n in -1100..1100 {
            let n = f64::from(n);
            assert_eq!(power_of_two(n), n.exp2(), "2^{n}");
        }
    }

    #[test]
    fn a_length_is_that_of_its_rung() {
        for rungs in -4088..4090 {
            assert_eq!(rung(length(f64::from(rungs))), f64::from(rungs));
        }
    }
}

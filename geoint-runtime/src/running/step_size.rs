//! How long the next step is.

use crate::running::error::StepError;
use crate::scalar::Real;
use crate::space::{Record, Tape};

/// Lengths between two powers of 2.
const RUNGS: [f64; 4] = [1.0, 1.189_207_115_002_721, core::f64::consts::SQRT_2, 1.681_792_830_507_429];

/// How far errors stay below the tolerance, so that few steps are rejected.
const SAFETY: f64 = 0.9;

/// The error of the step before is counted as this at least: after one that was far too short the next is judged by its own.
const LEAST: f64 = 1e-4;

/// Steps never become longer, or, after a rejection, shorter by more rungs than this.
const LEAP: f64 = 8.0;

/// The shortest and the longest step.
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
    /// Returns bounds for steps that change the time `t`, and that are no zero beside 1 and the time in which a state changes.
    pub(crate) fn at(&self, t: f64, epsilon: f64, pace: f64) -> Bounds {
        let zero = epsilon * epsilon * epsilon * epsilon * pace.min(1.0);
        Bounds { shortest: self.shortest.max(4.0 * epsilon * t.abs()).max(zero), ..*self }
    }

    /// That there is a step between them.
    pub(crate) fn check(&self) -> Result<(), StepError> {
        let Bounds { shortest, longest } = *self;
        let good = longest > 0.0 && shortest <= longest && shortest < f64::INFINITY;
        if good { Ok(()) } else { Err(StepError::InvalidBounds { shortest, longest }) }
    }
}

/// A proportional and integral controller: h ← h·(1/e)^(0.7/(p+1))·e₋₁^(0.4/(p+1)) for errors e, e₋₁ of the last two steps in units
/// of the tolerance. K. Gustafsson, M. Lundh & G. Söderlind, BIT 28 (1988) 270; constants of Hairer & Wanner, *Solving Ordinary
/// Differential Equations II* (1996), section IV.2.
///
/// It climbs a ladder of lengths, a rung at least or not at all.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Controller {
    /// p + 1.
    exponent: f64,
    /// |h| = 2^(rung/4).
    rung: f64,
    backwards: bool,
    before: f64,
    /// The same in rungs, ready before the next error is.
    rungs_before: f64,
    rejected: bool,
    /// The time in which the first state changes; 1 if it is not known.
    pub(crate) pace: f64,
}

impl<R> Record<R> for Controller {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        tape.number(&mut self.rung);
        tape.flag(&mut self.backwards);
        tape.number(&mut self.before);
        self.rungs_before = rungs(self.before.max(LEAST));
        tape.flag(&mut self.rejected);
        tape.number(&mut self.pace);
    }
}

impl Controller {
    pub(crate) fn new(order: u32) -> Self {
        let exponent = f64::from(order) + 1.0;
        Controller { exponent, rung: 0.0, backwards: false, before: 1.0, rungs_before: 0.0, rejected: false, pace: 1.0 }
    }

    /// From the time in which the state changes.
    pub(crate) fn start(&mut self, time: f64, tolerance: f64) {
        self.pace = if time > 0.0 && time < f64::INFINITY { time } else { 1.0 };
        let h = time * self.part(tolerance);
        self.set(if h > 0.0 && h < f64::INFINITY { h } else { 1.0 });
    }

    /// What part of the time in which the state changes a step takes, if it has the tolerance for error.
    pub(crate) fn part(&self, tolerance: f64) -> f64 {
        Real::powf(tolerance, 1.0 / self.exponent)
    }

    pub(crate) fn set(&mut self, h: f64) {
        self.rung = rung(h);
        self.backwards = h < 0.0;
    }

    pub(crate) fn turn(&mut self, backwards: bool) {
        self.backwards = backwards;
    }

    /// The first step, if it is zero, infinite or not a number.
    pub(crate) fn unusable(&self) -> Option<f64> {
        (!self.rung.is_finite()).then(|| Real::exp2(self.rung / 4.0))
    }

    /// The next step.
    pub(crate) fn step(&self, bounds: &Bounds) -> f64 {
        // A step that is refused can be shortened if its length is a number.
        let h = self.length().max(bounds.shortest).min(bounds.longest).min(f64::MAX);
        if self.backwards { -h } else { h }
    }

    /// The length of this rung.
    fn length(&self) -> f64 {
        let octave = floor(self.rung / 4.0);
        power_of_two(octave) * RUNGS[((self.rung - 4.0 * octave) as usize).min(3)]
    }

    /// A step `h`, of the controller's length within bounds, had this error.
    pub(crate) fn accept(&mut self, h: f64, error: f64) {
        let in_rungs = rungs(error);
        // Without end where there is no error.
        let wish = rungs(SAFETY) + (0.4 * self.rungs_before - 0.7 * in_rungs) / self.exponent;
        let most = if self.rejected { 0.0 } else { LEAP };
        // The next length waits for this: no logarithm of a length whose rung is known.
        let rung = if h.abs() == self.length() { self.rung } else { rung(h) };
        self.rung = rung + floor(wish).clamp(-LEAP, most);
        (self.before, self.rejected) = (error, false);
        self.rungs_before = if error > LEAST { in_rungs } else { rungs(LEAST) };
    }

    /// A step `h` had this error, or no result at all.
    pub(crate) fn reject(&mut self, h: f64, error: Option<f64>) {
        let fall = error.map_or(-4.0, |error| floor(rungs(SAFETY) - rungs(error) / self.exponent));
        self.rung = self.rung.min(rung(h)) + fall.clamp(-LEAP, -1.0);
        self.rejected = true;
    }
}

/// 2ⁿ, without a function call for n of normal numbers.
fn power_of_two(n: f64) -> f64 {
    if n.abs() < f64::from(f64::MAX_EXP - 1) {
        f64::from_bits(((n as i64 + i64::from(f64::MAX_EXP - 1)) as u64) << (f64::MANTISSA_DIGITS - 1))
    } else {
        Real::exp2(n)
    }
}

/// Rungs from length 1 to `length`.
fn rungs(length: f64) -> f64 {
    4.0 * Real::log2(length)
}

/// The rung nearest to a step.
fn rung(h: f64) -> f64 {
    floor(rungs(h.abs()) + 0.5)
}

/// Not in the core library.
fn floor(x: f64) -> f64 {
    libm::floor(x)
}

#[cfg(test)]
mod tests {
    use super::{Controller, power_of_two, rung};

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
            let mut controller = Controller::new(4);
            controller.rung = f64::from(rungs);
            assert_eq!(rung(controller.length()), controller.rung);
        }
    }
}

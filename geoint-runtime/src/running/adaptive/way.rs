//! What lies on the way of a step of which the estimated error says nothing?

use super::attempt::{Attempt, Carried};
use crate::scalar::Real;
use crate::solving::rounding::ROUNDINGS;
use crate::space::{PerCoordinate, Point, Record, Tape};
use crate::system::{PhaseSpace, Rates};

/// An error of less than this part of what is tolerated says nothing of the way: the field may be constant to rounding. Errors of steps that follow from
/// the tolerance are larger. Where the tolerance is near rounding all errors are, and one of the second part tells.
const TELLS: f64 = 1e-4;
const TELLS_NEAR_ROUNDING: f64 = 0.05;

/// After so many steps in a row whose errors tell, the run follows the scales of the field. A single one may have touched a barrier far away.
const ENOUGH: u64 = 4;

/// A step that is longer by this factor than those is as unknown as the first one.
const GROWTH: f64 = 4.0;

/// Points in a step that is not cut short, if its error tells or not; per time in which the state changes; and at most. A barrier wider than their
/// distance is seen.
const POINTS_IF_TOLD: f64 = 16.0;
const POINTS: f64 = 64.0;
const MOST_POINTS: f64 = 1024.0;

/// A rate on the way that differs by more than this part of what the ends of the step tell is another force.
const OTHER: f64 = 0.5;

/// The steps in a row whose errors told how far the field is what it is at the start.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Told {
    steps: u64,
    longest: f64,
}

impl<R> Record<R> for Told {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        tape.steps(&mut self.steps);
        tape.number(&mut self.longest);
    }
}

impl Told {
    /// Returns whether an error, in units of what is tolerated, tells of the field.
    pub(super) fn tells<R: Real>(error: f64, tolerance: f64) -> bool {
        error > TELLS.max((ROUNDINGS * R::epsilon() / tolerance).min(TELLS_NEAR_ROUNDING))
    }

    /// Returns whether the field is known as far as a step of length `h` reaches, if its error tells or not.
    #[inline(always)]
    pub(super) fn covers(&self, h: f64, tells: bool) -> bool {
        self.steps >= ENOUGH && h.abs() <= if tells { GROWTH * self.longest } else { self.longest }
    }

    /// Includes a step of length `h`.
    #[inline(always)]
    pub(super) fn include(&mut self, h: f64, tells: bool) {
        if tells {
            *self = Told { steps: self.steps.saturating_add(1), longest: self.longest.max(h.abs()) };
        } else if h.abs() > self.longest {
            *self = Told::default();
        }
    }
}

impl<S: PhaseSpace<R> + Rates<R>, R: Real> Attempt<'_, S, R> {
    /// Returns whether the field between the ends of a step of length `h` to `x` is another one than the step has seen: a force that it went by, or one
    /// that it met at a single point and took for that of the whole way.
    ///
    /// `whole` is the part of a regular step that it is. Between the ends the state follows the cubic that has their states and rates.
    #[cold]
    #[inline(never)]
    pub(super) fn misses_force(&self, h: f64, tells: bool, whole: f64, x: &Carried<S, R>) -> bool {
        let [before, after] = [self.x, x].map(|x: &Point<_, _, _>| PerCoordinate::of(x));
        let end = self.end(h, x);
        let rates = [self.system.rates(self.t, &before), self.system.rates(end, &after)];
        let length = R::from_f64(h);
        let mut change = after;
        change.add_scaled(R::from_f64(-1.0), &before);
        let least = whole * if tells { POINTS_IF_TOLD } else { POINTS };
        let points = libm::ceil((POINTS * h.abs() / self.pace(&rates[0])).clamp(least, MOST_POINTS));
        (1..points as u32).any(|point| {
            let part = f64::from(point) / points;
            let rest = 1.0 - part;
            // The cubic, and its derivative by `part`.
            let (mut state, mut slope) = (before, PerCoordinate::zero());
            state.add_scaled(R::from_f64(part * part * (3.0 - 2.0 * part)), &change);
            state.add_scaled(R::from_f64(part * rest * rest) * length, &rates[0]);
            state.add_scaled(R::from_f64(-part * part * rest) * length, &rates[1]);
            slope.add_scaled(R::from_f64(6.0 * part * rest), &change);
            slope.add_scaled(R::from_f64(rest * (1.0 - 3.0 * part)) * length, &rates[0]);
            slope.add_scaled(R::from_f64(part * (3.0 * part - 2.0)) * length, &rates[1]);
            let seen = self.system.rates(self.t + R::from_f64(part) * length, &state);
            (0..PerCoordinate::<S::Phase, S::Action>::LEN).any(|i| {
                let by_ends = rates.each_ref().map(|rates| (length * rates.at(i)).magnitude());
                let known = by_ends.into_iter().fold(change.at(i).magnitude(), f64::max);
                let gap = (length * seen.at(i) - slope.at(i)).magnitude();
                // Where there are no rates is a matter of domains.
                gap < f64::INFINITY
                    && gap > OTHER * known
                    && gap > self.tolerance.of(i, after.at(i).magnitude(), self.part)
            })
        })
    }

    /// The time in which the coordinate that changes fastest does so by itself; zero if none moves that has a size, and nothing is known of it.
    fn pace(&self, rates: &PerCoordinate<S::Phase, S::Action>) -> f64 {
        let by_itself = |(size, rate): (R, R)| match size.magnitude() {
            0.0 => f64::INFINITY,
            size => size / rate.magnitude(),
        };
        let pace = self.tolerance.sizes.numbers().zip(rates.numbers()).map(by_itself).fold(f64::INFINITY, f64::min);
        if pace < f64::INFINITY { pace } else { 0.0 }
    }
}

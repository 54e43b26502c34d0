//! Checks the field between the ends of a step whose estimated error is uninformative.

use super::attempt::{Attempt, Carried};
use crate::scalar::Real;
use crate::space::{PerCoordinate, Point, Record, Tape};
use crate::system::{PhaseSpace, Rates};

/// A larger error, in units of the tolerance, is informative: the step length then follows the scales of the field. With a smaller error, the field
/// may be constant up to rounding. Near the rounding limit the threshold is `FEW_ROUNDINGS` ε/tolerance, but at most `INFORMATIVE_NEAR_ROUNDING`.
const INFORMATIVE_ERROR: f64 = 1e-5;
const FEW_ROUNDINGS: f64 = 4.0;
const INFORMATIVE_NEAR_ROUNDING: f64 = 0.05;

/// After this many informative steps in a row, the step length follows the scales of the field. A single step may have touched a distant barrier by
/// chance.
const ENOUGH_STEPS: u64 = 2;

/// A step longer than these steps by more than this factor needs a new check.
const GROWTH: f64 = 4.0;

/// Numbers of points. `POINTS_IF_INFORMATIVE`: in an uncut step with informative error. `POINTS`: in another uncut step, and in the time in which the state
/// changes. `MOST_POINTS`: upper limit. The check detects barriers that are wider than the distance between points.
const POINTS_IF_INFORMATIVE: f64 = 8.0;
const POINTS: f64 = 32.0;
const MOST_POINTS: f64 = 1024.0;

/// A rate that differs from the interpolated one by more than this part of the change over the step belongs to another force.
const RATE_DEVIATION: f64 = 0.5;

/// Consecutive steps with informative errors: their number and the longest length.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct InformativeSteps {
    steps: u64,
    longest: f64,
}

impl<R> Record<R> for InformativeSteps {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        tape.steps(&mut self.steps);
        tape.number(&mut self.longest);
    }
}

impl InformativeSteps {
    /// Returns whether an error, in units of the tolerance, is informative.
    pub(super) fn is_informative<R: Real>(error: f64, tolerance: f64) -> bool {
        error > INFORMATIVE_ERROR.max((FEW_ROUNDINGS * R::epsilon() / tolerance).min(INFORMATIVE_NEAR_ROUNDING))
    }

    /// Returns whether the field needs no check within a step of length `h`. `informative`: whether the error of the step is informative.
    #[inline(always)]
    pub(super) fn covers(&self, h: f64, informative: bool) -> bool {
        self.steps >= ENOUGH_STEPS && h.abs() <= if informative { GROWTH * self.longest } else { self.longest }
    }

    /// Returns the minimum number of points in a step that is the part `whole` of a regular step.
    pub(super) fn least_points(informative: bool, whole: f64) -> f64 {
        whole * if informative { POINTS_IF_INFORMATIVE } else { POINTS }
    }

    /// Returns the minimum number of points in the first step. Its regular length is a guess, so the check uses all points if the step is cut short.
    pub(super) fn least_points_at_first(whole: f64) -> f64 {
        if whole < 1.0 { MOST_POINTS } else { POINTS }
    }

    /// Includes an accepted step of length `h`. `informative`: whether its error is informative.
    #[inline(always)]
    pub(super) fn include(&mut self, h: f64, informative: bool) {
        if informative {
            *self = InformativeSteps { steps: self.steps.saturating_add(1), longest: self.longest.max(h.abs()) };
        } else if h.abs() > self.longest {
            *self = InformativeSteps::default();
        }
    }
}

impl<S: PhaseSpace<R> + Rates<R>, R: Real> Attempt<'_, S, R> {
    /// Returns whether a step of length `h` to `x` missed a force between its ends. The step may have passed a barrier, or may have met a force at
    /// one point and applied it to the whole step.
    ///
    /// The rates are compared with the cubic Hermite interpolant of the states and rates at both ends, at `least` points or more.
    #[cold]
    #[inline(never)]
    pub(super) fn misses_force(&self, h: f64, least: f64, x: &Carried<S, R>) -> bool {
        let [before, after] = [self.x, x].map(|x: &Point<_, _, _>| PerCoordinate::of(x));
        let end = self.end(h, x);
        let rates = [self.system.rates(self.t, &before), self.system.rates(end, &after)];
        let length = R::from_f64(h);
        let mut change = after;
        change.add_scaled(R::from_f64(-1.0), &before);
        let times = [self.pace(&rates[0]), self.time_of_start];
        // For a state at rest no time is known: use the maximum number of points.
        let time = times.into_iter().find(|time| time.is_finite()).unwrap_or(0.0);
        let points = libm::ceil((POINTS * h.abs() / time).clamp(least, MOST_POINTS));
        (1..points as u32).any(|point| {
            let part = f64::from(point) / points;
            let rest = 1.0 - part;
            // Hermite cubic, and its derivative with respect to `part`.
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
                // Points without finite rates are left to the check of the domain.
                gap < f64::INFINITY
                    && gap > RATE_DEVIATION * known
                    && gap > self.tolerance.of(i, after.at(i).magnitude(), self.part)
            })
        })
    }

    /// Returns the shortest time in which a coordinate changes by its own size. Infinite if no coordinate with a size moves.
    fn pace(&self, rates: &PerCoordinate<S::Phase, S::Action>) -> f64 {
        let by_itself = |(size, rate): (R, R)| match size.magnitude() {
            0.0 => f64::INFINITY,
            size => size / rate.magnitude(),
        };
        self.tolerance.sizes.numbers().zip(rates.numbers()).map(by_itself).fold(f64::INFINITY, f64::min)
    }
}

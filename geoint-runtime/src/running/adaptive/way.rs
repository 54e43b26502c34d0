//! What lies on the way of a step of which the estimated error says nothing?

use super::attempt::{Attempt, Carried};
use crate::scalar::Real;
use crate::space::{PerCoordinate, Point, Record, Tape};
use crate::system::{PhaseSpace, Rates};

/// An error below this part of the tolerance says nothing of the way: the field may be constant to rounding. Steps that follow from the tolerance have
/// larger errors. Near rounding all errors are larger: there an error tells above so many ε, or above the last part.
const TELLS: f64 = 1e-5;
const FEW_ROUNDINGS: f64 = 4.0;
const TELLS_NEAR_ROUNDING: f64 = 0.05;

/// After so many steps in a row whose errors tell, the run follows the scales of the field. A single step may have touched a barrier far away.
const ENOUGH: u64 = 2;

/// A step that is longer by this factor than these steps is as unknown as the first one.
const GROWTH: f64 = 4.0;

/// Numbers of points: in a step that is not cut short, if its error tells or not; per time in which the state changes; and at most. A barrier is seen if
/// it is wider than the distance of the points.
const POINTS_IF_TOLD: f64 = 8.0;
const POINTS: f64 = 32.0;
const MOST_POINTS: f64 = 1024.0;

/// A rate on the way that differs by more than this part of what the ends of the step tell is another force.
const OTHER: f64 = 0.5;

/// The steps in a row whose errors told how far the field stays what it is.
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
        error > TELLS.max((FEW_ROUNDINGS * R::epsilon() / tolerance).min(TELLS_NEAR_ROUNDING))
    }

    /// Returns whether the field is known as far as a step of length `h` reaches, if its error tells or not.
    #[inline(always)]
    pub(super) fn covers(&self, h: f64, tells: bool) -> bool {
        self.steps >= ENOUGH && h.abs() <= if tells { GROWTH * self.longest } else { self.longest }
    }

    /// Returns the least number of points in a step that is the part `whole` of a regular one.
    pub(super) fn least_points(tells: bool, whole: f64) -> f64 {
        whole * if tells { POINTS_IF_TOLD } else { POINTS }
    }

    /// Returns the least number of points in the first step. The length of a regular one is then a guess, which says nothing if the step is cut short.
    pub(super) fn least_points_at_first(whole: f64) -> f64 {
        if whole < 1.0 { MOST_POINTS } else { POINTS }
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
    /// Returns whether a step of length `h` to `x` has not seen the field between its ends: it went by a force, or met one at a single point and took it for
    /// that of the whole way. The field is compared at `least` points or more, along the cubic that has the states and the rates of both ends.
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
        // Of a state at rest nothing is known: as many points as there may be.
        let time = times.into_iter().find(|time| time.is_finite()).unwrap_or(0.0);
        let points = libm::ceil((POINTS * h.abs() / time).clamp(least, MOST_POINTS));
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

    /// Returns the time in which the coordinate that changes fastest does so by itself; infinite if no coordinate moves that has a size.
    fn pace(&self, rates: &PerCoordinate<S::Phase, S::Action>) -> f64 {
        let by_itself = |(size, rate): (R, R)| match size.magnitude() {
            0.0 => f64::INFINITY,
            size => size / rate.magnitude(),
        };
        self.tolerance.sizes.numbers().zip(rates.numbers()).map(by_itself).fold(f64::INFINITY, f64::min)
    }
}

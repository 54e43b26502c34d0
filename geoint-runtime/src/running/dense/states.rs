//! Finds changes of sign of functions of the state, from values between the ends of steps.

use super::crossings::Functions;
use super::noise::noise;
use super::roots::{differ, excursion, illinois};
use super::{Dense, Scalar, StepError};
use crate::running::trajectory::Trajectory;
use crate::scalar::{Real, signed};
use crate::solving::Failure;
use crate::space::Array;
use crate::taylor::Roots;

/// Parts of a step at which the sign of a function that starts at zero is tested. The first one with a value above rounding decides. Large parts are
/// needed in single precision and after a long time, when time itself is rounded by a large part of a step.
const SHORT_PARTS: [f64; 4] = [1.0 / (1 << 20) as f64, 1.0 / (1 << 10) as f64, 1.0 / 64.0, 1.0 / 8.0];

/// Accuracy of the time of an event, in rounding errors of time.
const TIME_ROUNDINGS: f64 = 8.0;

/// Functions of the state along any run. Between the ends of steps, they are evaluated at single states.
#[derive(Debug)]
pub struct StateFunctions<'a, T: Dense, F, G> {
    run: &'a mut T,
    /// The run at the start of the last step.
    before: T,
    g: F,
    /// Whether the run was at an event of an earlier search when this search began.
    starts_at_event: bool,
    /// Values at the start and at the end of the last step.
    values: Option<[G; 2]>,
    /// Position and values one step earlier.
    earlier: Option<(f64, G)>,
}

impl<'a, T: Dense, F: Fn(&T::State) -> G, G: Array<Real = Scalar<T>>> StateFunctions<'a, T, F, G> {
    pub(super) fn new(run: &'a mut T, g: F) -> Self {
        let now = run.time();
        let starts_at_event = run.reported().is_at(now);
        StateFunctions { before: run.clone(), run, g, starts_at_event, values: None, earlier: None }
    }

    /// Returns the values at the present state. Fails if a value is not finite.
    fn values_here(&self) -> Result<G, StepError> {
        let values = (self.g)(&self.run.state());
        if values.as_slice().iter().all(|g| g.magnitude().is_finite()) {
            Ok(values)
        } else {
            Err(StepError::without_step(Failure::NoEvent, signed(self.run.time())))
        }
    }

    /// Returns the values of a function at the ends of the last step.
    fn ends(&self, i: usize) -> [f64; 2] {
        self.values.map_or([0.0; 2], |ends| ends.map(|g| signed(g.as_slice()[i])))
    }

    /// Returns the first part of the step at which a function has a sign, and its value there. The part is 0 unless the function starts at zero, as
    /// after an event. The value is zero if the function does not leave zero, up to rounding.
    fn leaving(&self, i: usize, [start, end]: [f64; 2]) -> Result<(f64, f64), StepError> {
        let noise = self.noise(&self.before, i);
        // At the event just found, rounding of time explains the value. After a step, the value belongs to the function.
        let change = (end - start).abs();
        let own = (4.0 * noise).max(if self.before.is_fresh() {
            change
        } else {
            TIME_ROUNDINGS * Scalar::<T>::epsilon() * change
        });
        if start.abs() > own {
            return Ok((0.0, start));
        }
        // Rounding of the times contributes as well.
        let step = (self.run.time() - self.before.time()).magnitude();
        let part = TIME_ROUNDINGS * Scalar::<T>::epsilon() * (1.0 + self.run.time().magnitude() / step);
        let rounding =
            |(at, value): (f64, f64)| 4.0 * noise + part * (end - start).abs().max((value - start).abs() / at);
        let mut is_at_event = self.starts_at_event && self.before.is_fresh();
        for at in SHORT_PARTS {
            let later = (at, self.value(i, at)?);
            if is_at_event {
                // A jump within the shortest part that time resolves is the event at which the search starts.
                if differ(start, later.1) && (later.1 - start).abs() > 0.5 * change {
                    return Ok(later);
                }
                if self.time(at) == self.before.time() {
                    continue;
                }
                is_at_event = false;
            }
            if start.abs() > rounding(later) {
                return Ok((0.0, start));
            }
            if later.1.abs() > rounding(later) {
                return Ok(later);
            }
        }
        Ok((1.0, if end.abs() > rounding((1.0, end)) { end } else { 0.0 }))
    }

    /// Returns the rounding error of a function at the state of a run.
    fn noise(&self, run: &T, i: usize) -> f64 {
        noise(&run.state(), |state| signed((self.g)(state).as_slice()[i]))
    }

    /// Returns the time at a part of the last step.
    fn time(&self, part: f64) -> Scalar<T> {
        let (start, end) = (self.before.time(), self.run.time());
        start + Scalar::<T>::from_f64(part) * (end - start)
    }

    /// Returns a function at a part of the last step. Fails if the value is not a number. It may be infinite at a pole.
    fn value(&self, i: usize, part: f64) -> Result<f64, StepError> {
        let t = self.time(part);
        let value = signed((self.g)(&T::between(&self.before, self.run, t)?).as_slice()[i]);
        if value.is_nan() { Err(StepError::without_step(Failure::NoEvent, signed(t))) } else { Ok(value) }
    }
}

impl<T: Dense, F: Fn(&T::State) -> G, G: Array<Real = Scalar<T>>> Functions for StateFunctions<'_, T, F, G> {
    type Run = T;
    type Values = G;
    /// A change at the start, two changes within the step, and one at the end of the search.
    type Places = [f64; 4];

    fn run(&mut self) -> &mut T {
        self.run
    }

    fn advance(&mut self, take: impl FnOnce(&mut T) -> Result<bool, StepError>) -> Result<bool, StepError> {
        let start = self.values.map_or_else(|| self.values_here(), |[_, end]| Ok(end))?;
        let before = self.run.clone();
        if !take(self.run)? {
            return Ok(false);
        }
        let end = self.values_here()?;
        let [earlier, now, later] = [self.before.time(), before.time(), self.run.time()];
        self.earlier = self.values.map(|[values, _]| (-signed(now - earlier) / signed(later - now), values));
        (self.before, self.values) = (before, Some([start, end]));
        Ok(true)
    }

    /// In a single short step, a function may seem to be zero without being so. Two steps are needed.
    fn are_zero(&self) -> bool {
        matches!((self.earlier, self.values), (Some((_, a)), Some([b, c])) if [a, b, c].iter().all(G::is_zero))
    }

    fn changes(&self, i: usize, side: f64) -> Result<Roots<[f64; 4]>, StepError> {
        let mut ends = self.ends(i);
        if side != 0.0 && ends == [0.0; 2] {
            // Zero at both ends: the sign midway is used instead.
            ends[1] = self.value(i, 0.5)?;
        }
        // First point at which the function has a sign, and a value with this sign.
        let (from, value) = match ends[0] {
            _ if side == 0.0 => self.leaving(i, ends)?,
            0.0 => (0.0, side),
            start => (0.0, start),
        };
        if value == 0.0 {
            return Ok(Roots::none(0.0));
        }
        let mut found = Roots::none(value.signum());
        if from > 0.0 {
            found.push(0.0);
            found.sign = -found.sign;
        }
        let mut g = |part: f64| self.value(i, part);
        if differ(value, ends[1]) {
            let in_joint = ends[0] == 0.0 && from == 0.0;
            let root = if in_joint { Some(0.0) } else { illinois([(from, value), (1.0, ends[1])], &mut g)? };
            found.push(root.unwrap_or(f64::NAN));
        } else if ends[1] != 0.0 && from < 1.0 && (ends[0] != 0.0 || from > 0.0) {
            let earlier = match &self.earlier {
                Some((part, values)) if values.as_slice()[i].magnitude() > 0.0 => (*part, signed(values.as_slice()[i])),
                _ => (SHORT_PARTS[1], g(SHORT_PARTS[1])?),
            };
            if let Some(there) = excursion(earlier, [value, ends[1]], &mut g)? {
                for bracket in [[(from, value), there], [there, (1.0, ends[1])]] {
                    found.push(illinois(bracket, &mut g)?.unwrap_or(f64::NAN));
                }
            }
        }
        Ok(found)
    }

    fn state(&self, _: usize, at: f64) -> Result<Option<T::State>, StepError> {
        match at {
            0.0 => Ok(Some(self.before.state())),
            1.0 => Ok(Some(self.run.state())),
            part => T::between(&self.before, self.run, self.time(part)).map(Some),
        }
    }

    fn is_zero_at_end(&self, i: usize) -> bool {
        let [start, end] = self.ends(i);
        end.abs() <= 8.0 * Scalar::<T>::epsilon() * (start - end).abs() + 4.0 * self.noise(self.run, i)
    }
}

//! Finds changes of sign of a function of the state between the ends of steps.

use super::crossing::{Crossing, Direction, MOST_ZERO_STEPS, NEAR_END, check_end, next};
use super::roots::{differ, excursion, illinois};
use super::{Dense, has_reached, step};
use crate::running::StepError;
use crate::running::trajectory::Scalar;
use crate::scalar::{Real, signed};
use crate::solving::Failure;
use crate::space::{Action, Array, Snapshot};

/// Parts of a step at which the sign of a function that starts at zero is tested. The first one with a value above rounding decides. Large parts are
/// needed in single precision and after a long time, when time itself is rounded by a large part of a step.
const SHORT_PARTS: [f64; 4] = [1.0 / (1 << 20) as f64, 1.0 / (1 << 10) as f64, 1.0 / 64.0, 1.0 / 8.0];

/// Accuracy of the time of an event, in rounding errors of time.
const TIME_ROUNDINGS: f64 = 8.0;

/// Iterator over the crossings of a run, in order of time. Ends after the first error, or at a time.
#[doc(alias("Poincaré section", "Poincare section", "surface of section", "event detection", "zero crossing"))]
#[derive(Debug)]
pub struct Crossings<'a, T: Dense, F, G> {
    run: &'a mut T,
    before: T,
    g: F,
    direction: Direction,
    end: Option<Scalar<T>>,
    backwards: bool,
    /// Values at the start and at the end of the last step.
    values: Option<[G; 2]>,
    /// Signs before the last step; 0 if a function had none yet.
    sides: G,
    /// Time and values one step earlier. The time is in parts of the last step.
    earlier: Option<(f64, G)>,
    zeros: u32,
    /// Zeros of the functions in the last step, at most two for each, as parts of the step. NaN if there is no zero, or if it was returned already.
    roots: [G; 2],
    /// Signs after these zeros.
    rises: [G; 2],
    /// Functions that had a zero next to the end of the last step: 1, otherwise 0.
    near: G,
    /// Number of functions already checked for a zero at the end, once no step is left.
    asked: usize,
    /// Whether to take a shorter last step to the end.
    all_the_way: bool,
    done: bool,
}

/// Returns NaN for each function: no zeros.
fn none<G: Array>() -> G {
    let mut none = G::zero();
    none.as_mut_slice().fill(G::Real::from_f64(f64::NAN));
    none
}

impl<'a, T: Dense, F: Fn(&T::State) -> G, G: Array<Real = Scalar<T>>> Crossings<'a, T, F, G> {
    pub(super) fn new(run: &'a mut T, direction: Direction, g: F) -> Self {
        let (before, backwards) = (run.clone(), run.steps_backwards());
        Crossings {
            run,
            before,
            g,
            direction,
            end: None,
            backwards,
            values: None,
            sides: G::zero(),
            earlier: None,
            zeros: 0,
            roots: [none(); 2],
            rises: [G::zero(); 2],
            near: G::zero(),
            asked: 0,
            all_the_way: false,
            done: false,
        }
    }

    /// Limits the search to a time, before or after the present time. Zeros at this time, up to rounding, count. Runs with fixed steps end up to a
    /// step before it.
    #[must_use = "the end is that of the iterator that is returned"]
    pub fn until(mut self, t: Scalar<T>) -> Self {
        self.backwards = (t - self.run.time()).any_below(0.0);
        self.end = Some(t);
        self
    }

    /// Returns the first crossing up to the end. If there is none, the run is at the end. The last step may be shorter.
    pub(super) fn first(mut self) -> Result<Option<Crossing<T::State>>, StepError> {
        self.all_the_way = true;
        self.next().transpose()
    }

    /// Takes a shorter step to the end of the search. Returns `false` if the run is there, or does not go there.
    fn go_on(&mut self) -> Result<bool, StepError> {
        let is_left = |t: &Scalar<T>| t.magnitude().is_finite() && !has_reached(self.run.time(), *t, self.backwards);
        let ahead = self.all_the_way && self.backwards == self.run.steps_backwards();
        let Some(t) = self.end.filter(|t| ahead && is_left(t)) else { return Ok(false) };
        self.run.end_at(t)?;
        Ok(true)
    }

    /// Returns the values at the present state. Fails if a value is not finite.
    fn values(&self) -> Result<G, StepError> {
        let values = (self.g)(&self.run.state());
        let t = signed(self.run.time());
        if values.as_slice().iter().all(|g| g.magnitude().is_finite()) {
            Ok(values)
        } else {
            Err(StepError::without_step(Failure::NoEvent, t))
        }
    }

    /// Takes the next step and finds the zeros in it. Returns `false` if nothing is left.
    fn step(&mut self) -> Result<bool, StepError> {
        check_end(self.end, self.run.time())?;
        let (first, before) = match self.values {
            Some([_, now]) => (false, now),
            None => (true, self.values()?),
        };
        let start = self.before.time();
        self.before = self.run.clone();
        let stepped = match self.end {
            Some(t) if has_reached(self.run.time(), t, self.backwards) => false,
            Some(t) => self.run.step_towards(t)?,
            None => step(self.run, self.backwards)?,
        };
        if !stepped && !self.go_on()? {
            return self.stop(!first);
        }
        let after = self.values()?;
        let passed = |from: Scalar<T>, to: Scalar<T>| signed(to - from);
        self.earlier = self.values.map(|[earlier, _]| {
            let step = passed(self.before.time(), self.run.time());
            (-passed(start, self.before.time()) / step, earlier)
        });
        self.values = Some([before, after]);
        let mut all_zero = G::LEN > 0;
        for i in 0..G::LEN {
            let ends = [&before, &after].map(|g| signed(g.as_slice()[i]));
            all_zero &= ends == [0.0; 2];
            self.search(i, ends)?;
        }
        self.zeros = if all_zero { self.zeros + 1 } else { 0 };
        if self.zeros >= MOST_ZERO_STEPS {
            return Err(StepError::without_step(Failure::NoEvent, signed(self.run.time())));
        }
        Ok(true)
    }

    /// Finds the zeros of function `i` in the last step. `ends`: its values at the ends of the step.
    fn search(&mut self, i: usize, mut ends: [f64; 2]) -> Result<(), StepError> {
        let side = signed(self.sides.as_slice()[i]);
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
            return Ok(());
        }
        let crosses_at_start = side == 0.0 && from > 0.0 && self.crosses_at_start(i, value);
        let mut found = [f64::NAN; 2];
        if differ(value, ends[1]) {
            let in_joint = ends[0] == 0.0 && from == 0.0;
            let mut g = |part: f64| self.value(i, part);
            let root = if in_joint { Some(0.0) } else { illinois([(from, value), (1.0, ends[1])], &mut g)? };
            found[0] = root.unwrap_or(f64::NAN);
        } else if ends[1] != 0.0 && from < 1.0 && (ends[0] != 0.0 || from > 0.0) {
            let mut g = |part: f64| self.value(i, part);
            let earlier = match &self.earlier {
                Some((part, values)) if values.as_slice()[i].magnitude() > 0.0 => (*part, signed(values.as_slice()[i])),
                _ => (SHORT_PARTS[1], g(SHORT_PARTS[1])?),
            };
            if let Some(there) = excursion(earlier, [value, ends[1]], &mut g)? {
                let roots = [[(from, value), there], [there, (1.0, ends[1])]];
                for (found, bracket) in found.iter_mut().zip(roots) {
                    *found = illinois(bracket, &mut g)?.unwrap_or(f64::NAN);
                }
            }
        }
        if crosses_at_start {
            // `found` has room for one more zero. If there are two, a search from the event finds them again.
            found = [0.0, if found[1].is_nan() { found[0] } else { f64::NAN }];
        }
        let near = found.iter().any(|root| *root > NEAR_END);
        let behind = if found[1].is_nan() { [ends[1].signum(), 0.0] } else { [-ends[1].signum(), ends[1].signum()] };
        for (k, sign) in behind.into_iter().enumerate() {
            let root = if self.direction.counts(sign) { found[k] } else { f64::NAN };
            self.roots[k].as_mut_slice()[i] = Scalar::<T>::from_f64(root);
            self.rises[k].as_mut_slice()[i] = Scalar::<T>::from_f64(sign);
        }
        let end = if ends[1] != 0.0 { ends[1].signum() } else { value.signum() };
        self.sides.as_mut_slice()[i] = Scalar::<T>::from_f64(end);
        self.near.as_mut_slice()[i] = Scalar::<T>::from_f64(f64::from(u8::from(near)));
        Ok(())
    }

    /// Returns whether a function that is zero at the start of the search has an event there. `later` has its sign after the start. There must be an
    /// event of other functions at this time.
    fn crosses_at_start(&mut self, i: usize, later: f64) -> bool {
        let (t, counts) = (self.before.time(), self.direction.counts(later));
        later != 0.0 && self.run.reported().is_at(t) && self.run.reported().takes(i, counts)
    }

    /// Returns the first part of the step at which a function has a sign, and its value there. The part is 0 unless the function starts at zero, as
    /// after an event. The value is zero if the function does not leave zero, up to rounding.
    fn leaving(&self, i: usize, [start, end]: [f64; 2]) -> Result<(f64, f64), StepError> {
        let state = self.before.state();
        let noise = self.noise(&state, i);
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
        for at in SHORT_PARTS {
            let later = (at, self.value(i, at)?);
            if start.abs() > rounding(later) {
                return Ok((0.0, start));
            }
            if later.1.abs() > rounding(later) {
                return Ok(later);
            }
        }
        Ok((1.0, if end.abs() > rounding((1.0, end)) { end } else { 0.0 }))
    }

    /// Returns the sum of the changes of a function when each coordinate, and time, is changed by one rounding error.
    fn noise(&self, state: &T::State, i: usize) -> f64 {
        let value = |state: &T::State| signed((self.g)(state).as_slice()[i]);
        let (t, z, s) = state.parts();
        let nudge = |x: &mut Scalar<T>| *x *= Scalar::<T>::from_f64(1.0 + Scalar::<T>::epsilon());
        let mut noise = 0.0;
        let mut include = |(t, z, s)| noise += (value(&T::State::of(t, z, s)) - value(state)).abs();
        for k in 0..z.as_slice().len() {
            let mut z = z;
            nudge(&mut z.as_mut_slice()[k]);
            include((t, z, s));
        }
        let (mut moved, mut later) = (s, t);
        moved.numbers_mut().iter_mut().for_each(nudge);
        nudge(&mut later);
        include((t, z, moved));
        include((later, z, s));
        if noise >= 0.0 { noise } else { 0.0 }
    }

    /// Called when no step is left. Finds a function that is zero up to rounding at the end of the last step, and had no zero just before. Its
    /// crossing is then returned next. Returns `false` if there is none.
    ///
    /// Fails if the end lies in the opposite direction, or if all functions were zero throughout.
    fn stop(&mut self, stepped: bool) -> Result<bool, StepError> {
        if let Some(t) = self.end
            && !has_reached(self.run.time(), t, self.backwards)
            && self.backwards != self.run.steps_backwards()
        {
            return Err(StepError::without_step(Failure::TimePassed, signed(t)));
        }
        let Some([earlier, now]) = self.values.filter(|_| stepped) else { return Ok(false) };
        // In a single short step, a function may seem to be zero without being so. Two steps are needed.
        if self.zeros > 1 && self.sides.is_zero() {
            return Err(StepError::without_step(Failure::NoEvent, signed(self.run.time())));
        }
        for i in self.asked..G::LEN {
            self.asked = i + 1;
            let [before, value, side, near] =
                [&earlier, &now, &self.sides, &self.near].map(|g| signed(g.as_slice()[i]));
            let rounding =
                || 8.0 * Scalar::<T>::epsilon() * (before - value).abs() + 4.0 * self.noise(&self.run.state(), i);
            if side != 0.0 && near == 0.0 && self.direction.counts(-side) && value.abs() <= rounding() {
                self.roots[0].as_mut_slice()[i] = Scalar::<T>::from_f64(1.0);
                self.rises[0].as_mut_slice()[i] = Scalar::<T>::from_f64(-side);
                return Ok(true);
            }
        }
        Ok(false)
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

    /// Returns the first zero in the last step that was not returned yet.
    fn earliest(&mut self) -> Option<Result<Crossing<T::State>, StepError>> {
        let roots =
            (0..G::LEN).flat_map(|i| [(0, i), (1, i)]).map(|(k, i)| (k, i, signed(self.roots[k].as_slice()[i])));
        let (k, which, root) = roots.filter(|(.., root)| !root.is_nan()).min_by(|(.., a), (.., b)| a.total_cmp(b))?;
        self.roots[k].as_mut_slice()[which] = Scalar::<T>::from_f64(f64::NAN);
        let state = match root {
            0.0 => Ok(self.before.state()),
            1.0 => Ok(self.run.state()),
            part => T::between(&self.before, self.run, self.time(part)),
        };
        let rises = signed(self.rises[k].as_slice()[which]) > 0.0;
        Some(state.map(|state| Crossing { state, which, rises }))
    }
}

impl<T: Dense, F: Fn(&T::State) -> G, G: Array<Real = Scalar<T>>> Iterator for Crossings<'_, T, F, G> {
    type Item = Result<Crossing<T::State>, StepError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.done {
            return None;
        }
        let found = next(self, Self::earliest, Self::step);
        self.done = !matches!(found, Some(Ok(_)));
        found
    }
}

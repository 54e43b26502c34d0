//! Iterators over states at given times.

use super::interpolated::{Curve, Exactly, Interpolated, Within};
use super::{Dense, has_reached, step};
use crate::running::StepError;
use crate::running::trajectory::Scalar;
use crate::scalar::{Real, signed};
use crate::solving::Failure;

/// Returns the present state, after the checks of a start.
fn now<T: Dense>(run: &T) -> Result<T::State, StepError> {
    run.check_start().map(|()| run.state())
}

/// A run, and its state before the last step.
#[derive(Debug)]
struct Between<'a, T: Dense, W> {
    run: &'a mut T,
    before: T,
    within: W,
    backwards: bool,
    failed: bool,
}

impl<'a, T: Dense, W: Within<T>> Between<'a, T, W> {
    fn new(run: &'a mut T, backwards: bool) -> Self {
        let before = run.clone();
        Between { run, before, within: W::new(), backwards, failed: false }
    }

    /// Returns the state at the time `t`.
    fn at(&mut self, t: Scalar<T>) -> Result<Option<T::State>, StepError> {
        if !t.magnitude().is_finite() {
            let now = self.run.time();
            return Err(StepError::of_step_size(signed(now), signed(t - now)));
        }
        if has_reached(self.before.time(), t, self.backwards) && self.before.time() != t {
            return Err(StepError::without_step(Failure::TimePassed, signed(t)));
        }
        while !has_reached(self.run.time(), t, self.backwards) {
            self.before = self.run.clone();
            self.within.stepped();
            // A run with fixed steps goes in the other direction.
            if !step(self.run, self.backwards)? {
                return Err(StepError::without_step(Failure::TimePassed, signed(t)));
            }
        }
        if self.run.time() == t {
            return now(self.run).map(Some);
        }
        self.within.state(&self.before, self.run, t).map(Some)
    }

    fn next(&mut self, t: Scalar<T>) -> Option<Result<T::State, StepError>> {
        let outcome = self.at(t).transpose();
        self.failed = !matches!(outcome, Some(Ok(_)));
        outcome
    }
}

/// Iterator over states at equal intervals of time. Ends with the first error.
#[derive(Debug)]
pub struct SampledEvery<'a, T: Dense, W = Exactly> {
    between: Between<'a, T, W>,
    start: Scalar<T>,
    dt: Scalar<T>,
    taken: u64,
}

impl<'a, T: Dense> SampledEvery<'a, T> {
    pub(super) fn new(run: &'a mut T, dt: Scalar<T>) -> Self {
        let start = run.time();
        SampledEvery { between: Between::new(run, dt.any_below(0.0)), start, dt, taken: 0 }
    }

    /// Selects how states within steps are computed.
    fn by<W: Within<T>>(self) -> SampledEvery<'a, T, W> {
        let Between { run, before, backwards, failed, .. } = self.between;
        let between = Between { run, before, within: W::new(), backwards, failed };
        SampledEvery { between, start: self.start, dt: self.dt, taken: self.taken }
    }
}

impl<T: Dense, W: Within<T>> Iterator for SampledEvery<'_, T, W> {
    type Item = Result<T::State, StepError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.between.failed {
            return None;
        }
        let h = signed(self.dt);
        if h == 0.0 || !h.is_finite() {
            self.between.failed = true;
            return Some(Err(StepError::of_step_size(signed(self.between.run.time()), h)));
        }
        // The time is a product, never a running sum.
        let t = Scalar::<T>::time([self.start, Scalar::<T>::from_f64(0.0)], self.taken, self.dt);
        self.taken += 1;
        self.between.next(t)
    }
}

impl<'a, T: Interpolated> SampledEvery<'a, T> {
    /// Computes the states from one polynomial for each step. Many states within a step then cost a few operations each. They have the accuracy of
    /// the run, but invariants are not conserved to rounding.
    ///
    /// ```
    /// use geoint_runtime::prelude::*;
    ///
    /// #[hamiltonian]
    /// fn pendulum(q: f64, p: f64) -> f64 {
    ///     p * p / 2.0 - q.cos()
    /// }
    ///
    /// let mut sim = Pendulum.integrator(Gauss::<3>, 0.1, State::new(1.5, 0.0));
    /// let last = sim.sampled_every(0.001).interpolated().nth(10_000).expect("without end")?;
    /// assert!((last.q + 1.0540491554508432).abs() < 1e-8);
    /// # Ok::<(), StepError>(())
    /// ```
    #[must_use = "the samples are those of the iterator that is returned"]
    pub fn interpolated(self) -> SampledEvery<'a, T, Curve<T>> {
        self.by()
    }
}

/// Iterator over states at given times. Ends with the last time, or after the first error.
#[derive(Debug)]
pub struct SampledAt<'a, T: Dense, I: Iterator<Item = Scalar<T>>, W = Exactly> {
    /// Present once the direction is known: at the first time that differs from the present time.
    between: Option<Between<'a, T, W>>,
    run: Option<&'a mut T>,
    times: I,
}

impl<'a, T: Dense, I: Iterator<Item = Scalar<T>>> SampledAt<'a, T, I> {
    pub(super) fn new(run: &'a mut T, times: I) -> Self {
        SampledAt { between: None, run: Some(run), times }
    }

    /// Selects how states within steps are computed. Called before the first state.
    fn by<W: Within<T>>(self) -> SampledAt<'a, T, I, W> {
        let run = self.run.or(self.between.map(|between| between.run));
        SampledAt { between: None, run, times: self.times }
    }
}

impl<T: Dense, I: Iterator<Item = Scalar<T>>, W: Within<T>> Iterator for SampledAt<'_, T, I, W> {
    type Item = Result<T::State, StepError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.between.as_ref().is_some_and(|between| between.failed) {
            return None;
        }
        let t = self.times.next()?;
        if let Some(run) = self.run.take() {
            if run.time() == t {
                let state = now(run);
                self.run = state.is_ok().then_some(run);
                return Some(state);
            }
            let backwards = (t - run.time()).any_below(0.0);
            self.between = Some(Between::new(run, backwards));
        }
        self.between.as_mut()?.next(t)
    }
}

impl<'a, T: Interpolated, I: Iterator<Item = Scalar<T>>> SampledAt<'a, T, I> {
    /// Computes the states from one polynomial for each step; see [`SampledEvery::interpolated`].
    #[must_use = "the samples are those of the iterator that is returned"]
    pub fn interpolated(self) -> SampledAt<'a, T, I, Curve<T>> {
        self.by()
    }
}

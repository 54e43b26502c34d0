//! The clock: start and end times of steps.

use crate::scalar::{Real, signed, zero};
use crate::space::{DoubleWord, Record, Tape};

/// The start times of steps, t₀ + n·h. They are not a running sum. If the step size changes, t₀ advances as a sum of two words and n restarts at 0.
#[derive(Clone, Copy, Debug)]
pub struct Clock<R> {
    /// t₀, the time from which steps have the length h.
    start: DoubleWord<R>,
    h: R,
    /// n, the number of steps since t₀.
    steps: u64,
    /// The present time as a caller requested it, if it differs from t₀ + n·h by rounding only. Cleared by the next step.
    reported_time: Option<R>,
}

impl<R: Real> Record<R> for Clock<R> {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        self.start.record(tape);
        tape.scalar(&mut self.h);
        tape.steps(&mut self.steps);
        tape.option(&mut self.reported_time, zero);
    }
}

impl<R: Real> Clock<R> {
    /// Returns a clock for steps of length `h` from the time `t`.
    pub fn new(t: R, h: R) -> Self {
        Clock { start: DoubleWord::new(t), h, steps: 0, reported_time: None }
    }

    /// Returns the start time of the `i`-th step from now.
    #[inline(always)]
    pub fn at(&self, i: u64) -> R {
        R::time(self.start.words(), self.steps + i, self.h)
    }

    /// Returns start and end time of the `i`-th step from now, for steps that are `ahead` of t₀ + n·h.
    #[inline(always)]
    pub(crate) fn ends(&self, i: u64, ahead: R) -> [R; 2] {
        [self.at(i) + ahead, self.at(i + 1) + ahead]
    }

    /// Returns the end time of a step of length `h`, which may differ from the step size of the clock.
    pub(crate) fn after(mut self, h: R) -> R {
        self.pass_length(h);
        self.now(zero())
    }

    /// The step size.
    pub fn step_size(&self) -> R {
        self.h
    }

    /// Returns the present time, for steps that are `ahead` of t₀ + n·h.
    #[inline(always)]
    pub(crate) fn now(&self, ahead: R) -> R {
        match self.reported_time {
            Some(t) => t,
            // Before the first step the time does not depend on h, which may be invalid.
            None if self.steps == 0 => self.start.value() + ahead,
            None => self.at(0) + ahead,
        }
    }

    /// Advances by `steps` steps.
    #[inline(always)]
    pub(crate) fn pass(&mut self, steps: u64) {
        self.steps += steps;
        self.reported_time = None;
    }

    /// Advances t₀ by one step of length `h` + `ahead`, which may differ from the step size of the clock.
    pub(crate) fn pass_step(&mut self, h: R, ahead: DoubleWord<R>) {
        self.pass_length(h);
        self.start.add_both(ahead);
    }

    /// Advances t₀ by one step of length `h`, which may differ from the step size of the clock.
    #[inline(always)]
    pub(crate) fn pass_length(&mut self, h: R) {
        self.start.add(h);
        self.reported_time = None;
    }

    /// Sets the step size, and sets t₀ to the present time.
    pub(crate) fn set_step_size(&mut self, h: R, ahead: DoubleWord<R>) {
        self.start.add_multiple(self.steps, self.h);
        self.start.add_both(ahead);
        (self.h, self.steps) = (h, 0);
    }

    /// Reports the present time as `t` until the next step. Later times do not change.
    pub(crate) fn name(&mut self, t: R) {
        self.reported_time = Some(t);
    }

    /// Returns t − t₀ with both words of t₀. Precondition: t₀ is the present (n = 0).
    pub(crate) fn left(&self, t: R) -> f64 {
        let [high, low] = self.start.words();
        signed(t - high - low)
    }

    /// Returns whether a step from `now` to `end` does not pass `t`. A step that passes `t` by rounding only is accepted, unless `now` is already at `t`.
    #[inline(always)]
    pub(crate) fn leads_to(&self, t: R, [now, end]: [R; 2]) -> bool {
        let beyond =
            (end - t).any_above(0.0) && self.h.any_above(0.0) || (end - t).any_below(0.0) && self.h.any_below(0.0);
        !beyond || self.is_at(end, t) && !self.is_at(now, t)
    }

    /// Returns whether two times differ by no more than the rounding errors of t₀, n·h and t, and by half a step at most.
    #[inline(always)]
    pub(crate) fn is_at(&self, now: R, t: R) -> bool {
        let gap = (now - t).magnitude();
        gap <= 0.5 * self.h.magnitude() && gap <= self.rounding(t)
    }

    /// Returns a bound of the rounding errors of t₀, n·h and `t`.
    #[inline(always)]
    fn rounding(&self, t: R) -> f64 {
        R::epsilon() * (self.start.value().magnitude() + self.steps as f64 * self.h.magnitude() + t.magnitude())
    }

    /// Returns a number of steps of length h such that the last one ends before `t` in spite of rounding.
    pub(crate) fn steps_before(&self, now: R, t: R) -> u64 {
        let error = 4.0 * (self.rounding(t) + R::epsilon() * t.magnitude());
        let left = signed(t - now) / signed(self.h);
        (left - error / self.h.magnitude()) as u64
    }
}

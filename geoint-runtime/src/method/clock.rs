//! Time: the one place that knows when steps start and end.

use crate::scalar::{Real, signed, zero};
use crate::space::{DoubleWord, Record, Tape};

/// When steps start: t₀ + n·h, never a running sum. Where the length of steps changes, t₀ moves on in two words.
#[derive(Clone, Copy, Debug)]
pub struct Clock<R> {
    /// When steps began to have the length h.
    start: DoubleWord<R>,
    h: R,
    /// Steps since then.
    steps: u64,
    /// What the present is called, if somebody asked for a time that is the same but for rounding.
    named: Option<R>,
}

impl<R: Real> Record<R> for Clock<R> {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        self.start.record(tape);
        tape.scalar(&mut self.h);
        tape.steps(&mut self.steps);
        tape.option(&mut self.named, zero);
    }
}

impl<R: Real> Clock<R> {
    /// A clock of steps of length `h` from `t` on.
    pub fn new(t: R, h: R) -> Self {
        Clock { start: DoubleWord::new(t), h, steps: 0, named: None }
    }

    /// The time at which the `i`-th step from now starts.
    #[inline(always)]
    pub fn at(&self, i: u64) -> R {
        R::time(self.start.words(), self.steps + i, self.h)
    }

    /// When the `i`-th step from now starts and ends, for steps that are `ahead` of t₀ + n·h.
    #[inline(always)]
    pub(crate) fn ends(&self, i: u64, ahead: R) -> [R; 2] {
        [self.at(i) + ahead, self.at(i + 1) + ahead]
    }

    /// When a step of length `h` ends, whatever the length of the others.
    pub(crate) fn after(mut self, h: R) -> R {
        self.pass_length(h);
        self.now(zero())
    }

    /// The length of steps.
    pub fn step_size(&self) -> R {
        self.h
    }

    /// The present, for steps that are `ahead` of t₀ + n·h.
    #[inline(always)]
    pub(crate) fn now(&self, ahead: R) -> R {
        match self.named {
            Some(t) => t,
            // Without steps even an unusable h leaves time alone.
            None if self.steps == 0 => self.start.value() + ahead,
            None => self.at(0) + ahead,
        }
    }

    /// So many steps have been taken.
    #[inline(always)]
    pub(crate) fn pass(&mut self, steps: u64) {
        self.steps += steps;
        self.named = None;
    }

    /// One step has been taken that was `ahead` longer than `h`, whatever the length of the others.
    pub(crate) fn pass_step(&mut self, h: R, ahead: DoubleWord<R>) {
        self.pass_length(h);
        self.start.add_both(ahead);
    }

    /// One step of length `h` has been taken.
    #[inline(always)]
    pub(crate) fn pass_length(&mut self, h: R) {
        self.start.add(h);
        self.named = None;
    }

    /// Steps have another length from now on.
    pub(crate) fn set_step_size(&mut self, h: R, ahead: DoubleWord<R>) {
        self.start.add_multiple(self.steps, self.h);
        self.start.add_both(ahead);
        (self.h, self.steps) = (h, 0);
    }

    /// Calls the present `t` until the next step. No later time changes.
    pub(crate) fn name(&mut self, t: R) {
        self.named = Some(t);
    }

    /// From the present to `t`, as a plain number with both words of the present.
    pub(crate) fn left(&self, t: R) -> f64 {
        let [high, low] = self.start.words();
        signed(t - high - low)
    }

    /// Whether a step from `now` to `end` is on the way to `t`: it does not end beyond, except by rounding where `now` is not there.
    #[inline(always)]
    pub(crate) fn leads_to(&self, t: R, [now, end]: [R; 2]) -> bool {
        let beyond =
            (end - t).any_above(0.0) && self.h.any_above(0.0) || (end - t).any_below(0.0) && self.h.any_below(0.0);
        !beyond || self.is_at(end, t) && !self.is_at(now, t)
    }

    /// Whether two times are the same but for what t₀, n·h and they themselves are rounded by.
    #[inline(always)]
    pub(crate) fn is_at(&self, now: R, t: R) -> bool {
        let gap = (now - t).magnitude();
        gap <= 0.5 * self.h.magnitude() && gap <= self.rounding(t)
    }

    #[inline(always)]
    fn rounding(&self, t: R) -> f64 {
        R::epsilon() * (self.start.value().magnitude() + self.steps as f64 * self.h.magnitude() + t.magnitude())
    }

    /// A number of steps of length h of which the last one surely ends before `t`.
    pub(crate) fn steps_before(&self, now: R, t: R) -> u64 {
        let error = 4.0 * (self.rounding(t) + R::epsilon() * t.magnitude());
        let left = signed(t - now) / signed(self.h);
        (left - error / self.h.magnitude()) as u64
    }
}

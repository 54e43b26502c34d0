//! The point before the last flow of a step. The last flow of a step and the first flow of the next one are merged.
//!
//! A state is the point after the last flow. The next step continues from the point before it. A run therefore has the same digits in single steps and in
//! one call, and reading a state does not change the run.

use crate::scalar::zero;
use crate::space::{Action, Array, PerCoordinate, Point, Record, Summation, Tape};

/// The point from which the next step continues, if it starts at the state and time at which the step before ended.
#[derive(Clone, Copy, Debug)]
pub struct Open<Z: Array, S> {
    /// False before the first step.
    known: bool,
    /// The point before the last flow.
    pub(in crate::method) from: PerCoordinate<Z, S>,
    /// The compensation of sums at `from`.
    pub(in crate::method) compensation: PerCoordinate<Z, S>,
    /// The state at the end of the step.
    end: PerCoordinate<Z, S>,
    /// Start and end time of the step.
    times: [Z::Real; 2],
}

impl<Z: Array, S: Action<Z::Real>> Open<Z, S> {
    /// Returns the value before the first step.
    pub(in crate::method) fn unknown() -> Self {
        let zeros = PerCoordinate::zero();
        Open { known: false, from: zeros, compensation: zeros, end: zeros, times: [zero(); 2] }
    }

    /// Stores `x` as the point from which the next step continues.
    #[inline(always)]
    pub(in crate::method) fn leave<C: Summation<Z>>(&mut self, x: &Point<Z, C, S>) {
        self.from = PerCoordinate::of(x);
        x.lost_to(&mut self.compensation);
    }

    /// Stores the state at the end of the step, and its start and end time.
    #[inline(always)]
    pub(in crate::method) fn end<C: Summation<Z>>(&mut self, times: [Z::Real; 2], x: &Point<Z, C, S>) {
        (self.known, self.times, self.end) = (true, times, PerCoordinate::of(x));
    }

    /// Returns the start time of the step before, if that step ended at the state `x` and the time `t`. The sums of `x` then get the stored compensation.
    #[inline(always)]
    pub(in crate::method) fn reopen<C: Summation<Z>>(&self, t: Z::Real, x: &mut Point<Z, C, S>) -> Option<Z::Real> {
        let [start, end] = self.times;
        if !(self.known && end == t) {
            return None;
        }
        let here = self.end.z.is_same(&x.z) & (self.end.s.numbers() == x.s.numbers());
        if here && !C::PLAIN {
            (x.sums, x.compensation) = (C::new(), self.compensation.s);
            x.sums.compensate(&self.compensation.z);
        }
        here.then_some(start)
    }

    /// Moves `x` to the stored point if [`reopen`](Self::reopen) returns a time. Returns this time.
    #[inline(always)]
    pub(in crate::method) fn return_to<C: Summation<Z>>(&self, t: Z::Real, x: &mut Point<Z, C, S>) -> Option<Z::Real> {
        let start = self.reopen(t, x);
        if start.is_some() {
            (x.z, x.s) = (self.from.z, self.from.s);
        }
        start
    }
}

impl<Z: Array, S: Action<Z::Real>> Record<Z::Real> for Open<Z, S> {
    fn record(&mut self, tape: &mut impl Tape<Z::Real>) {
        tape.flag(&mut self.known);
        self.from.record(tape);
        self.compensation.record(tape);
        self.end.record(tape);
        self.times.iter_mut().for_each(|t| tape.scalar(t));
    }
}

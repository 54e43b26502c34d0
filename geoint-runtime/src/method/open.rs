//! What a step leaves open: its last flow and the first one of the next step are one flow while steps go on.
//!
//! A state is the point behind the last flow. The next step begins before it again, so that a run has the same digits in single steps and in one
//! call, and being looked at does not change it.

use crate::scalar::zero;
use crate::space::{Action, Array, PerCoordinate, Point, Record, Summation, Tape};

/// The point from which a step goes on, if it begins where and when the one before ended.
#[derive(Clone, Copy, Debug)]
pub struct Open<Z: Array, S> {
    known: bool,
    pub(in crate::method) from: PerCoordinate<Z, S>,
    /// What sums had lost there.
    pub(in crate::method) lost: PerCoordinate<Z, S>,
    end: PerCoordinate<Z, S>,
    /// When that step began and ended.
    times: [Z::Real; 2],
}

impl<Z: Array, S: Action<Z::Real>> Open<Z, S> {
    /// There was no step yet.
    pub(in crate::method) fn unknown() -> Self {
        let zeros = PerCoordinate::zero();
        Open { known: false, from: zeros, lost: zeros, end: zeros, times: [zero(); 2] }
    }

    /// From this point the next step goes on.
    #[inline(always)]
    pub(in crate::method) fn leave<C: Summation<Z>>(&mut self, x: &Point<Z, C, S>) {
        self.from = PerCoordinate::of(x);
        x.lost_to(&mut self.lost);
    }

    /// Where and when the step ends that left it, and when it began.
    #[inline(always)]
    pub(in crate::method) fn end<C: Summation<Z>>(&mut self, times: [Z::Real; 2], x: &Point<Z, C, S>) {
        (self.known, self.times, self.end) = (true, times, PerCoordinate::of(x));
    }

    /// Whether `x` is the end, at time `t`, of the step that left a point to go on from: when that began. Sums then go on with what was lost there.
    #[inline(always)]
    pub(in crate::method) fn reopen<C: Summation<Z>>(&self, t: Z::Real, x: &mut Point<Z, C, S>) -> Option<Z::Real> {
        let [start, end] = self.times;
        if !(self.known && end == t) {
            return None;
        }
        let here = self.end.z.is_same(&x.z) & (self.end.s.numbers() == x.s.numbers());
        if here && !C::PLAIN {
            (x.sums, x.compensation) = (C::new(), self.lost.s);
            x.sums.compensate(&self.lost.z);
        }
        here.then_some(start)
    }

    /// The same, and `x` moves there.
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
        self.lost.record(tape);
        self.end.record(tape);
        self.times.iter_mut().for_each(|t| tape.scalar(t));
    }
}

//! A point of phase space while it moves: q, p, and how increments are added to them.

use super::array::Array;
use super::double_word::DoubleWord;
use super::per_coordinate::PerCoordinate;
use super::state::Action;
use super::summation::{Summation, add_compensated};
use crate::scalar::{Real, zero};

/// A point with sums of kind `C`, and an action if its space has one.
#[derive(Clone, Copy, Debug)]
pub struct Point<A: Array, C, Z = ()> {
    /// Positions.
    pub q: A,
    /// Momenta.
    pub p: A,
    /// The action of a contact system.
    pub s: Z,
    pub(crate) sums: [C; 2],
    /// What s is too small by, where sums compensate.
    pub(crate) compensation: Z,
    /// How far time is ahead of t₀ + n·h: methods that scale their steps say so here.
    pub ahead: DoubleWord<A::Real>,
}

impl<A: Array, C: Summation<A>, Z: Action<A::Real>> Point<A, C, Z> {
    /// A point without rounding errors so far.
    pub fn with_action(q: A, p: A, s: Z) -> Self {
        Point { q, p, s, sums: [C::new(), C::new()], compensation: Z::zero(), ahead: DoubleWord::new(zero()) }
    }

    /// The same point with sums of another kind, without rounding errors so far.
    pub(crate) fn with_sums<D: Summation<A>>(self) -> Point<A, D, Z> {
        Point { ahead: self.ahead, ..Point::with_action(self.q, self.p, self.s) }
    }

    /// Whether every coordinate is a finite number.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        self.q.is_finite() && self.p.is_finite() && self.s.is_finite()
    }

    /// q ← q + dq, p ← p + dp.
    #[inline(always)]
    pub fn add(&mut self, dq: &A, dp: &A) {
        self.sums[0].add(&mut self.q, |q| q.add_scaled(A::Real::from_f64(1.0), dq));
        self.sums[1].add(&mut self.p, |p| p.add_scaled(A::Real::from_f64(1.0), dp));
    }

    /// x ← x + d for every coordinate.
    #[inline(always)]
    pub(crate) fn add_everywhere(&mut self, d: &PerCoordinate<A, Z>) {
        add_everywhere(([&mut self.q, &mut self.p], &mut self.s), (&mut self.sums, &mut self.compensation), d);
    }

    /// Adds a correction to a step that led from `before` by `moved` to here: both together, with sums of the method's own unless those
    /// of the point compensate.
    #[inline(always)]
    pub(crate) fn correct<D: Summation<A>>(
        &mut self,
        sums: &mut [D; 2],
        before: &[A; 2],
        moved: &[A; 2],
        correction: &[A; 2],
    ) {
        if !C::PLAIN {
            return self.add(&correction[0], &correction[1]);
        }
        [self.q, self.p] = *before;
        let mut whole = *moved;
        whole.add_scaled(A::Real::from_f64(1.0), correction);
        self.add_with(sums, whole.each_ref(), [&A::zero(); 2]);
    }

    /// The same, with sums of the method's own unless those of the point compensate: those outlive a change of the step size.
    /// `lost` are the rounding errors of dq and dp.
    #[inline(always)]
    pub fn add_with<D: Summation<A>>(&mut self, sums: &mut [D; 2], [dq, dp]: [&A; 2], lost: [&A; 2]) {
        if !C::PLAIN {
            self.add(dq, dp);
            self.sums[0].compensate(lost[0]);
            return self.sums[1].compensate(lost[1]);
        }
        sums[0].add(&mut self.q, |q| q.add_scaled(A::Real::from_f64(1.0), dq));
        sums[1].add(&mut self.p, |p| p.add_scaled(A::Real::from_f64(1.0), dp));
        sums[0].compensate(lost[0]);
        sums[1].compensate(lost[1]);
    }
}

impl<A: Array, C: Summation<A>> Point<A, C> {
    /// A point without rounding errors so far.
    pub fn new(q: A, p: A) -> Self {
        Self::with_action(q, p, ())
    }
}

/// x ← x + d for every coordinate of a point in parts, with its sums.
#[inline(always)]
pub(crate) fn add_everywhere<A: Array, C: Summation<A>, Z: Action<A::Real>>(
    ([q, p], s): ([&mut A; 2], &mut Z),
    (sums, compensation): (&mut [C; 2], &mut Z),
    d: &PerCoordinate<A, Z>,
) {
    for ((x, sum), d) in [q, p].into_iter().zip(sums).zip([&d.q, &d.p]) {
        sum.add(x, |x| x.add_scaled(A::Real::from_f64(1.0), d));
    }
    let entries = s.numbers_mut().iter_mut().zip(compensation.numbers_mut()).zip(d.s.numbers());
    for ((s, compensation), d) in entries {
        if C::PLAIN {
            *s += *d;
        } else {
            add_compensated(s, compensation, *d);
        }
    }
}

//! A point of phase space while it moves: q, p, and how increments are added to them.

use super::array::Array;
use super::double_word::DoubleWord;
use super::state::Action;
use super::summation::Summation;
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
    /// How far time is ahead of t₀ + n·h: methods that scale their steps say so here.
    pub ahead: DoubleWord<A::Real>,
}

impl<A: Array, C: Summation<A>, Z: Action<A::Real>> Point<A, C, Z> {
    /// A point without rounding errors so far.
    pub fn with_action(q: A, p: A, s: Z) -> Self {
        Point { q, p, s, sums: [C::new(), C::new()], ahead: DoubleWord::new(zero()) }
    }

    /// The same point with sums of another kind, without rounding errors so far.
    pub(crate) fn with_sums<D: Summation<A>>(self) -> Point<A, D, Z> {
        Point { q: self.q, p: self.p, s: self.s, sums: [D::new(), D::new()], ahead: self.ahead }
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

//! A point of phase space while it moves: q, p, and how increments are added to them.

use crate::array::Array;
use crate::real::{Real, zero};
use crate::state::Action;
use core::fmt::Debug;

/// How an increment is added to a coordinate.
pub trait Summation<A: Array>: Copy + Debug {
    /// Whether nothing is carried: a flow may then act on its own.
    const PLAIN: bool;
    /// Whether the action of a contact system is followed.
    const ACTION: bool = true;
    /// Nothing has been rounded off yet.
    fn new() -> Self;
    /// Lets `flow`, which adds something to its argument whatever that is, act on `x`.
    fn add(&mut self, x: &mut A, flow: impl FnOnce(&mut A));
    /// Digits that the last increment has lost, for the next addition.
    fn owe(&mut self, lost: &A);
    /// What the sum is too small by.
    fn carry(&self) -> A;
}

/// Every addition is rounded. The action of a contact system is followed, or not.
#[derive(Clone, Copy, Debug)]
pub struct Plain<const ACTION: bool = true>;

/// Every addition is rounded, and the action of a contact system is not followed.
pub type WithoutAction = Plain<false>;

impl<A: Array, const ACTION: bool> Summation<A> for Plain<ACTION> {
    const PLAIN: bool = true;
    const ACTION: bool = ACTION;
    fn new() -> Self {
        Plain
    }
    #[inline(always)]
    fn add(&mut self, x: &mut A, flow: impl FnOnce(&mut A)) {
        flow(x);
    }
    #[inline(always)]
    fn owe(&mut self, _: &A) {}
    #[inline(always)]
    fn carry(&self) -> A {
        A::zero()
    }
}

/// What an addition rounds off is carried to the next one: sums of many small increments grow errors of a single rounding.
/// O. Møller, BIT 5 (1965) 37; the exact error of a sum: D. E. Knuth, *Seminumerical Algorithms*, 4.2.2.
#[derive(Clone, Copy, Debug)]
pub struct Compensated<A> {
    carry: A,
}

impl<A: Array> Summation<A> for Compensated<A> {
    const PLAIN: bool = false;
    fn new() -> Self {
        Compensated { carry: A::zero() }
    }
    #[inline(always)]
    fn add(&mut self, x: &mut A, flow: impl FnOnce(&mut A)) {
        // Acting on zero, the flow gives the increment.
        let mut increment = A::nothing();
        flow(&mut increment);
        let carry = self.carry.as_mut_slice();
        for (i, x) in x.as_mut_slice().iter_mut().enumerate() {
            // Both roundings are kept: an increment has more digits than fit beside the carry. Should it be the smaller one, the
            // error of the first is lost, which is a rounding of the carry.
            let (change, first) = sum_with_small(increment.as_slice()[i], carry[i]);
            let (sum, second) = exact_sum(*x, change);
            carry[i] = first + second;
            *x = sum;
        }
    }
    #[inline(always)]
    fn owe(&mut self, lost: &A) {
        self.carry.add_scaled(A::Real::from_f64(1.0), lost);
    }
    #[inline(always)]
    fn carry(&self) -> A {
        self.carry
    }
}

/// a + b and its rounding error, if |b| ≤ |a|. T. J. Dekker, Numer. Math. 18 (1971) 224.
#[inline(always)]
fn sum_with_small<R: Real>(a: R, b: R) -> (R, R) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// a + b and its rounding error.
#[inline(always)]
pub(crate) fn exact_sum<R: Real>(a: R, b: R) -> (R, R) {
    let sum = a + b;
    let added = sum - a;
    (sum, (a - (sum - added)) + (b - added))
}

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
    pub ahead: A::Real,
}

impl<A: Array, C: Summation<A>, Z: Action<A::Real>> Point<A, C, Z> {
    /// A point at which nothing has been rounded off yet.
    pub fn with_action(q: A, p: A, s: Z) -> Self {
        Point { q, p, s, sums: [C::new(), C::new()], ahead: zero() }
    }

    /// The same point with sums of another kind, of which nothing has been rounded off yet.
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

    /// The same with sums of the method's own, unless those of the point carry: they outlive a change of the step size. And with digits that dq and dp have lost.
    #[inline(always)]
    pub fn add_with<D: Summation<A>>(&mut self, sums: &mut [D; 2], [dq, dp]: [&A; 2], lost: [&A; 2]) {
        if !C::PLAIN {
            self.add(dq, dp);
            self.sums[0].owe(lost[0]);
            return self.sums[1].owe(lost[1]);
        }
        sums[0].add(&mut self.q, |q| q.add_scaled(A::Real::from_f64(1.0), dq));
        sums[1].add(&mut self.p, |p| p.add_scaled(A::Real::from_f64(1.0), dp));
        sums[0].owe(lost[0]);
        sums[1].owe(lost[1]);
    }
}

impl<A: Array, C: Summation<A>> Point<A, C> {
    /// A point at which nothing has been rounded off yet.
    pub fn new(q: A, p: A) -> Self {
        Self::with_action(q, p, ())
    }
}

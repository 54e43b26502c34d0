//! How increments are added to coordinates: every addition rounded, or with compensation.

use super::array::Array;
use crate::scalar::Real;
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

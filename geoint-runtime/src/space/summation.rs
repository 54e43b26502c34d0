//! Sums of increments, with or without compensation of rounding errors.

use super::array::Array;
use super::record::{Record, Tape};
use crate::scalar::{Real, exact_sum, sum_with_small};
use crate::sealed::Sealed;
use core::fmt::Debug;

/// A method of adding increments to coordinates.
///
/// Sealed, because methods omit work that one of these types does not need.
pub trait Summation<A: Array>: Sealed + Copy + Debug + Record<A::Real> {
    /// `true` without compensation. A flow may then act on the coordinates directly.
    const PLAIN: bool;
    /// Whether the action of a contact system is computed.
    const ACTION: bool = true;
    /// Returns a sum with a compensation of zero.
    fn new() -> Self;
    /// Applies `flow` to a part `x` of the coordinates, which starts at the index `first`.
    ///
    /// Precondition: the increment by `flow` does not depend on its argument, and is rounded to one number. Kicks and drifts are examples.
    fn add_part<B: Array<Real = A::Real>>(&mut self, first: usize, x: &mut B, flow: impl FnOnce(&mut B));
    /// Applies `flow` to all coordinates, and keeps all digits. Used for increments whose own rounding error is [known](Self::compensate).
    fn add(&mut self, x: &mut A, flow: impl FnOnce(&mut A));
    /// Adds the rounding error of an increment to the compensation.
    fn compensate(&mut self, error: &A);
    /// Returns the compensation: exact sum minus rounded sum.
    fn compensation(&self) -> A;
}

/// Sums without compensation. `ACTION` states whether the action of a contact system is computed.
#[derive(Clone, Copy, Debug)]
pub struct Plain<const ACTION: bool = true>;

/// Sums without compensation, and without the action of a contact system.
pub type WithoutAction = Plain<false>;

impl<const ACTION: bool> Sealed for Plain<ACTION> {}

impl<A: Array, const ACTION: bool> Summation<A> for Plain<ACTION> {
    const PLAIN: bool = true;
    const ACTION: bool = ACTION;
    fn new() -> Self {
        Plain
    }
    #[inline(always)]
    fn add_part<B: Array<Real = A::Real>>(&mut self, _: usize, x: &mut B, flow: impl FnOnce(&mut B)) {
        flow(x);
    }
    #[inline(always)]
    fn add(&mut self, x: &mut A, flow: impl FnOnce(&mut A)) {
        flow(x);
    }
    #[inline(always)]
    fn compensate(&mut self, _: &A) {}
    #[inline(always)]
    fn compensation(&self) -> A {
        A::zero()
    }
}

/// Compensated sums. The rounding error of an addition is added to the next increment, so a sum of many small increments has the error of one rounding.
///
/// O. Møller, BIT 5 (1965) 37. The exact error of a sum: D. E. Knuth, *Seminumerical Algorithms*, 4.2.2.
#[doc(alias("Kahan summation", "compensated summation"))]
#[derive(Clone, Copy, Debug)]
pub struct Compensated<A> {
    compensation: A,
}

impl<A> Sealed for Compensated<A> {}

impl<A> Compensated<A> {
    pub(super) fn compensation_mut(&mut self) -> &mut A {
        &mut self.compensation
    }
}

impl<A: Array> Summation<A> for Compensated<A> {
    const PLAIN: bool = false;
    fn new() -> Self {
        Compensated { compensation: A::zero() }
    }
    #[inline(always)]
    fn add_part<B: Array<Real = A::Real>>(&mut self, first: usize, x: &mut B, flow: impl FnOnce(&mut B)) {
        // The flow, applied to zero, gives the increment.
        let mut increment = B::nothing();
        flow(&mut increment);
        let compensation = &mut self.compensation.as_mut_slice()[first..first + B::LEN];
        for (i, x) in x.as_mut_slice().iter_mut().enumerate() {
            add_rounded(x, &mut compensation[i], increment.as_slice()[i]);
        }
    }
    #[inline(always)]
    fn add(&mut self, x: &mut A, flow: impl FnOnce(&mut A)) {
        let mut increment = A::nothing();
        flow(&mut increment);
        let compensation = self.compensation.as_mut_slice();
        for (i, x) in x.as_mut_slice().iter_mut().enumerate() {
            add_compensated(x, &mut compensation[i], increment.as_slice()[i]);
        }
    }
    #[inline(always)]
    fn compensate(&mut self, error: &A) {
        self.compensation.add_scaled(A::Real::from_f64(1.0), error);
    }
    #[inline(always)]
    fn compensation(&self) -> A {
        self.compensation
    }
}

/// Adds a rounded increment to a compensated sum, in four operations.
///
/// The operation is exact if the sum is larger than the increment. Otherwise, near a zero of the sum, the error is a rounding of the increment.
/// W. Kahan, Commun. ACM 8 (1965) 40.
#[inline(always)]
fn add_rounded<R: Real>(sum: &mut R, compensation: &mut R, increment: R) {
    let change = increment + *compensation;
    let whole = *sum + change;
    *compensation = change - (whole - *sum);
    *sum = whole;
}

/// Adds an increment to a compensated sum, and keeps all digits of the increment.
#[inline(always)]
pub(crate) fn add_compensated<R: Real>(sum: &mut R, compensation: &mut R, increment: R) {
    // Both rounding errors are kept. If the increment is smaller than the compensation, the error of the first sum is lost. It is a
    // rounding of the compensation.
    let (change, first) = sum_with_small(increment, *compensation);
    let (whole, second) = exact_sum(*sum, change);
    *compensation = first + second;
    *sum = whole;
}

impl<R, const ACTION: bool> Record<R> for Plain<ACTION> {
    fn record(&mut self, _: &mut impl Tape<R>) {}
}

impl<A: Array> Record<A::Real> for Compensated<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        tape.array(self.compensation_mut());
    }
}

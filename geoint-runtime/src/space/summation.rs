//! How increments are added to coordinates: every addition rounded, or with compensation.

use super::array::Array;
use super::record::{Record, Tape};
use crate::scalar::{Real, exact_sum, sum_with_small};
use crate::sealed::Sealed;
use core::fmt::Debug;

/// How increments are added to a coordinate.
///
/// Sealed: what methods may leave out depends on which it is.
pub trait Summation<A: Array>: Sealed + Copy + Debug + Record<A::Real> {
    /// Whether there is no compensation: a flow may then act on the coordinate itself.
    const PLAIN: bool;
    /// Whether the action of a contact system is followed.
    const ACTION: bool = true;
    /// A sum without a rounding error so far.
    fn new() -> Self;
    /// Lets `flow` act on a part `x` of the coordinates, whose first one is the `first` of all. The increment that `flow` adds does not
    /// depend on its argument, and has no more digits than fit into a number: kicks and drifts.
    fn add_part<B: Array<Real = A::Real>>(&mut self, first: usize, x: &mut B, flow: impl FnOnce(&mut B));
    /// The same for all coordinates, of an increment whose own rounding error is [known](Self::compensate): all digits are kept.
    fn add(&mut self, x: &mut A, flow: impl FnOnce(&mut A));
    /// Adds the rounding error of an increment to the compensation.
    fn compensate(&mut self, error: &A);
    /// The compensation: what the sum is too small by.
    fn compensation(&self) -> A;
}

/// Every addition is rounded. The action of a contact system is followed, or not.
#[derive(Clone, Copy, Debug)]
pub struct Plain<const ACTION: bool = true>;

/// Every addition is rounded, and the action of a contact system is not followed.
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

/// The rounding error of an addition is added to the next increment: a sum of many small increments has the error of a single rounding.
/// O. Møller, BIT 5 (1965) 37; the exact error of a sum: D. E. Knuth, *Seminumerical Algorithms*, 4.2.2.
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
        // Acting on zero, the flow gives the increment.
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

/// Adds a number that is rounded itself to a sum that is too small by `compensation`, in four operations: exact where the sum is the larger one,
/// and where it is not, as it passes zero, the error is a rounding of the number. W. Kahan, Commun. ACM 8 (1965) 40.
#[inline(always)]
fn add_rounded<R: Real>(sum: &mut R, compensation: &mut R, increment: R) {
    let change = increment + *compensation;
    let whole = *sum + change;
    *compensation = change - (whole - *sum);
    *sum = whole;
}

/// Adds a number to a sum that is too small by `compensation`, and keeps all digits of it.
#[inline(always)]
pub(crate) fn add_compensated<R: Real>(sum: &mut R, compensation: &mut R, increment: R) {
    // Both rounding errors are kept: an increment has more digits than fit beside the compensation. Should it be the smaller
    // one, the error of the first sum is lost, which is a rounding of the compensation.
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

//! Keeps the inverse of a matrix that is the same in all steps, or in all equations of one step. A product with a vector then replaces an elimination.
//!
//! The inverse of n rows takes n eliminations, O(n⁴) operations. [`DiscreteGradient`](crate::DiscreteGradient) pays them once for each h, and
//! `method/gauss/canonical.rs` once in each step. Limit: the product loses more digits than an elimination if the matrix is nearly singular.

use super::linear;
use super::size::Sizes;
use crate::scalar::Real;
use crate::space::vector::product;
use crate::space::{Array, Square};
use core::fmt::Debug;

/// The inverse of the matrix of implicit steps. The type is [`Inverted`] if the matrix is the same in all steps. It is `()` if the matrix changes. Methods
/// that always have an inverse use [`Inverted`] directly.
pub trait Inverse<A: Array>: Clone + Debug {
    /// `true` if the type holds an inverse.
    const EXISTS: bool;
    /// Returns the inverse of `matrix`. `()` does not call `matrix`.
    ///
    /// The entries are NaN if the matrix is singular or its determinant is negative, and every step is then refused. The matrix is 1 for h = 0. A negative
    /// determinant shows that it is singular for a smaller h, so the solution is not continuous in h.
    fn new(matrix: impl FnOnce() -> Square<A>) -> Self;
    /// Returns the product of the inverse and a vector. `()` has no inverse, and returns `x`: callers check [`EXISTS`](Self::EXISTS) first.
    fn times(&self, x: &A) -> A;
}

/// The matrix changes from step to step, so no inverse is kept.
impl<A: Array> Inverse<A> for () {
    const EXISTS: bool = false;

    fn new(_: impl FnOnce() -> Square<A>) -> Self {}

    fn times(&self, x: &A) -> A {
        *x
    }
}

/// The inverse of a matrix, with one row for each unknown.
#[derive(Clone, Copy, Debug)]
pub struct Inverted<A: Array>(Square<A>);

impl<A: Array> Inverted<A> {
    /// Returns the inverse, and whether the determinant of `matrix` is positive. Returns `None` if `matrix` is singular or not finite. `sizes` are the sizes
    /// of the unknowns, by which elimination chooses pivots. Precondition: row i has the unit of unknown i.
    pub(crate) fn of(matrix: &Square<A>, sizes: &Sizes<A>) -> Option<(Self, bool)> {
        let (mut inverse, mut positive) = (A::fill(A::zero()), true);
        for j in 0..A::LEN {
            let (mut lu, mut column) = (*matrix, A::zero());
            column.as_mut_slice()[j] = A::Real::from_f64(1.0);
            positive = linear::solve(&mut lu, &mut column, sizes)?;
            for (row, x) in A::entries::<A>(&mut inverse).iter_mut().zip(column.as_slice()) {
                row.as_mut_slice()[j] = *x;
            }
        }
        Some((Inverted(inverse), positive))
    }

    /// Returns M⁻¹ = (D M)⁻¹ D, where `self` is (D M)⁻¹ and the diagonal matrix D has the entries `scales`.
    pub(crate) fn of_rows_scaled(mut self, scales: &A) -> Self {
        for row in A::entries::<A>(&mut self.0) {
            *row = product(row, scales);
        }
        self
    }
}

impl<A: Array> Inverse<A> for Inverted<A> {
    const EXISTS: bool = true;

    fn new(matrix: impl FnOnce() -> Square<A>) -> Self {
        let matrix = matrix();
        // No state is known here, so the ratio of sizes follows from the matrix.
        match Inverted::of(&matrix, &Sizes::of_blocks(&matrix)) {
            Some((inverse, true)) => inverse,
            _ => {
                let mut row = A::zero();
                row.as_mut_slice().fill(A::Real::from_f64(f64::NAN));
                Inverted(A::fill(row))
            }
        }
    }

    #[inline(always)]
    fn times(&self, x: &A) -> A {
        let mut sum = A::zero();
        for (i, row) in A::entries_of::<A>(&self.0).iter().enumerate() {
            for (w, x) in row.as_slice().iter().zip(x.as_slice()) {
                sum.as_mut_slice()[i] = w.multiply_add(*x, sum.as_slice()[i]);
            }
        }
        sum
    }
}

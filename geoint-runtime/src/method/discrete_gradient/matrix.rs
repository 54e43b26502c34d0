//! Square matrices in all coordinates (q, p), and the product J(q, p) = (p, −q).

use crate::scalar::Real;
use crate::space::vector::{dot, entries, opposite};
use crate::space::{Array, Square};

/// A square matrix in all coordinates, with one row for each entry of (q, p). Products take `&mut`, because [`rows`](Self::rows) does, but change nothing.
#[derive(Clone, Copy, Debug)]
pub struct Matrix<A: Array>(Square<[A; 2]>);

impl<A: Array> Matrix<A> {
    /// Returns a matrix of zeros.
    #[inline(always)]
    pub fn zero() -> Self {
        Matrix(<[A; 2]>::fill(<[A; 2]>::zero()))
    }

    /// Returns the rows, for writing.
    #[inline(always)]
    pub fn rows(&mut self) -> &mut [[A; 2]] {
        <[A; 2]>::entries::<[A; 2]>(&mut self.0)
    }

    /// Returns the rows, for reading.
    #[inline(always)]
    pub(super) fn rows_of(&self) -> &[[A; 2]] {
        <[A; 2]>::entries_of::<[A; 2]>(&self.0)
    }

    /// Returns the product of the matrix and a vector.
    #[inline(always)]
    pub(super) fn times(&mut self, x: &[A; 2]) -> [A; 2] {
        let mut y = <[A; 2]>::zero();
        for (y, row) in entries(&mut y).iter_mut().zip(self.rows()) {
            *y = dot(&*row, x);
        }
        y
    }

    /// Returns the product of the transpose with a vector.
    #[inline(always)]
    pub(super) fn transpose_times(&mut self, x: &[A; 2]) -> [A; 2] {
        let mut y = <[A; 2]>::zero();
        for (x, row) in Array::as_slice(x).iter().zip(self.rows()) {
            y.add_scaled(*x, row);
        }
        y
    }

    /// Adds w·other to this matrix.
    #[inline(always)]
    pub(super) fn add_scaled(&mut self, w: A::Real, other: &mut Self) {
        for (row, other) in self.rows().iter_mut().zip(other.rows()) {
            row.add_scaled(w, other);
        }
    }
}

/// Returns J·(q, p) = (p, −q).
#[inline(always)]
pub(super) fn j_times<A: Array>([q, p]: &[A; 2]) -> [A; 2] {
    [*p, opposite(q)]
}

/// Returns `x`, or the smallest normal number if `x` is smaller. Division by the result returns 0 in place of 0/0. Precondition: `x` is not negative.
#[inline(always)]
pub(super) fn denominator<R: Real>(x: R) -> R {
    x.max(R::from_f64(R::smallest()))
}

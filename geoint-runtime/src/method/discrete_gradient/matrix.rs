//! Vectors and square matrices in all coordinates (q, p).

use crate::scalar::{Real, zero};
use crate::space::{Array, Square};

/// A square matrix in all coordinates, a row an entry of (q, p).
#[derive(Clone, Copy, Debug)]
pub struct Matrix<A: Array>(Square<[A; 2]>);

impl<A: Array> Matrix<A> {
    /// All zeros.
    #[inline(always)]
    pub fn zero() -> Self {
        Matrix(<[A; 2]>::fill(<[A; 2]>::zero()))
    }

    /// The rows.
    #[inline(always)]
    pub fn rows(&mut self) -> &mut [[A; 2]] {
        <[A; 2]>::entries::<[A; 2]>(&mut self.0)
    }

    /// The rows, to be read.
    #[inline(always)]
    pub(super) fn rows_of(&self) -> &[[A; 2]] {
        <[A; 2]>::entries_of::<[A; 2]>(&self.0)
    }

    /// The product with a vector.
    #[inline(always)]
    pub(super) fn times(&mut self, x: &[A; 2]) -> [A; 2] {
        let mut y = <[A; 2]>::zero();
        for (y, row) in entries(&mut y).iter_mut().zip(self.rows()) {
            *y = dot(&*row, x);
        }
        y
    }

    /// The product of the transpose with a vector.
    #[inline(always)]
    pub(super) fn transpose_times(&mut self, x: &[A; 2]) -> [A; 2] {
        let mut y = <[A; 2]>::zero();
        for (x, row) in Array::as_slice(x).iter().zip(self.rows()) {
            y.add_scaled(*x, row);
        }
        y
    }

    /// self ← self + w·other.
    #[inline(always)]
    pub(super) fn add_scaled(&mut self, w: A::Real, other: &mut Self) {
        for (row, other) in self.rows().iter_mut().zip(other.rows()) {
            row.add_scaled(w, other);
        }
    }
}

/// The entries of a vector: arrays have a method of their own called `as_mut_slice`.
#[inline(always)]
pub(super) fn entries<X: Array>(x: &mut X) -> &mut [X::Real] {
    x.as_mut_slice()
}

/// x + w·d.
#[inline(always)]
pub(super) fn moved<X: Array>(x: &X, w: X::Real, d: &X) -> X {
    let mut end = *x;
    end.add_scaled(w, d);
    end
}

/// w·x.
#[inline(always)]
pub(super) fn scaled<X: Array>(w: X::Real, x: &X) -> X {
    moved(&X::zero(), w, x)
}

/// The products of entries.
#[inline(always)]
pub(super) fn product<X: Array>(x: &X, y: &X) -> X {
    let mut z = *x;
    for (z, y) in z.as_mut_slice().iter_mut().zip(y.as_slice()) {
        *z *= *y;
    }
    z
}

/// −x.
#[inline(always)]
pub(super) fn opposite<X: Array>(x: &X) -> X {
    scaled(X::Real::from_f64(-1.0), x)
}

/// x − y.
#[inline(always)]
pub(super) fn difference<X: Array>(x: &X, y: &X) -> X {
    moved(x, X::Real::from_f64(-1.0), y)
}

/// J·(q, p) = (p, −q).
#[inline(always)]
pub(super) fn turned<A: Array>([q, p]: &[A; 2]) -> [A; 2] {
    [*p, opposite(q)]
}

/// x·y.
#[inline(always)]
pub(super) fn dot<X: Array>(x: &X, y: &X) -> X::Real {
    x.as_slice().iter().zip(y.as_slice()).fold(zero(), |sum: X::Real, (x, y)| x.multiply_add(*y, sum))
}

/// `x`, which is not negative, as a denominator: 0/0 is 0.
#[inline(always)]
pub(super) fn denominator<R: Real>(x: R) -> R {
    x.max(R::from_f64(R::smallest()))
}

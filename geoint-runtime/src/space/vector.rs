//! Points, increments and gradients as vectors.

use super::Square;
use super::array::Array;
use crate::scalar::{Real, zero};

/// The entries of a vector: arrays have a method of their own called `as_mut_slice`.
#[inline(always)]
pub(crate) fn entries<X: Array>(x: &mut X) -> &mut [X::Real] {
    x.as_mut_slice()
}

/// The first entries of x, as many as `Y` has; entries that x does not have are `rest`.
#[inline(always)]
pub(crate) fn resized<X: Array, Y: Array<Real = X::Real>>(x: &X, rest: X::Real) -> Y {
    let mut y = Y::zero();
    let shared = usize::min(X::LEN, Y::LEN);
    y.as_mut_slice()[..shared].copy_from_slice(&x.as_slice()[..shared]);
    y.as_mut_slice()[shared..].fill(rest);
    y
}

/// x + w·d.
#[inline(always)]
pub(crate) fn moved<X: Array>(x: &X, w: X::Real, d: &X) -> X {
    let mut end = *x;
    end.add_scaled(w, d);
    end
}

/// w·x.
#[inline(always)]
pub(crate) fn scaled<X: Array>(w: X::Real, x: &X) -> X {
    moved(&X::zero(), w, x)
}

/// The products of entries.
#[inline(always)]
pub(crate) fn product<X: Array>(x: &X, y: &X) -> X {
    let mut z = *x;
    for (z, y) in z.as_mut_slice().iter_mut().zip(y.as_slice()) {
        *z *= *y;
    }
    z
}

/// −x.
#[inline(always)]
pub(crate) fn opposite<X: Array>(x: &X) -> X {
    scaled(X::Real::from_f64(-1.0), x)
}

/// x + y.
#[inline(always)]
pub(crate) fn sum<X: Array>(x: &X, y: &X) -> X {
    moved(x, X::Real::from_f64(1.0), y)
}

/// x − y.
#[inline(always)]
pub(crate) fn difference<X: Array>(x: &X, y: &X) -> X {
    moved(x, X::Real::from_f64(-1.0), y)
}

/// x·y.
#[inline(always)]
pub(crate) fn dot<X: Array>(x: &X, y: &X) -> X::Real {
    sum_of_products(x.as_slice(), y.as_slice())
}

/// Σ xᵢ·yᵢ.
#[inline(always)]
pub(crate) fn sum_of_products<R: Real>(x: &[R], y: &[R]) -> R {
    x.iter().zip(y).fold(zero(), |sum: R, (x, y)| x.multiply_add(*y, sum))
}

/// The product of a matrix with a vector.
#[inline(always)]
pub(crate) fn times<A: Array>(matrix: &Square<A>, x: &A) -> A {
    let mut product = A::zero();
    for (y, row) in product.as_mut_slice().iter_mut().zip(A::entries_of::<A>(matrix)) {
        *y = dot(row, x);
    }
    product
}

/// The value of a function after a small correction, from its value and its derivative: the square of the correction is rounding.
#[inline(always)]
pub(crate) fn extrapolated<A: Array>(value: &A, derivative: &Square<A>, correction: &A) -> A {
    sum(value, &times(derivative, correction))
}

/// Multiplies the rows of an equation with numbers.
#[inline(always)]
pub(crate) fn scale_rows<A: Array>(scales: &A, residual: &mut A, matrix: &mut Square<A>) {
    *residual = product(residual, scales);
    for (row, scale) in A::entries::<A>(matrix).iter_mut().zip(scales.as_slice()) {
        *row = scaled(*scale, row);
    }
}

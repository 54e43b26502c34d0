//! Vector algebra of points, increments and gradients. Nested arrays count as flat rows of numbers.

use super::Square;
use super::array::Array;
use crate::scalar::{Real, zero};

/// Returns the entries of a vector. `x.as_mut_slice()` would call the method of this name that Rust's arrays have, and return inner arrays.
#[inline(always)]
pub(crate) fn entries<X: Array>(x: &mut X) -> &mut [X::Real] {
    x.as_mut_slice()
}

/// Returns the first entries of x, as many as `Y` has. Further entries of the result are `rest`.
#[inline(always)]
pub(crate) fn resized<X: Array, Y: Array<Real = X::Real>>(x: &X, rest: X::Real) -> Y {
    let mut y = Y::zero();
    let shared = usize::min(X::LEN, Y::LEN);
    y.as_mut_slice()[..shared].copy_from_slice(&x.as_slice()[..shared]);
    y.as_mut_slice()[shared..].fill(rest);
    y
}

/// Returns x + w·d.
#[inline(always)]
pub(crate) fn moved<X: Array>(x: &X, w: X::Real, d: &X) -> X {
    let mut end = *x;
    end.add_scaled(w, d);
    end
}

/// Returns w·x.
#[inline(always)]
pub(crate) fn scaled<X: Array>(w: X::Real, x: &X) -> X {
    moved(&X::zero(), w, x)
}

/// Returns the products xᵢyᵢ of entries.
#[inline(always)]
pub(crate) fn product<X: Array>(x: &X, y: &X) -> X {
    let mut z = *x;
    for (z, y) in z.as_mut_slice().iter_mut().zip(y.as_slice()) {
        *z *= *y;
    }
    z
}

/// Returns −x.
#[inline(always)]
pub(crate) fn opposite<X: Array>(x: &X) -> X {
    scaled(X::Real::from_f64(-1.0), x)
}

/// Returns x + y.
#[inline(always)]
pub(crate) fn sum<X: Array>(x: &X, y: &X) -> X {
    moved(x, X::Real::from_f64(1.0), y)
}

/// Returns x − y.
#[inline(always)]
pub(crate) fn difference<X: Array>(x: &X, y: &X) -> X {
    moved(x, X::Real::from_f64(-1.0), y)
}

/// Returns the scalar product x·y.
#[inline(always)]
pub(crate) fn dot<X: Array>(x: &X, y: &X) -> X::Real {
    sum_of_products(x.as_slice(), y.as_slice())
}

/// Returns Σ xᵢ·yᵢ, up to the end of the shorter slice.
#[inline(always)]
pub(crate) fn sum_of_products<R: Real>(x: &[R], y: &[R]) -> R {
    x.iter().zip(y).fold(zero(), |sum: R, (x, y)| x.multiply_add(*y, sum))
}

/// Returns the product of a matrix and a vector.
#[inline(always)]
pub(crate) fn times<A: Array>(matrix: &Square<A>, x: &A) -> A {
    let mut product = A::zero();
    for (y, row) in product.as_mut_slice().iter_mut().zip(A::entries_of::<A>(matrix)) {
        *y = dot(row, x);
    }
    product
}

/// Returns a function after a correction of its argument, to first order, from its value and its derivative. Precondition: the square of the correction is
/// below rounding errors.
#[inline(always)]
pub(crate) fn extrapolated<A: Array>(value: &A, derivative: &Square<A>, correction: &A) -> A {
    sum(value, &times(derivative, correction))
}

/// Multiplies the rows of an equation, its residual and its matrix, by `scales`.
#[inline(always)]
pub(crate) fn scale_rows<A: Array>(scales: &A, residual: &mut A, matrix: &mut Square<A>) {
    *residual = product(residual, scales);
    for (row, scale) in A::entries::<A>(matrix).iter_mut().zip(scales.as_slice()) {
        *row = scaled(*scale, row);
    }
}

//! Coefficients of order n ≥ 1 of a series from those of its operands, for the kernels that are emitted.
//!
//! Coefficients are normalised: u⁽ⁿ⁾/n!. Sums Σ uⱼwₙ₋ⱼ begin in the middle, with coefficients that are known for long, in two chains,
//! and those of order n come last: then each operation adds one multiplication to what a next coefficient waits for. With j from 0 on
//! the double pendulum takes four times as long.
//!
//! What is divided by at every order is divided by: the rounding of a reciprocal, made once, would count n times. It may be multiplied with
//! the coefficient of order n, which is smaller and must not wait.
//!
//! R. E. Moore, *Interval Analysis* (1966) ch. 11; À. Jorba & M. Zou, Exp. Math. 14 (2005) 99; for powers see also R. D. Neidinger,
//! SIAM Rev. 52 (2010) 545.

use crate::scalar::{Real, zero};

/// 1/n.
#[inline(always)]
fn over<R: Real>(n: usize) -> R {
    R::from_f64(1.0 / n as f64)
}

/// Σ uⱼwₙ₋ⱼ over 0 < j < n.
#[inline(always)]
fn inner<R: Real, const P: usize>(u: &[R; P], w: &[R; P], n: usize) -> R {
    let (u, w) = (&u[..n], &w[..n]);
    let (mut first, mut second) = (zero::<R>(), zero::<R>());
    if n.is_multiple_of(2) {
        first = u[n / 2] * w[n / 2];
    }
    for j in (1..n.div_ceil(2)).rev() {
        first = u[j].multiply_add(w[n - j], first);
        second = u[n - j].multiply_add(w[j], second);
    }
    first + second
}

/// Σ uⱼuₙ₋ⱼ over 0 < j < n.
#[inline(always)]
fn inner_square<R: Real, const P: usize>(u: &[R; P], n: usize) -> R {
    let u = &u[..n];
    let mut half = zero::<R>();
    for j in (1..n.div_ceil(2)).rev() {
        half = u[j].multiply_add(u[n - j], half);
    }
    let double = half + half;
    if n.is_multiple_of(2) { u[n / 2].multiply_add(u[n / 2], double) } else { double }
}

/// Of a function a + b·t.
#[inline(always)]
pub fn affine<R: Real>(slope: R, n: usize) -> R {
    if n == 1 { slope } else { zero() }
}

/// u·w.
#[inline(always)]
pub fn product<R: Real, const P: usize>([u, w]: [&[R; P]; 2], [un, wn]: [R; 2], n: usize) -> R {
    u[0].multiply_add(wn, un.multiply_add(w[0], inner(u, w, n)))
}

/// u².
#[inline(always)]
pub fn square<R: Real, const P: usize>(u: &[R; P], un: R, n: usize) -> R {
    (u[0] + u[0]).multiply_add(un, inner_square(u, n))
}

/// y with y·w = u, from 1/w₀.
#[inline(always)]
pub fn quotient<R: Real, const P: usize>([w, y]: [&[R; P]; 2], [un, wn]: [R; 2], over: R, n: usize) -> R {
    let rest = inner(w, y, n) / w[0];
    un.multiply_add(over, (-(y[0] * over)).multiply_add(wn, -rest))
}

/// y with y·w = 1.
#[inline(always)]
pub fn reciprocal<R: Real, const P: usize>([w, y]: [&[R; P]; 2], wn: R, n: usize) -> R {
    let rest = inner(w, y, n) / w[0];
    (-(y[0] * y[0])).multiply_add(wn, -rest)
}

/// y with y² = u, from 1/(2y₀).
#[inline(always)]
pub fn root<R: Real, const P: usize>(y: &[R; P], un: R, over: R, n: usize) -> R {
    un.multiply_add(over, -(inner_square(y, n) / (y[0] + y[0])))
}

/// y with y'·u = α·y·u', from α + 1 and α·y₀/u₀.
#[inline(always)]
pub fn power<R: Real, const P: usize>([u, y]: [&[R; P]; 2], un: R, [next, ratio]: [R; 2], n: usize) -> R {
    let (u, y) = (&u[..n], &y[..n]);
    let whole = R::from_f64(n as f64);
    let factor = |j: usize| R::from_f64(j as f64).multiply_add(next, -whole);
    let (mut first, mut second) = (zero::<R>(), zero::<R>());
    if n.is_multiple_of(2) {
        first = factor(n / 2) * u[n / 2] * y[n / 2];
    }
    for j in (1..n.div_ceil(2)).rev() {
        first = (factor(j) * u[j]).multiply_add(y[n - j], first);
        second = (factor(n - j) * u[n - j]).multiply_add(y[j], second);
    }
    un.multiply_add(ratio, (first + second) / (whole * u[0]))
}

/// y with y' = d·u', from j·uⱼ.
#[inline(always)]
pub fn integral<R: Real, const P: usize>([ju, d]: [&[R; P]; 2], un: R, n: usize) -> R {
    un.multiply_add(d[0], inner(ju, d, n) * over(n))
}

/// y with y'·d = u', from j·yⱼ and 1/d₀.
#[inline(always)]
pub fn quadrature<R: Real, const P: usize>([jy, d]: [&[R; P]; 2], un: R, inverse: R, n: usize) -> R {
    un.multiply_add(inverse, -(inner(jy, d, n) / (R::from_f64(n as f64) * d[0])))
}

/// The angle a of the point (x, y), with (x² + y²)a' = x·y' − y·x', from j·yⱼ, j·xⱼ, j·aⱼ and 1/(x₀² + y₀²).
#[inline(always)]
pub fn angle<R: Real, const P: usize>(
    [jy, jx, ja]: [&[R; P]; 3],
    [y, x, square]: [&[R; P]; 3],
    [yn, xn]: [R; 2],
    inverse: R,
    n: usize,
) -> R {
    let rest = inner(jy, x, n) - inner(jx, y, n) - inner(ja, square, n);
    let last = yn.multiply_add(x[0], -(xn * y[0]));
    last.multiply_add(inverse, rest / (R::from_f64(n as f64) * square[0]))
}

//! The polynomial of a step.

use super::roots::MOST;
use crate::scalar::{Real, exact_product};
use crate::space::{Action, Array, PerCoordinate};

/// x(h) − x(0) from the coefficients of orders 1, 2, ….
#[inline(always)]
pub(crate) fn increment<Z: Array, S: Action<Z::Real>>(jet: &[PerCoordinate<Z, S>], h: f64) -> PerCoordinate<Z, S> {
    let mut increment = sum(jet, h, |_| 1.0);
    increment.times(Z::Real::from_f64(h));
    increment
}

/// The same as h·x₁ and what is left, with what that product has lost: most of the rounding of a step would be this one.
#[inline(always)]
pub(crate) fn increments<Z: Array, S: Action<Z::Real>>(
    jet: &[PerCoordinate<Z, S>],
    h: f64,
) -> [PerCoordinate<Z, S>; 2] {
    let [first, later @ ..] = jet else { return [PerCoordinate::zero(); 2] };
    let (mut first, mut rest, h) = (*first, increment(later, h), Z::Real::from_f64(h));
    let part = |(first, rest): (&mut Z::Real, &mut Z::Real)| {
        let (product, lost) = exact_product(h, *first);
        (*first, *rest) = (product, h.multiply_add(*rest, lost));
    };
    first.z.as_mut_slice().iter_mut().zip(rest.z.as_mut_slice()).for_each(part);
    first.s.numbers_mut().iter_mut().zip(rest.s.numbers_mut()).for_each(part);
    [first, rest]
}

/// Its derivative by h.
#[inline(always)]
pub(crate) fn rate<Z: Array, S: Action<Z::Real>>(jet: &[PerCoordinate<Z, S>], h: f64) -> PerCoordinate<Z, S> {
    sum(jet, h, |order| order as f64)
}

/// Σ w(k) xₖ hᵏ⁻¹ from the coefficients x₁, x₂, …: every fourth one apart, each a polynomial in h⁴, so that none is waited for long.
#[inline(always)]
fn sum<Z: Array, S: Action<Z::Real>>(
    jet: &[PerCoordinate<Z, S>],
    h: f64,
    weight: impl Fn(usize) -> f64,
) -> PerCoordinate<Z, S> {
    let [h, square, fourth] = [h, h * h, (h * h) * (h * h)].map(Z::Real::from_f64);
    let (fours, rest) = jet.as_chunks::<4>();
    let mut sums = [PerCoordinate::zero(); 4];
    let mut include = |i: usize, terms: &[PerCoordinate<Z, S>]| {
        for (k, (sum, x)) in sums.iter_mut().zip(terms).enumerate() {
            times_and_add(sum, fourth, Z::Real::from_f64(weight(4 * i + k + 1)), x);
        }
    };
    include(fours.len(), rest);
    for (i, four) in fours.iter().enumerate().rev() {
        include(i, four);
    }
    let [mut sum, second, mut third, fourth] = sums;
    third.add_scaled(h, &fourth);
    sum.add_scaled(h, &second);
    sum.add_scaled(square, &third);
    sum
}

/// y ← s·y + w·x.
#[inline(always)]
fn times_and_add<Z: Array, S: Action<Z::Real>>(
    y: &mut PerCoordinate<Z, S>,
    s: Z::Real,
    w: Z::Real,
    x: &PerCoordinate<Z, S>,
) {
    for (y, x) in y.z.as_mut_slice().iter_mut().zip(x.z.as_slice()) {
        *y = s.multiply_add(*y, w * *x);
    }
    for (y, x) in y.s.numbers_mut().iter_mut().zip(x.s.numbers()) {
        *y = s.multiply_add(*y, w * *x);
    }
}

/// Coefficients of a polynomial about a point as those about a point so much later; that of the highest order is `last`.
pub(crate) fn shift<R: Real>(coefficients: &mut [R], last: R, by: R) {
    let n = coefficients.len();
    for first in 0..n {
        for k in (first..n).rev() {
            let next = if k + 1 == n { last } else { coefficients[k + 1] };
            coefficients[k] = by.multiply_add(next, coefficients[k]);
        }
    }
}

/// Coefficients c₀, c₁, … of powers of time as those of powers of a part of a step: cₖ hᵏ. What is zero stays so, however long the step is.
#[inline(always)]
pub(crate) fn in_parts(coefficients: impl Iterator<Item = f64>, h: f64) -> [f64; MOST] {
    let (mut parts, mut power) = ([0.0; MOST], 1.0);
    for (part, c) in parts.iter_mut().zip(coefficients) {
        *part = if c == 0.0 { 0.0 } else { power * c };
        power *= h;
    }
    parts
}

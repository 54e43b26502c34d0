//! The polynomial of a step.

use super::roots::MOST;
use crate::scalar::Real;
use crate::space::{Action, Array, PerCoordinate};

/// x(h) − x(0) from the coefficients of orders 1, 2, …: odd and even ones apart, each a polynomial in h².
#[inline(always)]
pub(crate) fn increment<Z: Array, S: Action<Z::Real>>(jet: &[PerCoordinate<Z, S>], h: f64) -> PerCoordinate<Z, S> {
    let [h, square] = [h, h * h].map(Z::Real::from_f64);
    let (pairs, rest) = jet.as_chunks();
    let (mut odd, mut even) = (rest.first().copied().unwrap_or(PerCoordinate::zero()), PerCoordinate::zero());
    for [first, second] in pairs.iter().rev() {
        times_and_add(&mut odd, square, first);
        times_and_add(&mut even, square, second);
    }
    odd.add_scaled(h, &even);
    odd.times(h);
    odd
}

/// The same, with its derivative by h: that of h·o(h²) + h²·e(h²) is o + 2h(e + h·o' + h²·e').
#[inline(always)]
pub(crate) fn increment_and_rate<Z: Array, S: Action<Z::Real>>(
    jet: &[PerCoordinate<Z, S>],
    h: f64,
) -> (PerCoordinate<Z, S>, PerCoordinate<Z, S>) {
    let [h, square] = [h, h * h].map(Z::Real::from_f64);
    let (pairs, rest) = jet.as_chunks();
    let (mut odd, mut even) = (rest.first().copied().unwrap_or(PerCoordinate::zero()), PerCoordinate::zero());
    let [mut odd_rate, mut even_rate] = [PerCoordinate::zero(); 2];
    for [first, second] in pairs.iter().rev() {
        times_and_add(&mut odd_rate, square, &odd);
        times_and_add(&mut even_rate, square, &even);
        times_and_add(&mut odd, square, first);
        times_and_add(&mut even, square, second);
    }
    times_and_add(&mut even_rate, square, &even);
    even_rate.add_scaled(h, &odd_rate);
    let mut rate = odd;
    rate.add_scaled(h + h, &even_rate);
    odd.add_scaled(h, &even);
    odd.times(h);
    (odd, rate)
}

/// y ← w·y + x.
#[inline(always)]
fn times_and_add<Z: Array, S: Action<Z::Real>>(y: &mut PerCoordinate<Z, S>, w: Z::Real, x: &PerCoordinate<Z, S>) {
    for (y, x) in y.z.as_mut_slice().iter_mut().zip(x.z.as_slice()) {
        *y = w.multiply_add(*y, *x);
    }
    for (y, x) in y.s.numbers_mut().iter_mut().zip(x.s.numbers()) {
        *y = w.multiply_add(*y, *x);
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

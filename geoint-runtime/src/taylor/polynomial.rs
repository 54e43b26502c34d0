//! The polynomial of a step.

use super::roots::MOST;
use crate::scalar::{Real, exact_product};
use crate::space::{Action, Array, PerCoordinate};

/// Four sums for each of so many coordinates have room in registers.
const FEW: usize = 8;

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

/// Σ w(k) xₖ hᵏ⁻¹ from the coefficients x₁, x₂, …
#[inline(always)]
fn sum<Z: Array, S: Action<Z::Real>>(
    jet: &[PerCoordinate<Z, S>],
    h: f64,
    weight: impl Fn(usize) -> f64,
) -> PerCoordinate<Z, S> {
    if PerCoordinate::<Z, S>::LEN > FEW {
        return in_turn::<2, Z, S>(jet, h, weight);
    }
    // Loops over the orders that tolerances choose for large systems, and over what is left of them without the first, would have no known length.
    match jet.len() {
        13 => in_turn::<4, Z, S>(&jet[..13], h, weight),
        14 => in_turn::<4, Z, S>(&jet[..14], h, weight),
        15 => in_turn::<4, Z, S>(&jet[..15], h, weight),
        16 => in_turn::<4, Z, S>(&jet[..16], h, weight),
        _ => in_turn::<4, Z, S>(jet, h, weight),
    }
}

/// The same from every `K`th coefficient apart, each time a polynomial in hᴷ: none of them is waited for long.
#[inline(always)]
fn in_turn<const K: usize, Z: Array, S: Action<Z::Real>>(
    jet: &[PerCoordinate<Z, S>],
    h: f64,
    weight: impl Fn(usize) -> f64,
) -> PerCoordinate<Z, S> {
    let square = h * h;
    let power = Z::Real::from_f64(if K == 4 { square * square } else { square });
    let (turns, rest) = jet.as_chunks::<K>();
    let mut sums = [PerCoordinate::zero(); K];
    let mut include = |turn: usize, terms: &[PerCoordinate<Z, S>]| {
        for (k, (sum, x)) in sums.iter_mut().zip(terms).enumerate() {
            times_and_add(sum, power, Z::Real::from_f64(weight(K * turn + k + 1)), x);
        }
    };
    include(turns.len(), rest);
    for (turn, terms) in turns.iter().enumerate().rev() {
        include(turn, terms);
    }
    let mut sum = sums[K - 1];
    for before in sums[..K - 1].iter().rev() {
        let mut next = *before;
        next.add_scaled(Z::Real::from_f64(h), &sum);
        sum = next;
    }
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

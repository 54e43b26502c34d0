//! Evaluates the polynomial of a step.

use super::roots::MOST;
use crate::scalar::{Real, exact_product};
use crate::space::{Action, Array, PerCoordinate};

/// Up to this number of coordinates, four partial sums for each fit into registers.
const FEW: usize = 8;

/// Returns x(h) − x(0) from the coefficients of orders 1, 2, ….
#[inline(always)]
pub(crate) fn increment<Z: Array, S: Action<Z::Real>>(jet: &[PerCoordinate<Z, S>], h: f64) -> PerCoordinate<Z, S> {
    let mut increment = sum(jet, h, |_| 1.0);
    increment.times(Z::Real::from_f64(h));
    increment
}

/// Returns x(h) − x(0) as two terms: h·x₁ and the rest. The rest contains the rounding error of the product h·x₁, which would otherwise dominate the
/// rounding of a step.
#[inline(always)]
pub(crate) fn increments<Z: Array, S: Action<Z::Real>>(
    jet: &[PerCoordinate<Z, S>],
    h: f64,
) -> [PerCoordinate<Z, S>; 2] {
    let [first, later @ ..] = jet else { return [PerCoordinate::zero(); 2] };
    let (mut first, mut rest, h) = (*first, increment(later, h), Z::Real::from_f64(h));
    let part = |(first, rest): (&mut Z::Real, &mut Z::Real)| {
        let (product, rounding_error) = exact_product(h, *first);
        (*first, *rest) = (product, h.multiply_add(*rest, rounding_error));
    };
    first.z.as_mut_slice().iter_mut().zip(rest.z.as_mut_slice()).for_each(part);
    first.s.numbers_mut().iter_mut().zip(rest.s.numbers_mut()).for_each(part);
    [first, rest]
}

/// Returns the derivative of the polynomial at h: Σ k xₖ hᵏ⁻¹.
#[inline(always)]
pub(crate) fn rate<Z: Array, S: Action<Z::Real>>(jet: &[PerCoordinate<Z, S>], h: f64) -> PerCoordinate<Z, S> {
    sum(jet, h, |order| order as f64)
}

/// Returns Σ w(k) xₖ hᵏ⁻¹ from the coefficients x₁, x₂, ….
#[inline(always)]
fn sum<Z: Array, S: Action<Z::Real>>(
    jet: &[PerCoordinate<Z, S>],
    h: f64,
    weight: impl Fn(usize) -> f64,
) -> PerCoordinate<Z, S> {
    if PerCoordinate::<Z, S>::LEN > FEW {
        return in_turn::<2, Z, S>(jet, h, weight);
    }
    in_turn::<4, Z, S>(jet, h, weight)
}

/// Computes the sum as `K` interleaved polynomials in hᴷ. Their chains of dependent operations are shorter than one Horner scheme.
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

/// Computes y ← s·y + w·x.
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

/// Shifts the centre of a polynomial by `by`: replaces its coefficients by those of powers of x − `by`. `last` is the coefficient of the highest
/// order, which does not change.
pub(crate) fn shift<R: Real>(coefficients: &mut [R], last: R, by: R) {
    let n = coefficients.len();
    for first in 0..n {
        for k in (first..n).rev() {
            let next = if k + 1 == n { last } else { coefficients[k + 1] };
            coefficients[k] = by.multiply_add(next, coefficients[k]);
        }
    }
}

/// Converts coefficients cₖ of powers of time to coefficients cₖ hᵏ of powers of the fraction of a step. Zeros remain zero, even if hᵏ overflows.
#[inline(always)]
pub(crate) fn in_parts(coefficients: impl Iterator<Item = f64>, h: f64) -> [f64; MOST] {
    let (mut parts, mut power) = ([0.0; MOST], 1.0);
    for (part, c) in parts.iter_mut().zip(coefficients) {
        *part = if c == 0.0 { 0.0 } else { power * c };
        power *= h;
    }
    parts
}

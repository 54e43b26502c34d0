//! Functions at the boundary of a domain, at kinks, and near numbers whose squares leave the range. f[a, b] is the divided difference (f(b) − f(a))/(b − a).

use super::{away, tiny};
use crate::scalar::Real;

/// Returns 1/x if all components of x are positive, else NaN. Otherwise the step has crossed a pole or the edge of a logarithm, and the NaN refuses it.
#[inline(always)]
pub fn recip_positive<R: Real>(x: R) -> R {
    R::from_f64(if x.any_not_positive() { f64::NAN } else { 1.0 }) / x
}

/// Returns x, or NaN if a component of x is negative. The NaN leads to a refused step.
#[inline(always)]
pub fn not_negative<R: Real>(x: R) -> R {
    if x.any_below(0.0) { R::from_f64(f64::NAN) } else { x }
}

/// Returns x, or NaN if x² exceeds y by more than rounding. Squares below the smallest normal number have no digits to compare. A NaN in y is not detected.
#[inline(always)]
pub fn bounded<R: Real>(x: R, y: R) -> R {
    let margin = R::from_f64(1.0 + 8.0 * R::epsilon());
    if (y * margin + R::from_f64(R::smallest()) - x * x).any_below(0.0) { R::from_f64(f64::NAN) } else { x }
}

/// Returns x, or NaN if y is negative. A NaN in y is not detected.
#[inline(always)]
pub fn provided<R: Real>(x: R, y: R) -> R {
    if y.any_below(0.0) { R::from_f64(f64::NAN) } else { x }
}

/// Returns x, or NaN if x > y. A NaN in y is not detected.
#[inline(always)]
pub fn at_most<R: Real>(x: R, y: R) -> R {
    if (y - x).any_below(0.0) { R::from_f64(f64::NAN) } else { x }
}

/// Returns √x plus a tiny number. At x = 0 a quotient with it is 0 in place of 0/0. The tiny number is a cube root, so that its square and its cube are normal
/// numbers.
#[inline(always)]
pub fn root<R: Real>(x: R) -> R {
    x.sqrt() + tiny::<R>().cbrt()
}

/// Returns abs[a, b] = (a + b)/(|a| + |b|). At a = b = 0 the result is the sign of zero.
#[inline(always)]
pub fn abs<R: Real>(a: R, b: R) -> R {
    let (a, b) = (away(a), away(b));
    (a + b) / (a.abs() + b.abs())
}

/// Returns ∂abs[a, b]/∂b = (|a| − a sgn b)/(|a| + |b|)². It is zero if a and b have the same sign.
#[inline(always)]
pub fn abs_derivative<R: Real>(a: R, b: R) -> R {
    let (a, b) = (away(a), away(b));
    let size = a.abs() + b.abs();
    (a.abs() - a * b.signum()) / size / size
}

/// Returns a power of two by which numbers of this size are multiplied before they are squared. It avoids underflow and overflow of the squares, and of
/// their parts of the size of rounding. It is 1 for ordinary sizes.
#[inline(always)]
pub fn before_squares<R: Real>(size: R) -> R {
    let (square, rounding) = (size.magnitude() * size.magnitude(), R::epsilon() / 64.0);
    let least = R::smallest() / (rounding * rounding);
    if square > least && square < 1.0 / least { R::from_f64(1.0) } else { power_of_two(size) }
}

/// Returns a power of two near 1/|x|, or 1 if x is zero or not finite.
#[cold]
#[inline(never)]
fn power_of_two<R: Real>(x: R) -> R {
    const MANTISSA: u32 = f64::MANTISSA_DIGITS - 1;
    let size = x.magnitude();
    if !(size > 0.0 && size < f64::INFINITY) {
        return R::from_f64(1.0);
    }
    let power = f64::from_bits((2 * f64::MAX_EXP as u64 - 2 - (size.to_bits() >> MANTISSA)) << MANTISSA);
    R::from_f64(power.clamp(R::smallest(), 1.0 / R::smallest()))
}

/// Returns x, multiplied by [`before_squares`] of y.
#[inline(always)]
pub fn scaled<R: Real>(x: R, y: R) -> R {
    before_squares(y) * x
}

/// Returns 1/x. x is the square of the rest of a vector after a subtraction, and y is the square of the vector itself. Returns zero if the rest is
/// rounding, or subnormal. NaN if x is infinite.
#[inline(always)]
pub fn recip_above<R: Real>(x: R, y: R) -> R {
    // 10⁻¹⁴ of the length in double precision.
    let rounding = 45.0 * R::epsilon();
    let bound = R::from_f64(rounding * rounding) * y + R::from_f64(R::smallest());
    let [value] = R::choose(x.less_equal(bound), || [R::from_f64(0.0)], || [R::from_f64(1.0) / x]);
    value + R::from_f64(0.0) * x
}

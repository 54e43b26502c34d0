//! Where functions end or are not smooth.

use super::{away, tiny};
use crate::scalar::Real;

/// 1/x of a positive number, NaN of any other: of logarithms and of poles only one side belongs to a trajectory.
#[inline(always)]
pub fn recip_positive<R: Real>(x: R) -> R {
    R::from_f64(if x.any_not_positive() { f64::NAN } else { 1.0 }) / x
}

/// x, which must not be negative: NaN if it is, so that no step is made with it.
#[inline(always)]
pub fn not_negative<R: Real>(x: R) -> R {
    if x.any_below(0.0) { R::from_f64(f64::NAN) } else { x }
}

/// x, whose square must not be above y but for rounding: NaN if it is.
#[inline(always)]
pub fn bounded<R: Real>(x: R, y: R) -> R {
    let margin = R::from_f64(1.0 + 8.0 * R::epsilon());
    if (y * margin - x * x).any_below(0.0) { R::from_f64(f64::NAN) } else { x }
}

/// x, provided that y is not negative: NaN if it is.
#[inline(always)]
pub fn provided<R: Real>(x: R, y: R) -> R {
    if y.any_below(0.0) { R::from_f64(f64::NAN) } else { x }
}

/// x, which must not be above y: NaN if it is.
#[inline(always)]
pub fn at_most<R: Real>(x: R, y: R) -> R {
    if (y - x).any_below(0.0) { R::from_f64(f64::NAN) } else { x }
}

/// √x, and at 0 something that can be divided by: (xᵐᐟ²)[a, b] has a limit there for m > 2.
#[inline(always)]
pub fn root<R: Real>(x: R) -> R {
    x.sqrt() + tiny::<R>().cbrt()
}

/// abs[a, b] = (a + b)/(|a| + |b|); at 0 the sign that zero carries.
#[inline(always)]
pub fn abs<R: Real>(a: R, b: R) -> R {
    let (a, b) = (away(a), away(b));
    (a + b) / (a.abs() + b.abs())
}

/// ∂abs[a, b]/∂b = (|a| − a sgn b)/(|a| + |b|)²: zero on one side of the kink.
#[inline(always)]
pub fn abs_derivative<R: Real>(a: R, b: R) -> R {
    let (a, b) = (away(a), away(b));
    let size = a.abs() + b.abs();
    (a.abs() - a * b.signum()) / size / size
}

/// A power of two by which numbers of this size are multiplied before they are squared: 1 where their squares, and what is left of those when all but
/// rounding is subtracted, have all their digits.
#[inline(always)]
pub fn before_squares<R: Real>(size: R) -> R {
    let (square, rounding) = (size.magnitude() * size.magnitude(), R::epsilon() / 64.0);
    let least = R::smallest() / (rounding * rounding);
    if square > least && square < 1.0 / least { R::from_f64(1.0) } else { power_of_two(size) }
}

/// A power of two near 1/|x|. 1 if x is zero or not finite.
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

/// x, [scaled](before_squares) as numbers of the size of y are.
#[inline(always)]
pub fn scaled<R: Real>(x: R, y: R) -> R {
    before_squares(y) * x
}

/// 1/x of the square x of what is left of a vector whose square was y: zero where that is rounding alone, or so small that it has lost
/// digits. NaN if it is infinite.
#[inline(always)]
pub fn recip_above<R: Real>(x: R, y: R) -> R {
    // 10⁻¹⁴ of the length, in double precision.
    let rounding = 45.0 * R::epsilon();
    let bound = R::from_f64(rounding * rounding) * y + R::from_f64(R::smallest());
    let [value] = R::choose(x.less_equal(bound), || [R::from_f64(0.0)], || [R::from_f64(1.0) / x]);
    value + R::from_f64(0.0) * x
}

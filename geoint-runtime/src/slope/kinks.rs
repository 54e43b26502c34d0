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

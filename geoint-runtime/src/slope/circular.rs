//! Divided differences of circular functions: sines of half an increment, and angles between two points.

use super::{away, by_pairs, either, factorial, polynomial, series, tiny};
use crate::scalar::Real;

/// Returns sin x / x.
#[inline(always)]
pub fn sinc<R: Real>(x: R) -> R {
    let small = |x: R| by_pairs(-(x * x), series!(9, |k| 1.0 / factorial(2 * k + 1)));
    let large = || {
        let x = away(x);
        x.sin() / x
    };
    either(x, 1.0, small, large)
}

/// Returns the derivative of [`sinc`].
#[inline(always)]
pub fn sinc_derivative<R: Real>(x: R) -> R {
    let small = |x: R| -x * by_pairs(-(x * x), series!(9, |k| (2 * k + 2) as f64 / factorial(2 * k + 3)));
    let large = || {
        let x = away(x);
        (x.cos() - x.sin() / x) / x
    };
    either(x, 1.0, small, large)
}

/// Returns atan2(y, x)/y, which is even in y. Its limit for y → 0 and x > 0 is 1/x.
#[inline(always)]
pub fn arc<R: Real>(y: R, x: R) -> R {
    // y is increased by ε²|x|, so that y = 0 gives the limit.
    let y = y.abs() + x.abs() * R::from_f64(R::epsilon() * R::epsilon());
    y.atan2(x) / y
}

/// Returns ∂[`arc`]/∂y, which is odd in y.
#[inline(always)]
pub fn arc_derivative<R: Real>(y: R, x: R) -> R {
    // y/width is the tangent of the angle for x > 0, and large for x < 0.
    let width = x.max(y.abs() * R::from_f64(1e-3)).max(tiny());
    let small = |w: R| {
        let sum = polynomial(-(w * w), series!(19, |k| (2 * k + 2) as f64 / (2 * k + 3) as f64));
        -w * sum / (width * width)
    };
    let large = || (x / (x * x + y * y) - arc(y, x)) / away(y);
    either(y / width, 0.375, small, large)
}

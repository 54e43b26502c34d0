//! Divided differences of hyperbolic functions.

use super::{away, either, factorial, polynomial, series, tiny};
use crate::scalar::Real;

/// Returns sinh x / x.
#[inline(always)]
pub fn sinhc<R: Real>(x: R) -> R {
    let small = |x: R| polynomial(x * x, series!(9, |k| 1.0 / factorial(2 * k + 1)));
    let large = || {
        let x = away(x);
        x.sinh() / x
    };
    either(x, 1.0, small, large)
}

/// Returns the derivative of [`sinhc`].
#[inline(always)]
pub fn sinhc_derivative<R: Real>(x: R) -> R {
    let small = |x: R| x * polynomial(x * x, series!(9, |k| (2 * k + 2) as f64 / factorial(2 * k + 3)));
    let large = || {
        let x = away(x);
        (x.cosh() - x.sinh() / x) / x
    };
    either(x, 1.0, small, large)
}

/// Returns tanh[a, b] = 4 (1 − e^(−2d))/(2d)/((1 + e^(−2M))(1 + e^(2m))). m is the smaller argument, M the larger one, and d = M − m.
#[inline(always)]
pub fn tanh<R: Real>(a: R, b: R) -> R {
    let [one, two] = [1.0, 2.0].map(R::from_f64);
    let gap = two * ((b - a).abs() + tiny());
    let (low, high) = ((two * a.min(b)).exp(), (-two * a.max(b)).exp());
    let above = R::from_f64(-4.0) * (-gap).exp_m1() / gap;
    // Each factor may overflow. The slope is then zero.
    above / (one + low) / (one + high)
}

/// Returns ∂tanh[a, b]/∂b = tanh[a, b]·(L(b − a) − tanh b) with the Langevin function L(x) = coth x − 1/x.
#[inline(always)]
pub fn tanh_derivative<R: Real>(a: R, b: R) -> R {
    let one = R::from_f64(1.0);
    let gap = b - a;
    let large = || {
        let x = away(gap);
        one / x.tanh() - one / x
    };
    tanh(a, b) * (either(gap, 1.0, |x| sinhc_derivative(x) / sinhc(x), large) - b.tanh())
}

//! Smooth helpers of divided differences f[a, b] = (f(b) − f(a))/(b − a): no 0/0, no cancellation, f[a, a] = f'(a).

use crate::real::Real;

/// sin x / x.
#[inline(always)]
pub fn sinc<R: Real>(x: R) -> R {
    if x.magnitude() < 1.0 {
        // Taylor to x¹⁶: the remainder is below 10⁻¹⁷.
        let y = x * x;
        polynomial(
            y,
            [
                1.0,
                -1.0 / 6.0,
                1.0 / 120.0,
                -1.0 / 5040.0,
                1.0 / 362_880.0,
                -1.0 / 39_916_800.0,
                1.0 / 6_227_020_800.0,
                -1.0 / 1_307_674_368_000.0,
                1.0 / 355_687_428_096_000.0,
            ],
        )
    } else {
        x.sin() / x
    }
}

/// The derivative of [`sinc`].
#[inline(always)]
pub fn sinc_derivative<R: Real>(x: R) -> R {
    if x.magnitude() < 1.0 {
        let y = x * x;
        x * polynomial(
            y,
            [
                -2.0 / 6.0,
                4.0 / 120.0,
                -6.0 / 5040.0,
                8.0 / 362_880.0,
                -10.0 / 39_916_800.0,
                12.0 / 6_227_020_800.0,
                -14.0 / 1_307_674_368_000.0,
                16.0 / 355_687_428_096_000.0,
            ],
        )
    } else {
        (x.cos() - x.sin() / x) / x
    }
}

/// exp[a, b] = e^max · expm1(−|b − a|)/(−|b − a|).
#[inline(always)]
pub fn exp<R: Real>(a: R, b: R) -> R {
    let gap = -(b - a).abs();
    a.max(b).exp() * quotient(gap.exp_m1(), gap)
}

/// ∂ exp[a, b]/∂b = e^b φ₂(a − b), φ₂(z) = (e^z − 1 − z)/z².
#[inline(always)]
pub fn exp_derivative<R: Real>(a: R, b: R) -> R {
    let z = a - b;
    let phi2 = if z.magnitude() < 1.0 {
        // 1/2! + z/3! + z²/4! + …
        let mut sum = R::from_f64(0.0);
        for k in (2..=19).rev() {
            sum = (sum * z + R::from_f64(1.0)) / R::from_f64(k as f64);
        }
        sum
    } else {
        (z.exp_m1() - z) / (z * z)
    };
    b.exp() * phi2
}

/// 1/x of a positive number; NaN of any other, which has no logarithm.
#[inline(always)]
pub fn recip_positive<R: Real>(x: R) -> R {
    R::from_f64(if x.any_below(f64::MIN_POSITIVE) { f64::NAN } else { 1.0 }) / x
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

/// ln[a, b] = log1p((M − m)/m)/(M − m), m the smaller and M the larger argument.
#[inline(always)]
pub fn ln<R: Real>(a: R, b: R) -> R {
    let m = a.min(b);
    let t = (b - a).abs() / m;
    quotient(t.ln_1p(), t) * recip_positive(m)
}

/// ∂ ln[a, b]/∂b.
#[inline(always)]
pub fn ln_derivative<R: Real>(a: R, b: R) -> R {
    let one = R::from_f64(1.0);
    if (b - a).any_below(0.0) {
        // Based on the smaller argument: from a the result would cancel.
        let s = (a - b) / b;
        -(log_quotient(s) + (one + s) * log_quotient_derivative(s)) / (b * b)
    } else {
        log_quotient_derivative((b - a) / a) / (a * a)
    }
}

/// log1p(t)/t.
#[inline(always)]
fn log_quotient<R: Real>(t: R) -> R {
    quotient(t.ln_1p(), t)
}

/// The derivative of log1p(t)/t: Σ (−1)ᵏ⁺¹ (k+1)/(k+2) tᵏ near 0.
#[inline(always)]
fn log_quotient_derivative<R: Real>(t: R) -> R {
    if t.magnitude() < 0.1 {
        let mut sum = R::from_f64(0.0);
        for k in (0..26).rev() {
            sum = R::from_f64((k as f64 + 1.0) / (k as f64 + 2.0)) - t * sum;
        }
        -sum
    } else {
        (R::from_f64(1.0) / (R::from_f64(1.0) + t) - log_quotient(t)) / t
    }
}

/// x/y for two functions that vanish together with slope 1.
#[inline(always)]
fn quotient<R: Real>(x: R, y: R) -> R {
    if y.magnitude() == 0.0 { R::from_f64(1.0) } else { x / y }
}

/// Σ cₖ yᵏ by Horner's rule.
#[inline(always)]
fn polynomial<R: Real, const N: usize>(y: R, c: [f64; N]) -> R {
    let mut sum = R::from_f64(c[N - 1]);
    for k in (0..N - 1).rev() {
        sum = sum.multiply_add(y, R::from_f64(c[k]));
    }
    sum
}

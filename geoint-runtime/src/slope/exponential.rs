//! Divided differences of exponentials, logarithms and powers.

use super::{away, by_pairs, either, factorial, polynomial, recip_positive, series, tiny};
use crate::scalar::Real;

/// Returns exp[a, b] = e^M·(1 − e^(−d))/d. M is the larger argument, and d = |b − a|.
#[inline(always)]
pub fn exp<R: Real>(a: R, b: R) -> R {
    let gap = -((b - a).abs() + tiny());
    a.max(b).exp() * (gap.exp_m1() / gap)
}

/// Returns ∂exp[a, b]/∂b = e^b φ₂(a − b) with φ₂(z) = (e^z − 1 − z)/z².
#[inline(always)]
pub fn exp_derivative<R: Real>(a: R, b: R) -> R {
    let end = b.exp();
    let small = |z: R| end * by_pairs(z, series!(17, |k| 1.0 / factorial(k + 2)));
    // Uses e^a, because e^z may overflow although e^a and e^b do not.
    let large = || {
        let z = away(a - b);
        (a.exp() - end - z * end) / z / z
    };
    either(a - b, 1.0, small, large)
}

/// Returns 2ˣ[a, b] = 2^M·(1 − 2^(−d))/d. M is the larger argument, and d = |b − a|. The form exp(x ln 2) would have the rounding error of x ln 2.
#[inline(always)]
pub fn exp2<R: Real>(a: R, b: R) -> R {
    let gap = -((b - a).abs() + tiny());
    a.max(b).exp2() * ((gap * R::from_f64(core::f64::consts::LN_2)).exp_m1() / gap)
}

/// Returns ln[a, b] = log1p((M − m)/m)/(M − m). m is the smaller argument, and M the larger one. For near arguments the formula is artanh(w)/(w c) with
/// the mean c and w = (b − a)/2c.
#[inline(always)]
pub fn ln<R: Real>(a: R, b: R) -> R {
    let one = R::from_f64(1.0);
    let (inverse, w) = apart(a, b);
    let large = || {
        let m = a.min(b);
        let t = (b - a).abs() / m + tiny();
        t.ln_1p() / t * recip_positive(m)
    };
    let small = |w: R| {
        let square = w * w;
        inverse * square.multiply_add(artanh(square), one)
    };
    let farther = |w: R| {
        let square = w * w;
        inverse * square.multiply_add(polynomial(square, series!(14, |k| 1.0 / (2 * k + 3) as f64)), one)
    };
    either(w, NEAR, small, || either(w, FARTHER, farther, large))
}

/// Returns ∂ln[a, b]/∂b = (1/b − ln[a, b])/(b − a).
#[inline(always)]
pub fn ln_derivative<R: Real>(a: R, b: R) -> R {
    let one = R::from_f64(1.0);
    let large = || (one / b - ln(a, b)) / away(b - a);
    // From ln(b/a) = 2 artanh w.
    let small = |w: R| {
        let square = w * w;
        R::from_f64(-0.5) * (one + w) * (square + w).multiply_add(artanh(square), one) / (b * b)
    };
    either(apart(a, b).1, NEAR, small, large)
}

/// Returns 1/c and w = (b − a)/2c with the mean c. The sum a + b may overflow. The results are NaN if c is not positive.
#[inline(always)]
fn apart<R: Real>(a: R, b: R) -> (R, R) {
    let half = R::from_f64(0.5);
    let inverse = recip_positive(half * a + half * b);
    (inverse, half * (b - a) * inverse)
}

/// The short series of artanh is used for |w| up to this bound.
const NEAR: f64 = 0.125;

/// The long series of artanh is used for |w| up to this bound. With a library logarithm in this range, the invariant of the Lotka–Volterra equations
/// drifts by up to 3·10⁻²⁰ per step.
const FARTHER: f64 = 0.25;

/// Returns (artanh(w)/w − 1)/w² = Σ w²ᵏ/(2k + 3) from `square` = w² ≤ 1/64. [`ln`] and [`ln_derivative`] share it. The terms are summed in pairs, which
/// shortens the chain of dependent operations.
#[inline(always)]
fn artanh<R: Real>(square: R) -> R {
    let pair = |k: usize| {
        let [first, second] = [0, 1].map(|i| R::from_f64(1.0 / (2 * (k + i) + 3) as f64));
        second.multiply_add(square, first)
    };
    let fourth = square * square;
    let eighth = fourth * fourth;
    let (low, high) = (pair(2).multiply_add(fourth, pair(0)), pair(6).multiply_add(fourth, pair(4)));
    pair(8).multiply_add(eighth, high).multiply_add(eighth, low)
}

/// Returns (xʳ)[a, b] = M^r·(1 − (m/M)^r)/(M − m). m is the smaller argument, and M the larger one. For r < 0 the factor is m^r. Precondition: both
/// arguments are not negative.
#[inline(always)]
pub fn powf<R: Real>(a: R, b: R, r: R) -> R {
    let (low, high) = (a.min(b), a.max(b) + tiny());
    let gap = (b - a).abs() + high * R::from_f64(R::epsilon() * R::epsilon()) + tiny();
    let exponent = r * (gap / low).ln_1p();
    // The larger one of both powers is the factor.
    if r.any_below(0.0) {
        low.powf(r) * (exponent.exp_m1() / gap)
    } else {
        high.powf(r) * (-(-exponent).exp_m1() / gap)
    }
}

/// Returns ∂(xʳ)[a, b]/∂b = (r b^(r−1) − (xʳ)[a, b])/(b − a).
#[inline(always)]
pub fn powf_derivative<R: Real>(a: R, b: R, r: R) -> R {
    let [one, two] = [1.0, 2.0].map(R::from_f64);
    let base = b + tiny();
    let large = || (r * base.powf(r - one) - powf(a, b, r)) / away(b - a);
    // The binomial series Σ C(r, k + 2) sᵏ.
    let small = |s: R| {
        let mut sum = R::from_f64(0.0);
        for k in (2..28).rev() {
            let k = R::from_f64(k as f64);
            sum = one + (r - k) / (k + one) * s * sum;
        }
        r * (r - one) / two * sum * base.powf(r - two)
    };
    either((a - b) / base, 0.25, small, large)
}

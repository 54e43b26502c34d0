//! Exponentials, logarithms and powers.

use super::{away, by_pairs, either, factorial, polynomial, recip_positive, series, tiny};
use crate::scalar::Real;

/// exp[a, b] = e^M·(1 − e^(−d))/d, M the larger argument, d = |b − a|.
#[inline(always)]
pub fn exp<R: Real>(a: R, b: R) -> R {
    let gap = -((b - a).abs() + tiny());
    a.max(b).exp() * (gap.exp_m1() / gap)
}

/// ∂exp[a, b]/∂b = e^b φ₂(a − b), φ₂(z) = (e^z − 1 − z)/z².
#[inline(always)]
pub fn exp_derivative<R: Real>(a: R, b: R) -> R {
    let end = b.exp();
    let small = |z: R| end * by_pairs(z, series!(17, |k| 1.0 / factorial(k + 2)));
    // Not with e^z, which may overflow where e^a and e^b do not.
    let large = || {
        let z = away(a - b);
        (a.exp() - end - z * end) / z / z
    };
    either(a - b, 1.0, small, large)
}

/// 2ˣ[a, b], in the same way. (The slope of exp(x ln 2) would round x ln 2.)
#[inline(always)]
pub fn exp2<R: Real>(a: R, b: R) -> R {
    let gap = -((b - a).abs() + tiny());
    a.max(b).exp2() * ((gap * R::from_f64(core::f64::consts::LN_2)).exp_m1() / gap)
}

/// ln[a, b] = log1p((M − m)/m)/(M − m), m the smaller and M the larger argument; near each other artanh(w)/(w c) with their
/// mean c and w = (b − a)/2c.
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

/// ∂ln[a, b]/∂b = (1/b − ln[a, b])/(b − a).
#[inline(always)]
pub fn ln_derivative<R: Real>(a: R, b: R) -> R {
    let one = R::from_f64(1.0);
    let large = || (one / b - ln(a, b)) / away(b - a);
    // With ln(b/a) = 2 artanh w.
    let small = |w: R| {
        let square = w * w;
        R::from_f64(-0.5) * (one + w) * (square + w).multiply_add(artanh(square), one) / (b * b)
    };
    either(apart(a, b).1, NEAR, small, large)
}

/// 1/c and w = (b − a)/2c with the mean c, of numbers of which the sum may overflow; not numbers where c is not positive.
#[inline(always)]
fn apart<R: Real>(a: R, b: R) -> (R, R) {
    let half = R::from_f64(0.5);
    let inverse = recip_positive(half * a + half * b);
    (inverse, half * (b - a) * inverse)
}

/// Up to which w the series of artanh is taken.
const NEAR: f64 = 0.125;

/// Up to which it is taken with more terms. With the logarithm of a library there, what predators and prey keep drifted by up to 3·10⁻²⁰ a
/// step.
const FARTHER: f64 = 0.25;

/// (artanh(w)/w − 1)/w² = Σ w²ᵏ/(2k + 3), w² ≤ 1/64: common to both functions, so that it is computed once where both are. Pairs of terms
/// side by side: Horner's rule is a chain twice as long.
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

/// (xʳ)[a, b] = M^r·(1 − (m/M)^r)/(M − m), based on m if r < 0; m is the smaller and M the larger argument, neither is
/// negative.
#[inline(always)]
pub fn powf<R: Real>(a: R, b: R, r: R) -> R {
    let (low, high) = (a.min(b), a.max(b) + tiny());
    let gap = (b - a).abs() + high * R::from_f64(R::epsilon() * R::epsilon()) + tiny();
    let exponent = r * (gap / low).ln_1p();
    // The base on which the quotient of both powers is below 1.
    if r.any_below(0.0) {
        low.powf(r) * (exponent.exp_m1() / gap)
    } else {
        high.powf(r) * (-(-exponent).exp_m1() / gap)
    }
}

/// ∂(xʳ)[a, b]/∂b = (r b^(r−1) − (xʳ)[a, b])/(b − a).
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

//! Motion about a centre under a force k/|y|³, with an oscillator: what is not elementary operations alone.
//!
//! With a = |y(0)|, ε = y·y'/a² and κ = (ℓ² + k)/a⁴ at the start, C = cos ωh and S = sin ωh/ω, |y(h)|/a is √(x² + κS²) for x = C + εS: an
//! ellipse, a line or a hyperbola is gone through about the centre.

use super::tiny;
use crate::scalar::Real;
use core::f64::consts::PI;

/// √(x² + κs²) for s = sin ωh/ω and ω²; NaN if the centre is met before h: for κ ≤ 0 the motion ends there, within half a period.
#[inline(always)]
pub fn spread<R: Real>(x: R, s: R, kappa: R, square: R, h: R) -> R {
    let (zero, half) = (R::from_f64(0.0), R::from_f64(PI));
    let root = (kappa * s).multiply_add(s, x * x).sqrt();
    // What has not ended has x > 0 and has not come to half a period.
    let left = x.min(half * half - square * h * h);
    let ended = || R::choose(zero.less(left), || [root], || [R::from_f64(f64::NAN)]);
    let [value] = R::choose(zero.less(kappa), || [root], ended);
    value
}

/// ∫₀ʰ dt/(x² + κs²), at whose end x and s are given: atan(√κ s/x)/√κ, and as many half turns as ωh has made.
#[inline(always)]
pub fn swept<R: Real>(x: R, s: R, kappa: R, square: R, h: R) -> R {
    let (zero, half) = (R::from_f64(0.0), R::from_f64(PI));
    let rate = kappa.abs().sqrt() + tiny();
    let side = rate * s;
    let inward = || [(side / x).atanh() / rate];
    let [value] = R::choose(
        zero.less(kappa),
        || {
            let angle = square.max(zero).sqrt() * h;
            // Both angles are in the same half turn.
            let beyond = || {
                let (sine, cosine) = angle.sin_cos();
                let ahead = (side * cosine - x * sine).atan2(x * cosine + side * sine);
                [(angle + ahead) / rate]
            };
            R::choose(angle.abs().less(half), || [side.atan2(x) / rate], beyond)
        },
        inward,
    );
    value
}

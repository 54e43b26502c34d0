//! Motion about a centre under a force k/|y|³ and a harmonic force: radius and swept angle, without cancellation and 0/0.
//!
//! Let a = |y(0)|, ε = y·y'/a² and κ = (ℓ² + k)/a⁴ at the start, with the angular momentum ℓ, and C = cos ωh, S = sin ωh/ω. Then
//! |y(h)|/a = √(x² + κS²) with x = C + εS. Each sign of ω² is possible.

use super::tiny;
use crate::scalar::Real;
use core::f64::consts::PI;

/// Returns √(x² + κs²) with s = sin ωh/ω and `square` = ω². NaN if the motion reaches the centre before h. This is possible for κ ≤ 0, within half a
/// period.
#[inline(always)]
pub fn spread<R: Real>(x: R, s: R, kappa: R, square: R, h: R) -> R {
    let (zero, half) = (R::from_f64(0.0), R::from_f64(PI));
    let root = (kappa * s).multiply_add(s, x * x).sqrt();
    // The motion has not ended if x > 0 and ωh < π.
    let left = x.min(half * half - square * h * h);
    let ended = || R::choose(zero.less(left), || [root], || [R::from_f64(f64::NAN)]);
    let [value] = R::choose(zero.less(kappa), || [root], ended);
    value
}

/// Returns ∫₀ʰ dt/(x² + κs²) from x and s at time h: atan(√κ s/x)/√κ, plus the half turns of ωh.
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
            // The angle minus ωh is within half a turn.
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

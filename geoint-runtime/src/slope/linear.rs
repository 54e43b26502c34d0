//! Linear flows in two degrees of freedom: x' = Mx with M = JS, whose square N has N² = −bN − c.
//!
//! Let z₁ and z₂ be the roots of z² + bz + c. They may have any sign, be equal, or be complex. The functions below interpolate S(z) = sinh √z/√z and
//! D(z) = (cosh √z − 1)/z linearly at both roots. The interpolating lines equal S and D modulo z² + bz + c. The line of D is given by its value at
//! z₁ + z₂ = −b, because its value at 0 would suffer from cancellation if one root is large.
//!
//! The results are NaN if an angle is so large that it has no correct digit.

use super::{factorial, series, stumpff_c1};
use crate::scalar::Real;

/// The polynomial u + v·z modulo z² + bz + c.
type Line<R> = [R; 2];

fn times<R: Real>([u, v]: Line<R>, [x, y]: Line<R>, [b, c]: [R; 2]) -> Line<R> {
    let square = v * y;
    [u * x - c * square, u * y + v * x - b * square]
}

/// Returns the value at 0 and the slope of the line of S, and the value at −b and the slope of the line of D.
fn lines<R: Real>(b: R, c: R) -> [R; 4] {
    let [sixteenth, quarter] = [0.0625, 0.25].map(R::from_f64);
    let discriminant = quarter * b * b - c;
    let apart = (sixteenth * b * b).less(discriminant) & quarter.less(discriminant);
    R::choose(apart, || by_roots(b, c, discriminant), || by_series(b, c))
}

/// Computes the lines from the values at both roots. Precondition: the roots are real and not near each other.
fn by_roots<R: Real>(b: R, c: R, discriminant: R) -> [R; 4] {
    let [half, quarter] = [0.5, 0.25].map(R::from_f64);
    // The larger root is computed first, without cancellation.
    let large = -(half * b + b.signum() * discriminant.sqrt());
    let small = c / large;
    let line = |of: &dyn Fn(R) -> R| {
        let [at_large, at_small] = [of(large), of(small)];
        (at_large, at_small, (at_large - at_small) / (large - small))
    };
    let (_, s, t) = line(&|z| stumpff_c1(-z));
    let (d, _, e) = line(&|z| {
        let sine = stumpff_c1(-quarter * z);
        half * sine * sine
    });
    let known = large.abs().less(R::from_f64(1.0 / (R::epsilon() * R::epsilon())));
    R::choose(known, || [s - small * t, t, d + small * e, e], || [R::from_f64(f64::NAN); 4])
}

/// Computes the lines by series, without a division by z₁ − z₂. z is divided by 4 until it is small. Then S(4z) = S (1 + zD) and D(4z) = S²/2 give the
/// result.
fn by_series<R: Real>(b: R, c: R) -> [R; 4] {
    let [zero, one, half, quarter] = [0.0, 1.0, 0.5, 0.25].map(R::from_f64);
    if !((b * zero).magnitude() == 0.0 && (c * zero).magnitude() == 0.0) {
        let none = b * zero + c * zero;
        return [none; 4];
    }
    let (mut roots, mut quarters, mut unknown) = ([b, c], 0_u32, R::epsilon());
    while roots[0].magnitude() > 0.5 || roots[1].magnitude() > 0.25 {
        roots = [roots[0] * quarter, roots[1] * quarter * quarter];
        quarters += 1;
        // Each doubling of the angle multiplies the error of its cosine by 4.
        unknown *= 4.0;
    }
    if unknown > 1.0 {
        return [R::from_f64(f64::NAN); 4];
    }
    let z = [zero, one];
    let sum = |coefficients: &[f64]| {
        coefficients.iter().rev().fold([zero; 2], |sum, c| {
            let [u, v] = times(sum, z, roots);
            [u + R::from_f64(*c), v]
        })
    };
    let mut s = sum(series!(10, |k| 1.0 / factorial(2 * k + 1)));
    let mut d = sum(series!(10, |k| 1.0 / factorial(2 * k + 2)));
    for _ in 0..quarters {
        let [u, v] = times(d, z, roots);
        let (next, [x, y]) = (times(s, [one + u, v], roots), times(s, s, roots));
        s = [next[0], quarter * next[1]];
        d = [half * x, half * quarter * y];
        roots = [roots[0] / quarter, roots[1] / quarter / quarter];
    }
    [s[0], s[1], d[0] - b * d[1], d[1]]
}

/// Returns the value at z = 0 of the line of S.
pub fn sine_at<R: Real>(b: R, c: R) -> R {
    lines(b, c)[0]
}

/// Returns the slope of the line of S.
pub fn sine_slope<R: Real>(b: R, c: R) -> R {
    lines(b, c)[1]
}

/// Returns the value at z = −b of the line of D.
pub fn cosine_at<R: Real>(b: R, c: R) -> R {
    lines(b, c)[2]
}

/// Returns the slope of the line of D.
pub fn cosine_slope<R: Real>(b: R, c: R) -> R {
    lines(b, c)[3]
}

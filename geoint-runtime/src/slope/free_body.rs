//! The flow of a free rigid body: r' = ½ r⊗(0, ω), m' = m × ω with ω = Jm + b.
//!
//! r is the attitude, m the angular momentum in the frame of the body, and ω the angular velocity. A quaternion is stored as (i, j, k, w). It rotates
//! vectors from the frame of the body to the frame of space. A momentum is stored with a fourth number, which is zero.

use crate::scalar::{Real, signed, zero};
use crate::slope::before_squares;

/// Angles in radians. Up to them, series with 12, 14 and 18 terms are accurate to rounding.
const TURNS: [f64; 3] = [0.1, 0.2, 0.4];

/// A rotation that needs more than this number of parts gives NaN.
const MOST_PARTS: u32 = 1 << 16;

/// Returns the increments of attitude and momentum by a free rotation. `linear` returns h·Jm, and `constant` is h·b.
///
/// The method is a Taylor series. m' and r' are quadratic, so the coefficients are sums of products. It is valid for each J and each motion, also on the
/// separatrix of Euler's equations. Angles above 0.4 radians are divided into equal parts.
#[inline]
pub fn free_rotation<R: Real>(
    linear: impl Fn(&[R; 3]) -> [R; 3],
    constant: &[R; 3],
    r: &[R; 4],
    momentum: &[R; 4],
) -> [[R; 4]; 2] {
    let m = [momentum[0], momentum[1], momentum[2]];
    let turn = turn(&linear, constant, &m);
    // NaN gives NaN.
    let mut parts = if turn <= TURNS[2] || turn.is_nan() { 1 } else { ceiling(turn / TURNS[2]) };
    while parts <= MOST_PARTS {
        if let Some(increments) = in_parts(parts, &linear, constant, (r, &m), turn) {
            return increments;
        }
        parts *= 2;
    }
    [[R::from_f64(f64::NAN); 4]; 2]
}

/// Returns the increments of attitude and momentum by a free rotation of a symmetric body, in closed form.
///
/// Two moments of inertia are equal. The motion consists of a rotation about the momentum, which is constant in space, and a rotation about the third
/// axis, `axis`. `across` is h over the equal moments, and `along` is h over the third one.
#[inline]
pub fn symmetric_rotation<R: Real>(axis: usize, [across, along]: [R; 2], r: &[R; 4], momentum: &[R; 4]) -> [[R; 4]; 2] {
    let half = R::from_f64(0.5);
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let m = [momentum[0], momentum[1], momentum[2]];
    // `first` = exp(½ m·h/I) − 1 and `second` = exp(½ e·β) − 1, with the third axis e and its angle β.
    let half_across = half * across;
    let unit = before_squares(R::from_f64(m.iter().fold(0.0, |size, x| size + x.magnitude())));
    let [x, y, z] = m.map(|x| unit * x);
    let length = (x * x + y * y + z * z).sqrt() / unit;
    let (sine, cosine) = (half_across * length).sin_cos();
    let scale = if length.magnitude() > 0.0 { sine / length } else { half_across };
    let first = [scale * m[0], scale * m[1], scale * m[2], less_one(sine, cosine)];
    let (sine, cosine) = (half * (along - across) * m[axis]).sin_cos();
    let mut second = [zero(); 4];
    (second[axis], second[3]) = (sine, less_one(sine, cosine));
    let product = quaternion_product(&first, &second);
    let turn = core::array::from_fn(|i| first[i] + second[i] + product[i]);
    // The momentum turns by twice the angle in the quaternion.
    let [sine, versine] = [R::from_f64(2.0) * sine * cosine, R::from_f64(2.0) * sine * sine];
    let mut change = [zero(); 4];
    (change[j], change[k]) = (sine * m[k] - versine * m[j], -(sine * m[j]) - versine * m[k]);
    [quaternion_product(r, &turn), change]
}

/// Returns cos − 1 without cancellation.
#[inline(always)]
fn less_one<R: Real>(sine: R, cosine: R) -> R {
    let one = R::from_f64(1.0);
    if signed(cosine) > 0.0 { -(sine * sine) / (one + cosine) } else { cosine - one }
}

#[inline(always)]
fn quaternion_product<R: Real>(a: &[R; 4], b: &[R; 4]) -> [R; 4] {
    let [[x, y, z, w], [i, j, k, l]] = [*a, *b];
    [
        w * i + x * l + (y * k - z * j),
        w * j + y * l + (z * i - x * k),
        w * k + z * l + (x * j - y * i),
        w * l - (x * i + y * j + z * k),
    ]
}

fn ceiling(x: f64) -> u32 {
    // Saturates.
    (x as u32).saturating_add(1)
}

/// Returns an estimate of the angle of rotation: the maximum of h|ω| and h√|ω'|.
#[inline(always)]
fn turn<R: Real>(linear: &impl Fn(&[R; 3]) -> [R; 3], constant: &[R; 3], m: &[R; 3]) -> f64 {
    let w = add(&linear(m), constant);
    let change = linear(&cross(m, &w));
    let square = |v: &[R; 3]| (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).magnitude();
    let (rate, change) = (square(&w), Real::sqrt(square(&change)));
    Real::sqrt(if change > rate { change } else { rate })
}

/// Returns the increments of a rotation in equal parts, or `None` if a series has not converged to rounding.
#[inline(always)]
fn in_parts<R: Real>(
    parts: u32,
    linear: &impl Fn(&[R; 3]) -> [R; 3],
    constant: &[R; 3],
    (r, m): (&[R; 4], &[R; 3]),
    turn: f64,
) -> Option<[[R; 4]; 2]> {
    let each = turn / f64::from(parts);
    if parts == 1 {
        return series_for(each, linear, constant, r, m);
    }
    let part = R::from_f64(1.0 / f64::from(parts));
    let (linear, constant) = (|m: &[R; 3]| linear(m).map(|x| x * part), constant.map(|x| x * part));
    let (mut sum, mut here, mut momentum) = ([[zero(); 4]; 2], *r, *m);
    for _ in 0..parts {
        let increments = series_for(each, &linear, &constant, &here, &momentum)?;
        for (sum, increment) in sum.iter_mut().zip(&increments) {
            *sum = core::array::from_fn(|i| sum[i] + increment[i]);
        }
        here = core::array::from_fn(|i| r[i] + sum[0][i]);
        momentum = core::array::from_fn(|i| m[i] + sum[1][i]);
    }
    Some(sum)
}

/// Returns the increments by a series. The number of terms depends on the angle `turn`.
#[inline(always)]
fn series_for<R: Real>(
    turn: f64,
    linear: &impl Fn(&[R; 3]) -> [R; 3],
    constant: &[R; 3],
    r: &[R; 4],
    m: &[R; 3],
) -> Option<[[R; 4]; 2]> {
    if turn <= TURNS[0] {
        series::<R, 12>(linear, constant, r, m)
    } else if turn <= TURNS[1] {
        series::<R, 14>(linear, constant, r, m)
    } else {
        series::<R, 18>(linear, constant, r, m)
    }
}

/// Returns the increments by a series of N terms, or `None` if the last term is larger than rounding.
#[inline(always)]
fn series<R: Real, const N: usize>(
    linear: &impl Fn(&[R; 3]) -> [R; 3],
    constant: &[R; 3],
    r: &[R; 4],
    m: &[R; 3],
) -> Option<[[R; 4]; 2]> {
    let start = [r[0], r[1], r[2], r[3], m[0], m[1], m[2], zero()];
    let (mut terms, mut axes, mut turns) = ([[zero::<R>(); 8]; N], [[[zero::<R>(); 8]; 3]; N], [[zero::<R>(); 3]; N]);
    let mut last = start;
    for n in 0..N {
        (terms[n], axes[n]) = (last, about_axes(&last));
        turns[n] = linear(&[last[4], last[5], last[6]]);
        if n == 0 {
            turns[0] = add(&turns[0], constant);
        }
        let mut sum = [zero::<R>(); 8];
        for k in 0..=n {
            let ([a, b, c], [x, y, z]) = (&axes[k], turns[n - k]);
            for i in 0..8 {
                // Only the last addition depends on the previous iteration.
                sum[i] += a[i].multiply_add(x, b[i].multiply_add(y, c[i] * z));
            }
        }
        let [whole, half] = [1.0, 0.5].map(|x| R::from_f64(x / (n + 1) as f64));
        for i in 0..8 {
            last[i] = if i < 4 { half } else { whole } * sum[i];
        }
    }
    let size = |v: &[R]| v.iter().map(|x| x.magnitude()).fold(0.0, |largest, x| if x > largest { x } else { largest });
    if size(&last[..4]) > R::epsilon() * size(r) || size(&last[4..]) > R::epsilon() * size(m) {
        return None;
    }
    // The smallest terms first.
    for n in (1..N).rev() {
        for i in 0..8 {
            last[i] += terms[n][i];
        }
    }
    Some([[last[0], last[1], last[2], last[3]], [last[4], last[5], last[6], zero()]])
}

/// Returns r⊗e and m × e for the three axes e of the body.
#[inline(always)]
fn about_axes<R: Real>(&[x, y, z, w, a, b, c, _]: &[R; 8]) -> [[R; 8]; 3] {
    let o = zero();
    [[w, z, -y, -x, o, c, -b, o], [-z, w, x, -y, -c, o, a, o], [y, -x, w, -z, b, -a, o, o]]
}

/// Applies five rotations about the principal axes of a body, in the order 1, 2, 3, 2, 1. All but the third one have half of the length.
///
/// The result approximates the flow of a free body. It has order 2, and is symmetric and symplectic. `inverse` is h over the moments of inertia.
///
/// A. Dullweber, B. Leimkuhler & R. McLachlan, J. Chem. Phys. 107 (1997) 5840.
#[inline(always)]
pub fn five_rotations<R: Real>(inverse: &[R; 3], r: &mut [R; 4], m: &mut [R; 4]) {
    let half = R::from_f64(0.5);
    for (axis, part) in [(0, half), (1, half), (2, R::from_f64(1.0)), (1, half), (0, half)] {
        let angle = part * inverse[axis] * m[axis];
        // Larger angles have no correct digit modulo 2π.
        let known = angle.abs().less(R::from_f64(1.0 / R::epsilon()));
        let [angle] = R::choose(known, || [angle], || [R::from_f64(f64::NAN)]);
        rotate(axis, angle, r, m);
    }
}

/// Rotates the body about one of its axes.
#[inline(always)]
fn rotate<R: Real>(axis: usize, angle: R, r: &mut [R; 4], m: &mut [R; 4]) {
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    // Increments with cos − 1: for small angles, a rounded cosine has the same rounding error in many steps, and lengths would drift.
    let (sine, cosine) = (R::from_f64(0.5) * angle).sin_cos();
    let less = less_one(sine, cosine);
    // r⊗(cos + sin e).
    let (along, w, rj, rk) = (r[axis], r[3], r[j], r[k]);
    r[axis] = along + less.multiply_add(along, sine * w);
    r[3] = w + less.multiply_add(w, -(sine * along));
    r[j] = rj + less.multiply_add(rj, sine * rk);
    r[k] = rk + less.multiply_add(rk, -(sine * rj));
    // The momentum turns by twice the angle in the quaternion.
    let double = R::from_f64(2.0) * sine;
    let [sine, less] = [double * cosine, -(double * sine)];
    (m[j], m[k]) = (m[j] + less.multiply_add(m[j], sine * m[k]), m[k] + less.multiply_add(m[k], -(sine * m[j])));
}

#[inline(always)]
fn cross<R: Real>(a: &[R; 3], b: &[R; 3]) -> [R; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline(always)]
fn add<R: Real>(a: &[R; 3], b: &[R; 3]) -> [R; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

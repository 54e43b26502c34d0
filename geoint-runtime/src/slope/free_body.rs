//! The flow of a free rigid body: r' = ½ r⊗(0, ω), m' = m × ω with ω = Jm + b.
//!
//! Quaternions are (i, j, k, w), and turn vectors of the body into vectors of space; momenta are those of the body's frame, with a fourth
//! number that is zero.

use crate::scalar::{Real, zero};

/// Turns, in radians, up to which series of so many terms are exact to rounding.
const TURNS: [f64; 3] = [0.1, 0.2, 0.4];

/// More parts than these are no step that anybody wants.
const MOST_PARTS: u32 = 1 << 16;

/// What a free rotation adds to the attitude and to the momentum; `linear` is h·Jm, `constant` is h·b.
///
/// By Taylor series: m' and r' are quadratic, so that coefficients follow from sums of products. The flow of every J and every motion, on
/// the separatrix of Euler's equations as elsewhere. Up to 0.4 radians at once, in equal parts beyond.
#[inline]
pub fn free_rotation<R: Real>(
    linear: impl Fn(&[R; 3]) -> [R; 3],
    constant: &[R; 3],
    r: &[R; 4],
    momentum: &[R; 4],
) -> [[R; 4]; 2] {
    let m = [momentum[0], momentum[1], momentum[2]];
    let turn = turn(&linear, constant, &m);
    // What is not a number leads to what is none.
    let mut parts = if turn <= TURNS[2] || turn.is_nan() { 1 } else { ceiling(turn / TURNS[2]) };
    while parts <= MOST_PARTS {
        if let Some(increments) = in_parts(parts, &linear, constant, (r, &m), turn) {
            return increments;
        }
        parts *= 2;
    }
    [[R::from_f64(f64::NAN); 4]; 2]
}

fn ceiling(x: f64) -> u32 {
    // Saturates.
    (x as u32).saturating_add(1)
}

/// About how far the body turns: by its angular velocity, or by what that becomes.
#[inline(always)]
fn turn<R: Real>(linear: &impl Fn(&[R; 3]) -> [R; 3], constant: &[R; 3], m: &[R; 3]) -> f64 {
    let w = add(&linear(m), constant);
    let change = linear(&cross(m, &w));
    let square = |v: &[R; 3]| (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).magnitude();
    let (rate, change) = (square(&w), square(&change).sqrt());
    f64::sqrt(if change > rate { change } else { rate })
}

/// The flow in equal parts; nothing if the last term of a series is more than rounding.
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

/// As many terms as the angle needs.
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

/// N terms.
#[inline(always)]
fn series<R: Real, const N: usize>(
    linear: &impl Fn(&[R; 3]) -> [R; 3],
    constant: &[R; 3],
    r: &[R; 4],
    m: &[R; 3],
) -> Option<[[R; 4]; 2]> {
    let (mut rs, mut ms, mut ws) = ([[zero::<R>(); 4]; N], [[zero::<R>(); 3]; N], [[zero::<R>(); 3]; N]);
    let (mut last_r, mut last_m) = (*r, *m);
    for n in 0..N {
        (rs[n], ms[n]) = (last_r, last_m);
        ws[n] = linear(&last_m);
        if n == 0 {
            ws[0] = add(&ws[0], constant);
        }
        let (mut turned, mut moved) = ([zero::<R>(); 4], [zero::<R>(); 3]);
        for k in 0..=n {
            let ([x, y, z, w], m, [a, b, c]) = (rs[k], ms[k], ws[n - k]);
            turned[0] = w.multiply_add(a, y.multiply_add(c, (-z).multiply_add(b, turned[0])));
            turned[1] = w.multiply_add(b, z.multiply_add(a, (-x).multiply_add(c, turned[1])));
            turned[2] = w.multiply_add(c, x.multiply_add(b, (-y).multiply_add(a, turned[2])));
            turned[3] = (-x).multiply_add(a, (-y).multiply_add(b, (-z).multiply_add(c, turned[3])));
            moved[0] = m[1].multiply_add(c, (-m[2]).multiply_add(b, moved[0]));
            moved[1] = m[2].multiply_add(a, (-m[0]).multiply_add(c, moved[1]));
            moved[2] = m[0].multiply_add(b, (-m[1]).multiply_add(a, moved[2]));
        }
        let over = R::from_f64(1.0 / (n + 1) as f64);
        let half = R::from_f64(0.5 / (n + 1) as f64);
        (last_r, last_m) = (turned.map(|x| half * x), moved.map(|x| over * x));
    }
    let size = |v: &[R]| v.iter().map(|x| x.magnitude()).fold(0.0, |largest, x| if x > largest { x } else { largest });
    if size(&last_r) > R::epsilon() * size(r) || size(&last_m) > R::epsilon() * size(m) {
        return None;
    }
    // The smallest terms first.
    let (mut dr, mut dm) = (last_r, [last_m[0], last_m[1], last_m[2], zero()]);
    for n in (1..N).rev() {
        dr = core::array::from_fn(|i| dr[i] + rs[n][i]);
        for i in 0..3 {
            dm[i] += ms[n][i];
        }
    }
    Some([dr, dm])
}

/// Five rotations about the principal axes of a body, 1, 2, 3, 2, 1, of which all but the third are half as long: the flow of a free body
/// to order 2, symmetric and symplectic; `inverse` are h over the moments of inertia.
///
/// A. Dullweber, B. Leimkuhler & R. McLachlan, J. Chem. Phys. 107 (1997) 5840.
#[inline(always)]
pub fn five_rotations<R: Real>(inverse: &[R; 3], r: &mut [R; 4], m: &mut [R; 4]) {
    let half = R::from_f64(0.5);
    for (axis, part) in [(0, half), (1, half), (2, R::from_f64(1.0)), (1, half), (0, half)] {
        let angle = part * inverse[axis] * m[axis];
        rotate(axis, angle, r, m);
    }
}

/// A rotation of the body about one of its axes.
#[inline(always)]
fn rotate<R: Real>(axis: usize, angle: R, r: &mut [R; 4], m: &mut [R; 4]) {
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let (sin, cos) = angle.sin_cos();
    (m[j], m[k]) = (cos.multiply_add(m[j], sin * m[k]), cos.multiply_add(m[k], -(sin * m[j])));
    let (sin, cos) = (R::from_f64(0.5) * angle).sin_cos();
    // r⊗(cos + sin e).
    let (along, w, rj, rk) = (r[axis], r[3], r[j], r[k]);
    r[axis] = cos.multiply_add(along, sin * w);
    r[3] = cos.multiply_add(w, -(sin * along));
    r[j] = cos.multiply_add(rj, sin * rk);
    r[k] = cos.multiply_add(rk, -(sin * rj));
}

#[inline(always)]
fn cross<R: Real>(a: &[R; 3], b: &[R; 3]) -> [R; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline(always)]
fn add<R: Real>(a: &[R; 3], b: &[R; 3]) -> [R; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

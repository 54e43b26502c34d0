//! The fast method for Kepler's equation: a fixed number of iterations for several orbits at a time, without branches, for SIMD registers.

use super::orbit::{Functions, Orbit, RADIUS, unless};
use super::{SMALL, STRAIGHT};
use crate::scalar::{Real, zero};

/// The number of evaluations of the functions G.
const EVALUATIONS: usize = 3;

/// The number of doubles in a SIMD register of the processor. The length of a group of five or more orbits is a multiple of it.
const WIDTH: usize = if cfg!(any(target_feature = "avx", target_feature = "avx512f")) { 4 } else { 2 };

/// Computes N orbits. Returns whether all of them have converged. See [`kepler`](super::kepler).
#[inline(always)]
pub(super) fn kepler<R: Real, const N: usize>(orbits: &[[R; N]; 5], ends: &mut [[R; N]; 4]) -> bool {
    match N {
        0 | 1 => padded::<R, N, 1>(orbits, ends),
        2 => padded::<R, N, 2>(orbits, ends),
        3 | 4 => padded::<R, N, 4>(orbits, ends),
        5 | 6 if WIDTH == 2 => padded::<R, N, 6>(orbits, ends),
        _ => padded::<R, N, 8>(orbits, ends),
    }
}

/// Computes groups of W orbits. The last group is filled up with copies of the last orbit.
#[inline(always)]
fn padded<R: Real, const N: usize, const W: usize>(orbits: &[[R; N]; 5], ends: &mut [[R; N]; 4]) -> bool {
    let mut known = true;
    for first in (0..N).step_by(W) {
        let mut given = [[zero(); W]; 5];
        for (given, orbits) in given.iter_mut().zip(orbits) {
            for lane in 0..W {
                given[lane] = orbits[(first + lane).min(N - 1)];
            }
        }
        let mut of_group = [[zero(); W]; 4];
        known &= group(&given, &mut of_group);
        for (ends, of_group) in ends.iter_mut().zip(&of_group) {
            let lanes = W.min(N - first);
            ends[first..first + lanes].copy_from_slice(&of_group[..lanes]);
        }
    }
    known
}

/// Computes one group of W orbits, with one row for each quantity. The loops over orbits are short and have no branches, so the processor can overlap
/// their iterations.
#[inline(never)]
fn group<R: Real, const W: usize>(given: &[[R; W]; 5], ends: &mut [[R; W]; 4]) -> bool {
    let [mut r, mut recip, mut beta, mut zeta, mut x, mut straight] = [[zero::<R>(); W]; 6];
    let [square, eta, speed, mu, h] = given;
    for i in 0..W {
        let orbit = Orbit::new([square[i], eta[i], speed[i], mu[i], h[i]]);
        (r[i], recip[i], beta[i], zeta[i]) = (orbit.r, orbit.recip, orbit.beta, orbit.zeta);
        let sine = eta[i].multiply_add(eta[i], -(square[i] * speed[i]) * R::from_f64(1.0 - STRAIGHT * R::epsilon()));
        // A body at rest counts as straight.
        straight[i] = unless(sine.less(zero()));
    }
    let orbit =
        |i: usize| Orbit { r: r[i], recip: recip[i], eta: eta[i], beta: beta[i], zeta: zeta[i], mu: mu[i], h: h[i] };
    for i in 0..W {
        x[i] = orbit(i).first_guess();
    }
    for _ in 0..EVALUATIONS {
        let [mut g0, mut g1, mut g2, mut g3, mut change, mut doubt] = [[zero::<R>(); W]; 6];
        for i in 0..W {
            Functions([g0[i], g1[i], g2[i], g3[i]]) = orbit(i).functions(x[i]);
        }
        let functions = |i: usize| Functions([g0[i], g1[i], g2[i], g3[i]]);
        for i in 0..W {
            let correction = orbit(i).correction(x[i], &functions(i));
            let near = correction.newton.abs().less_equal(x[i].abs() * R::from_f64(SMALL));
            let known = (beta[i] * x[i] * x[i]).abs().less_equal(R::from_f64(RADIUS));
            doubt[i] = straight[i] + unless::<R>(near & known);
            change[i] = correction.change;
        }
        let [f, g, f_rate, g_rate] = &mut *ends;
        for i in 0..W {
            [f[i], g[i], f_rate[i], g_rate[i]] = orbit(i).end(&functions(i).shifted(change[i], beta[i]));
            x[i] += change[i];
        }
        let doubts = doubt[1..].iter().fold(doubt[0], |sum, doubt| sum + *doubt);
        if !doubts.any_above(0.0) {
            return true;
        }
    }
    false
}

//! Divided differences f[a, b] = (f(b) − f(a))/(b − a) without 0/0 and without cancellation. The limit is f[a, a] = f'(a).
//!
//! Emitted kernels call these functions. `abs`, `exp`, `exp2`, `ln`, `powf` and `tanh` are divided differences of the functions of these names, symmetric in both
//! ends to the last bit. Their `…_derivative` is ∂f[a, b]/∂b = f[a, b, b], for Newton's matrices. Kernels also need other functions. There are
//! quotients such as sin x/x, with ordinary derivatives. There are exact flows, in `flows`, `coupled`, `linear`, `central`, `kepler` and `free_body`. Functions
//! in `kinks` return NaN outside of a domain.
//!
//! A scalar may have several components, for instance one for each of four trajectories, so no function branches on a comparison. The function `either` selects
//! series or closed form. A divisor is kept away from zero by a number so small that the quotient is rounded to its limit.
//!
//! First divided differences are accurate to 3 ε, and second ones to 30 ε. The unit is the size of the result, or its change if the last digit of an end changes,
//! if that is larger. Limit: coefficients are `f64`, so scalars with more digits use no series.

mod central;
mod circular;
mod coupled;
mod exponential;
mod hyperbolic;
mod flows;
mod free_body;
mod kepler;
mod kinks;
mod linear;

pub use central::{spread, swept};
pub use circular::{arc, arc_derivative, sinc, sinc_derivative};
pub use coupled::{flow_change, flow_matrix, joined};
pub use exponential::{exp, exp_derivative, exp2, ln, ln_derivative, powf, powf_derivative};
pub use flows::{decay_mean, grown, phi_1, phi_1_derivative, rest, stumpff_c0, stumpff_c1, stumpff_c1_derivative};
pub use free_body::{five_rotations, free_rotation, symmetric_rotation};
pub use hyperbolic::{sinhc, sinhc_derivative, tanh, tanh_derivative};
pub use kepler::{kepler, kepler_f, kepler_f_rate, kepler_g, kepler_g_rate};
pub use kinks::{
    abs, abs_derivative, at_most, before_squares, bounded, not_negative, provided, recip_above, recip_positive, root,
    scaled,
};
pub use linear::{cosine_at, cosine_slope, sine_at, sine_slope};

use crate::scalar::Real;

/// Returns a tiny normal number. Added to any number of ordinary size it has no effect, but it can be a divisor. A sum keeps NaN, unlike `max`.
#[inline(always)]
fn tiny<R: Real>() -> R {
    R::from_f64(8.0 * R::smallest())
}

/// Returns x, kept away from zero by [`tiny`].
#[inline(always)]
fn away<R: Real>(x: R) -> R {
    x + x.signum() * tiny()
}

/// Returns `small(x)` if |x| ≤ `bound`, else `large()`.
#[inline(always)]
fn either<R: Real>(x: R, bound: f64, small: impl FnOnce(R) -> R, large: impl FnOnce() -> R) -> R {
    let [value] = R::choose(x.abs().less_equal(R::from_f64(bound)), || [small(x)], || [large()]);
    value
}

/// Returns Σ cₖ xᵏ by Horner's rule.
#[inline(always)]
fn polynomial<R: Real, const N: usize>(x: R, c: &[f64; N]) -> R {
    let mut sum = R::from_f64(c[N - 1]);
    for k in (0..N - 1).rev() {
        sum = sum.multiply_add(x, R::from_f64(c[k]));
    }
    sum
}

/// Returns Σ cₖ xᵏ for N ≥ 3 by Estrin's scheme: the terms after the first two are summed in pairs, pairs of pairs, and so on. The chain of dependent operations is
/// short. The rounding errors of these terms are multiplied by x². G. Estrin, Proc. Western Joint Computer Conf. (1960) 33.
#[inline(always)]
fn by_pairs<R: Real, const N: usize>(x: R, c: &[f64; N]) -> R {
    let square = x * x;
    let (mut sums, mut power, mut apart) = (c.map(R::from_f64), x, 1);
    while apart < N - 2 {
        for k in (2..N - apart).step_by(2 * apart) {
            sums[k] = sums[k + apart].multiply_add(power, sums[k]);
        }
        (power, apart) = (power * power, 2 * apart);
    }
    sums[0] + sums[2].multiply_add(square, sums[1] * x)
}

/// Returns `bound`, up to which a series replaces a library function. Returns zero for a scalar with more digits than `f64`: the series would be less accurate.
#[inline(always)]
fn series_bound<R: Real>(bound: f64) -> f64 {
    if R::epsilon() < f64::EPSILON { 0.0 } else { bound }
}

/// Returns n!, exact for n ≤ 22.
const fn factorial(n: usize) -> f64 {
    if n == 0 { 1.0 } else { n as f64 * factorial(n - 1) }
}

/// The array [c(0), …, c(n − 1)] of a formula c(k), computed at compile time.
macro_rules! series {
    ($n:literal, |$k:ident| $c:expr) => {{
        const C: [f64; $n] = {
            let mut c = [0.0; $n];
            let mut $k = 0;
            while $k < $n {
                c[$k] = $c;
                $k += 1;
            }
            c
        };
        &C
    }};
}
use series;

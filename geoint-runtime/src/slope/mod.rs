//! Helpers of divided differences f[a, b] = (f(b) − f(a))/(b − a): no 0/0, no cancellation, f[a, a] = f'(a).
//!
//! What the macro does not write with operations and elementary functions alone. Functions of two ends are symmetric in
//! them, to the last bit, and carry the name of f; `…_derivative` is ∂f[a, b]/∂b = f[a, b, b], for Newton's matrices. All of
//! them hold in every component of a scalar, whatever the other components are: series and closed form are put together
//! by one function, `either`, and differences that are divided by are kept away from zero by a number so small that the
//! quotient is rounded to its limit.
//!
//! First divided differences are accurate to 3 ε and second ones to 30 ε, relative to their size and to how they change
//! with the last digits of both ends.

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

/// A number that is lost when it is added to any other one, and that can still be divided by. (A sum keeps what is not a
/// number, which `max` would lose.)
#[inline(always)]
fn tiny<R: Real>() -> R {
    R::from_f64(8.0 * R::smallest())
}

/// x, kept away from zero.
#[inline(always)]
fn away<R: Real>(x: R) -> R {
    x + x.signum() * tiny()
}

/// `small(x)` where |x| ≤ `bound`, `large()` elsewhere.
#[inline(always)]
fn either<R: Real>(x: R, bound: f64, small: impl FnOnce(R) -> R, large: impl FnOnce() -> R) -> R {
    let [value] = R::choose(x.abs().less_equal(R::from_f64(bound)), || [small(x)], || [large()]);
    value
}

/// Σ cₖ xᵏ by Horner's rule.
#[inline(always)]
fn polynomial<R: Real, const N: usize>(x: R, c: &[f64; N]) -> R {
    let mut sum = R::from_f64(c[N - 1]);
    for k in (0..N - 1).rev() {
        sum = sum.multiply_add(x, R::from_f64(c[k]));
    }
    sum
}

/// The same; behind the first two coefficients by pairs of terms, pairs of pairs and so on: few operations wait for each other, and what they
/// round is multiplied by x². G. Estrin, Proc. Western Joint Computer Conf. (1960) 33.
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

/// Up to where a series spares the call of a library: nowhere, if the scalar has more digits than the coefficients.
#[inline(always)]
fn spared<R: Real>(bound: f64) -> f64 {
    if R::epsilon() < f64::EPSILON { 0.0 } else { bound }
}

/// n!, exact for n ≤ 22.
const fn factorial(n: usize) -> f64 {
    if n == 0 { 1.0 } else { n as f64 * factorial(n - 1) }
}

/// The coefficients cₖ = numerator(k)/denominator(k) of a series.
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

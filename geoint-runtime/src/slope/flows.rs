//! Functions of exact flows. They are smooth at a coefficient of zero, without 0/0 and cancellation.

use super::{by_pairs, either, factorial, polynomial, series, series_bound, tiny};
use crate::scalar::Real;

/// Returns φ₁(x) = (eˣ − 1)/x. For |x| ≤ 1/64, as with weak friction, 7 terms of the Taylor series are enough.
#[inline(always)]
pub fn phi_1<R: Real>(x: R) -> R {
    let small = |x: R| polynomial(x, series!(7, |k| 1.0 / factorial(k + 1)));
    either(x, 0.015625, small, || strong(x))
}

/// Returns φ₁(x) for |x| > 1/64. The Taylor series up to |x| = 1 has smaller rounding errors than the quotient. Not inlined, to keep steps short.
#[inline(never)]
fn strong<R: Real>(x: R) -> R {
    let series = |x: R| by_pairs(x, series!(18, |k| 1.0 / factorial(k + 1)));
    either(x, series_bound::<R>(1.0), series, || x.exp_m1() / x)
}

/// Returns x·eᶻ from `change` = eᶻ − 1, as x + x·`change`. If eᶻ < ½, it returns x·`rest`, with eᶻ from the function [`rest`].
///
/// A rounded factor eᶻ near 1 would have the same rounding error in each step, and these errors would add up.
#[inline(always)]
pub fn grown<R: Real>(x: R, rest: R, change: R) -> R {
    if change.any_below(-0.5) {
        rarely();
        x * rest
    } else {
        x.multiply_add(change, x)
    }
}

/// Marks a branch as unlikely. The compiler then keeps the branch, which the processor predicts, instead of a selection between two computed results.
#[cold]
#[inline(always)]
fn rarely() {}

/// Returns eᶻ if it is less than ½, else 1, which [`grown`] does not read. Call it before a loop, because a function call in the loop would force
/// its variables into memory.
#[inline(always)]
pub fn rest<R: Real>(z: R, change: R) -> R {
    if change.any_below(-0.5) { far(z) } else { R::from_f64(1.0) }
}

/// Returns eᶻ. Not inlined, because the optimiser would compute the exponential also if it is not needed.
#[cold]
#[inline(never)]
fn far<R: Real>(z: R) -> R {
    z.exp()
}

/// Returns (r − rᵏ)/((k − 1)(1 − r)), which is the mean of (r/(r + (1 − r)v))ᵏ over v from 0 to 1. Precondition: r ≥ 0. The limits k → 1 and r → 1 are
/// included. The value is 0 at r = 0 for k > 0.
#[inline(always)]
pub fn decay_mean<R: Real>(r: R, k: R) -> R {
    let (one, positive) = (R::from_f64(1.0), r + tiny());
    let rise = (one - r) / positive + tiny();
    let ln = rise.ln_1p();
    // The quotient r/positive is 1, except at r = 0.
    r / positive * (ln / rise) * phi_1((one - k) * ln)
}

/// Returns the derivative of [`phi_1`], (eˣ(x − 1) + 1)/x².
#[inline(always)]
pub fn phi_1_derivative<R: Real>(x: R) -> R {
    let one = R::from_f64(1.0);
    let small = |x: R| polynomial(x, series!(18, |k| (k + 1) as f64 / factorial(k + 2)));
    either(x, 1.0, small, || (x.exp().multiply_add(x - one, one)) / x / x)
}

/// Returns the Stumpff function c₀(x) = cos √x, or cosh √−x for x < 0. K. Stumpff, *Himmelsmechanik* I (1959), §40.
#[inline(always)]
pub fn stumpff_c0<R: Real>(x: R) -> R {
    let small = |x: R| by_pairs(-x, series!(9, |k| 1.0 / factorial(2 * k)));
    let large = || sided(x, |root| root.cos(), |root| root.cosh());
    either(x, 1.0, small, large)
}

/// Returns the Stumpff function c₁(x) = sin √x/√x, or sinh √−x/√−x for x < 0.
#[inline(always)]
pub fn stumpff_c1<R: Real>(x: R) -> R {
    let small = |x: R| by_pairs(-x, series!(9, |k| 1.0 / factorial(2 * k + 1)));
    let large = || sided(x, |root| root.sin() / root, |root| root.sinh() / root);
    either(x, 1.0, small, large)
}

/// Returns the derivative of [`stumpff_c1`], (c₀ − c₁)/2x.
#[inline(always)]
pub fn stumpff_c1_derivative<R: Real>(x: R) -> R {
    let small = |x: R| -polynomial(-x, series!(13, |k| (k + 1) as f64 / factorial(2 * k + 3)));
    let large = || (stumpff_c0(x) - stumpff_c1(x)) / (x + x);
    either(x, 4.0, small, large)
}

/// Returns `positive(√x)` for x > 0, and `negative(√−x)` for x < 0. Precondition: x is not near zero.
#[inline(always)]
fn sided<R: Real>(x: R, positive: impl FnOnce(R) -> R, negative: impl FnOnce(R) -> R) -> R {
    let root = x.abs().sqrt();
    let [value] = R::choose(x.less(R::from_f64(0.0)), || [negative(root)], || [positive(root)]);
    value
}

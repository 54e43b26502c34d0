//! What exact flows are made of: functions that are smooth where a coefficient goes through zero.

use super::{by_pairs, either, factorial, polynomial, series, spared, tiny};
use crate::scalar::Real;

/// φ₁(x) = (eˣ − 1)/x. Friction is small in most steps: few terms are enough.
#[inline(always)]
pub fn phi_1<R: Real>(x: R) -> R {
    let small = |x: R| polynomial(x, series!(7, |k| 1.0 / factorial(k + 1)));
    either(x, 0.015625, small, || strong(x))
}

/// The same where friction is strong: more terms take half of the time of eˣ − 1, and round less than that and a quotient. Out of line, as
/// eˣ − 1 is: inlined it is not faster, and makes steps longer.
#[inline(never)]
fn strong<R: Real>(x: R) -> R {
    let series = |x: R| by_pairs(x, series!(18, |k| 1.0 / factorial(k + 1)));
    either(x, spared::<R>(1.0), series, || x.exp_m1() / x)
}

/// x·eᶻ with eᶻ − 1 at hand: added to x, unless little of it is left, which is the [`rest`] then.
///
/// A factor eᶻ near 1, rounded, is wrong by the same in every step, and errors add up. And it costs an exponential.
#[inline(always)]
pub fn grown<R: Real>(x: R, rest: R, change: R) -> R {
    if change.any_below(-0.5) {
        rarely();
        x * rest
    } else {
        x.multiply_add(change, x)
    }
}

/// Where this is called, steps seldom come: the question stays one, which a processor foretells. Of two results it would choose one, and the next operation
/// waits for that.
#[cold]
#[inline(always)]
fn rarely() {}

/// eᶻ, where little of it is left; else 1, which is not read. Before a loop: beside a call, what the loop moves goes through memory.
#[inline(always)]
pub fn rest<R: Real>(z: R, change: R) -> R {
    if change.any_below(-0.5) { far(z) } else { R::from_f64(1.0) }
}

/// Out of line: the optimiser would compute it before it knows whether it is needed.
#[cold]
#[inline(never)]
fn far<R: Real>(z: R) -> R {
    z.exp()
}

/// (r − rᵏ)/((k − 1)(1 − r)), the mean of (r/(r + (1 − r)v))ᵏ over v from 0 to 1, for r ≥ 0: also for k = 1 and r = 1; 0 at r = 0 for k > 0.
#[inline(always)]
pub fn decay_mean<R: Real>(r: R, k: R) -> R {
    let (one, positive) = (R::from_f64(1.0), r + tiny());
    let rise = (one - r) / positive + tiny();
    let ln = rise.ln_1p();
    // The quotient is 1 but at r = 0.
    r / positive * (ln / rise) * phi_1((one - k) * ln)
}

/// The derivative of [`phi_1`], (eˣ(x − 1) + 1)/x².
#[inline(always)]
pub fn phi_1_derivative<R: Real>(x: R) -> R {
    let one = R::from_f64(1.0);
    let small = |x: R| polynomial(x, series!(18, |k| (k + 1) as f64 / factorial(k + 2)));
    either(x, 1.0, small, || (x.exp().multiply_add(x - one, one)) / x / x)
}

/// c₀(x) = cos √x, cosh √−x for x < 0. K. Stumpff, *Himmelsmechanik* I (1959), §40.
#[inline(always)]
pub fn stumpff_c0<R: Real>(x: R) -> R {
    let small = |x: R| by_pairs(-x, series!(9, |k| 1.0 / factorial(2 * k)));
    let large = || sided(x, |root| root.cos(), |root| root.cosh());
    either(x, 1.0, small, large)
}

/// c₁(x) = sin √x/√x, sinh √−x/√−x for x < 0.
#[inline(always)]
pub fn stumpff_c1<R: Real>(x: R) -> R {
    let small = |x: R| by_pairs(-x, series!(9, |k| 1.0 / factorial(2 * k + 1)));
    let large = || sided(x, |root| root.sin() / root, |root| root.sinh() / root);
    either(x, 1.0, small, large)
}

/// The derivative of [`stumpff_c1`], (c₀ − c₁)/2x.
#[inline(always)]
pub fn stumpff_c1_derivative<R: Real>(x: R) -> R {
    let small = |x: R| -polynomial(-x, series!(13, |k| (k + 1) as f64 / factorial(2 * k + 3)));
    let large = || (stumpff_c0(x) - stumpff_c1(x)) / (x + x);
    either(x, 4.0, small, large)
}

/// One function of √x where x is positive, another one of √−x where it is negative. x is not near zero.
#[inline(always)]
fn sided<R: Real>(x: R, positive: impl FnOnce(R) -> R, negative: impl FnOnce(R) -> R) -> R {
    let root = x.abs().sqrt();
    let [value] = R::choose(x.less(R::from_f64(0.0)), || [negative(root)], || [positive(root)]);
    value
}

//! The safe method for Kepler's equation: it keeps a bracket of X, which each iteration makes smaller.

use super::orbit::{Correction, Functions, Orbit, RADIUS};
use super::{SMALL, STRAIGHT};
use crate::scalar::{Real, zero};

/// The largest number of halvings of X. Beyond 2¹² times the range of the series, hyperbolic functions overflow. Ellipses need less.
const MOST_HALVINGS: u32 = 12;

/// The largest number of doublings of the upper end of the bracket. It starts at h/r, and r may become small along the orbit.
const DOUBLINGS: usize = 200;

/// The largest number of iterations. Each iteration halves the bracket, or its correction is at most half of the previous one.
const ITERATIONS: usize = 200;

/// Computes one orbit. See [`kepler`](super::kepler).
#[cold]
#[inline(never)]
pub(super) fn kepler<R: Real>([square, eta, speed, mu, h]: [R; 5]) -> [R; 4] {
    // A motion backwards in time is a motion forwards with the opposite velocity.
    let sign = either(h.less(zero()), R::from_f64(-1.0), R::from_f64(1.0));
    let forward = [square, sign * eta, speed, mu, sign * h];
    let mut orbit = Orbit::new(forward);
    let periods = reduced(&mut orbit);
    let x = anomaly(&orbit);
    let g = functions(&orbit, x);
    let g = g.shifted(orbit.correction(x, &g).change, orbit.beta);
    let end = orbit.end(&g);
    let lost = passed_centre(forward, &orbit, &g, periods);
    let [f, g, f_rate, g_rate] = end.map(|x| x + lost);
    [f, sign * g, sign * f_rate, g_rate]
}

/// Subtracts the nearest number of whole periods from h, and returns this number. h becomes NaN if the phase has no correct digit.
fn reduced<R: Real>(orbit: &mut Orbit<R>) -> R {
    let Orbit { beta, mu, h, .. } = *orbit;
    let bound = zero::<R>().less(beta) & zero::<R>().less(mu);
    let period = mu / (beta * beta.abs().sqrt()) * R::from_f64(core::f64::consts::TAU);
    let mut periods = zero::<R>();
    let mut power = 1.0;
    while (h / period).any_above(power) && power < 1.0 / R::epsilon() {
        power *= 2.0;
    }
    while power >= 1.0 {
        let more = periods + R::from_f64(power);
        let fits = bound & ((more - R::from_f64(0.5)) * period).less_equal(h);
        periods = either(fits, more, periods);
        power *= 0.5;
    }
    let known = (periods * R::from_f64(core::f64::consts::TAU)).less(R::from_f64(1.0 / R::epsilon()));
    let [rest] = R::choose(zero::<R>().less(periods), || [h - periods * period], || [h]);
    orbit.h = either(known, rest, R::from_f64(f64::NAN));
    periods
}

/// Returns X at time h. h may be negative after the subtraction of a period.
fn anomaly<R: Real>(orbit: &Orbit<R>) -> R {
    let Orbit { recip, beta, h, .. } = *orbit;
    let sign = either(h.less(zero()), R::from_f64(-1.0), R::from_f64(1.0));
    // Returns whether X is before the solution. Overflow and NaN count as beyond it.
    let is_early = |x: R, g: &Functions<R>| {
        let late = sign * orbit.late(x, g);
        zero::<R>().less(late) & late.less(R::from_f64(f64::INFINITY))
    };
    let ellipse = zero::<R>().less(beta);
    let turn = R::from_f64(core::f64::consts::TAU) / beta.abs().sqrt();
    let mut far = either(ellipse, sign * turn, h * recip);
    for _ in 0..DOUBLINGS {
        let doubled = either(!ellipse & is_early(far, &functions(orbit, far)), far + far, far);
        let done = (doubled - far).magnitude() == 0.0;
        far = doubled;
        if done {
            break;
        }
    }
    let [mut near, mut last] = [zero::<R>(), far];
    let guess = orbit.first_guess();
    let inside = |x: R, near: R, far: R| (sign * near).less(sign * x) & (sign * x).less(sign * far);
    let middle = |near: R, far: R| (near + far) * R::from_f64(0.5);
    let mut x = either(inside(guess, near, far), guess, middle(near, far));
    for _ in 0..ITERATIONS {
        let g = functions(orbit, x);
        let before = is_early(x, &g);
        (near, far) = (either(before, x, near), either(before, far, x));
        let Correction { newton, change: d } = orbit.correction(x, &g);
        // Far beyond the solution t'(X) overflows, and Newton's correction becomes zero. The second condition tests the change, too.
        let small = newton.abs().less_equal(x.abs() * R::from_f64(SMALL)) & d.abs().less_equal(x.abs());
        let shrinks = (d.abs() + d.abs()).less_equal(last.abs());
        let next = either(small | shrinks & inside(x + d, near, far), x + d, middle(near, far));
        last = either(small, zero(), next - x);
        let (rest, size) = (last.magnitude(), x.magnitude());
        x = either(small, x, next);
        if rest <= R::epsilon() * size || rest.is_nan() {
            break;
        }
    }
    x
}

/// Returns the functions G, by the series after the required number of halvings of X, and doublings. NaN if they overflow.
fn functions<R: Real>(orbit: &Orbit<R>, x: R) -> Functions<R> {
    let beta = orbit.beta;
    let size = (beta * x * x).abs();
    let halvings = (0..MOST_HALVINGS).find(|n| !size.any_above(reach(*n))).unwrap_or(MOST_HALVINGS);
    let mut known = size.less_equal(R::from_f64(reach(MOST_HALVINGS)));
    let mut y = x * R::from_f64(1.0 / (1_u64 << halvings) as f64);
    let mut g = orbit.functions(y);
    for _ in 0..halvings {
        (g, y) = (g.doubled(y, beta), y + y);
    }
    let Functions(g) = g;
    // If one function overflows, all become NaN. A partial result would count as before or beyond the solution.
    g.iter().for_each(|g| known = known & g.abs().less(R::from_f64(f64::INFINITY)));
    Functions(g.map(|g| either(known, g, R::from_f64(f64::NAN))))
}

/// Returns the largest |β|X² that this number of halvings of X reduces to [`RADIUS`].
fn reach(halvings: u32) -> f64 {
    RADIUS * (1_u64 << (2 * halvings)) as f64
}

/// Returns NaN if the orbit is straight and meets the centre within h, else zero. Precondition: h ≥ 0.
fn passed_centre<R: Real>([square, eta, speed, mu, h]: [R; 5], orbit: &Orbit<R>, g: &Functions<R>, periods: R) -> R {
    let none = zero::<R>();
    let straight = (square * speed * R::from_f64(1.0 - STRAIGHT * R::epsilon())).less_equal(eta * eta);
    let (beta, zeta) = (orbit.beta, orbit.zeta);
    let Functions([g0, g1, _, _]) = *g;
    let inward = eta.less(none);
    // An inward motion has passed the centre if it now moves outwards.
    let turned = none.less(eta * g0 + zeta * g1) | none.less(periods);
    // An outward motion on a bound orbit rises and falls. The time from the centre is t = (E − sin E)μ/β^(3/2), with the eccentric anomaly E.
    let root = beta.abs().sqrt();
    let angle = (root * eta).abs().atan2(zeta);
    let fall = (R::from_f64(core::f64::consts::TAU) - angle + angle.sin()) * mu / (beta.abs() * root);
    let fell = none.less(beta) & fall.less_equal(h);
    let passed = straight & none.less(mu) & (inward & turned | !inward & fell);
    either(passed, R::from_f64(f64::NAN), none)
}

/// Returns `first` if the condition holds, else `second`.
fn either<R: Real>(mask: R::Mask, first: R, second: R) -> R {
    let [value] = R::choose(mask, || [first], || [second]);
    value
}

//! Estimates the time in which a state changes, from the state and its rates alone.

use crate::scalar::Real;
use crate::space::PerCoordinate;
use crate::system::{PhaseSpace, Rates};

/// One number for each coordinate of a system.
type Coordinates<S, R> = PerCoordinate<<S as PhaseSpace<R>>::Phase, <S as PhaseSpace<R>>::Action>;

/// Number of halvings of the time at which the driving rates are compared.
const HALVINGS: i32 = 16;

/// Bounds on the ratio of a rate at times 2τ and τ. Within them, the rate counts as a power of time.
const STEEP: [f64; 2] = [1.5, 1024.0];

/// Estimates the time in which the state changes by itself: the minimum of |size/rate| over all moving coordinates that have a size.
///
/// If no coordinate with a size moves (each is zero or at rest, as at a pericentre on an axis), returns the largest power of two in which the rates
/// change little. Infinite if they never change. If the whole state is at rest, the rates driven by time alone decide, see `grows`. No constant of
/// this estimate carries a unit of time.
pub(super) fn time<S: PhaseSpace<R> + Rates<R>, R: Real>(
    system: &S,
    t: R,
    x: &Coordinates<S, R>,
    sizes: &Coordinates<S, R>,
) -> f64 {
    let rates = system.rates(t, x);
    let by_itself = |(size, rate): (R, R)| {
        if size.magnitude() > 0.0 { size.magnitude() / rate.magnitude() } else { f64::INFINITY }
    };
    let time = sizes.numbers().zip(rates.numbers()).map(by_itself).fold(f64::INFINITY, f64::min);
    if time < f64::INFINITY {
        return time;
    }
    let at_rest = |rates: &Coordinates<S, R>| rates.numbers().all(|rate| rate.magnitude() == 0.0);
    if at_rest(&rates) {
        let driven = |h: &f64| !at_rest(&system.rates(t + R::from_f64(*h), x)) && grows(system, t, x, *h) == Some(true);
        let mut lengths = (f64::MIN_EXP..f64::MAX_EXP).rev().map(|exponent| Real::exp2(f64::from(exponent)));
        return lengths.find(driven).unwrap_or(f64::INFINITY);
    }
    longest(|h| changes_little((system, t, x), &rates, R::from_f64(h)))
}

/// Returns the largest power of two at which a condition holds, by bisection of exponents. Precondition: it holds below a limit and fails above.
/// Infinite if there is no limit.
fn longest(holds: impl Fn(f64) -> bool) -> f64 {
    let power = |exponent: i32| Real::exp2(f64::from(exponent));
    let (mut short, mut long) = (f64::MIN_EXP, f64::MAX_EXP - 1);
    if holds(power(long)) {
        return f64::INFINITY;
    }
    while long - short > 1 {
        let middle = short + (long - short) / 2;
        if holds(power(middle)) { short = middle } else { long = middle }
    }
    power(short)
}

/// Returns the rates at t + h after an Euler step along the given rates.
fn after<S: PhaseSpace<R> + Rates<R>, R: Real>(
    (system, t, x): (&S, R, &Coordinates<S, R>),
    h: R,
    rates: &Coordinates<S, R>,
) -> Coordinates<S, R> {
    let mut moved = *x;
    moved.add_scaled(h, rates);
    system.rates(t + h, &moved)
}

/// Returns whether the state changes little within the time `h`. A non-zero coordinate may move by at most its size. The rate of a coordinate at zero
/// may change by at most itself.
///
/// Two Euler predictions are tested: along the rates at the start, and along the rates found there. The second one is needed because a body pushed
/// from rest feels its spring only after it has moved.
fn changes_little<S: PhaseSpace<R> + Rates<R>, R: Real>(
    start: (&S, R, &Coordinates<S, R>),
    rates: &Coordinates<S, R>,
    h: R,
) -> bool {
    let little = |later: &Coordinates<S, R>| {
        let little = |((x, rate), later): ((R, R), R)| match x.magnitude() > 0.0 {
            true => (h * later).magnitude() <= x.magnitude(),
            false => rate.magnitude() == 0.0 || (later - rate).magnitude() <= rate.magnitude(),
        };
        start.2.numbers().zip(rates.numbers()).zip(later.numbers()).all(little)
    };
    let later = after(start, h, rates);
    little(&later) && little(&after(start, h, &later))
}

/// Examines coordinates at rest at zero that time alone drives. Returns `Some(true)` if, up to `time`, their rates grow like a power of time, and
/// faster than the resulting motion changes them. Returns `None` if time alone drives no such coordinate.
///
/// A step that is the expected part of such a time has an error within the tolerance, although no estimate measures it.
pub(super) fn grows<S: PhaseSpace<R> + Rates<R>, R: Real>(
    system: &S,
    t: R,
    x: &Coordinates<S, R>,
    time: f64,
) -> Option<bool> {
    let now = system.rates(t, x);
    let driven = |time: f64| system.rates(t + R::from_f64(time), x);
    let at_rest = |i: &usize| x.at(*i).magnitude() == 0.0 && now.at(*i).magnitude() == 0.0;
    let shortest = 64.0 * R::epsilon() * t.magnitude();
    let (last, mut drives) = (driven(time), false);
    let (mut part, mut later) = (time, last);
    for _ in 0..HALVINGS {
        if part.abs() <= shortest {
            break;
        }
        part *= 0.5;
        let before = driven(part);
        for i in (0..Coordinates::<S, R>::LEN).filter(at_rest) {
            let [before, later] = [&before, &later].map(|rates| rates.at(i).magnitude());
            if before == 0.0 && later == 0.0 {
                continue;
            }
            // A rate sin ωτ leaves these bounds at about a quarter of its period. A force that starts within the interval is rejected as well.
            if !(later >= STEEP[0] * before && later <= STEEP[1] * before) {
                return Some(false);
            }
            drives = true;
        }
        later = before;
    }
    let h = R::from_f64(time);
    let start = (system, t, x);
    let moved = after(start, h, &last);
    let little = |later: Coordinates<S, R>| {
        let change = |i: usize| (later.at(i) - last.at(i)).magnitude() <= last.at(i).magnitude();
        (0..Coordinates::<S, R>::LEN).filter(at_rest).filter(|i| last.at(*i).magnitude() > 0.0).all(change)
    };
    drives.then(|| little(moved) && little(after(start, h, &moved)))
}

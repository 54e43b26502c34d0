//! In how long does a state change of which nothing but itself is known?

use crate::scalar::Real;
use crate::space::PerCoordinate;
use crate::system::{PhaseSpace, Rates};

/// A number for every coordinate of a system.
type Coordinates<S, R> = PerCoordinate<<S as PhaseSpace<R>>::Phase, <S as PhaseSpace<R>>::Action>;

/// What drives a state from rest is looked at after this many halvings of a time.
const HALVINGS: i32 = 16;

/// By what factors a power of time may grow in twice the time.
const STEEP: [f64; 2] = [1.5, 1024.0];

/// In how long, roughly, the state changes by itself: the shortest of the size of a coordinate over its rate, for all that move. Where each is zero
/// or at rest, as at a pericentre on an axis, it is the longest power of two in which rates do not change by more; infinite if none do. Nothing is
/// in a unit of time of its own.
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

/// The longest power of two at which something holds that holds for short times, and not for long ones.
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

/// Rates after a time, of a state that has moved at these.
fn after<S: PhaseSpace<R> + Rates<R>, R: Real>(
    (system, t, x): (&S, R, &Coordinates<S, R>),
    h: R,
    rates: &Coordinates<S, R>,
) -> Coordinates<S, R> {
    let mut moved = *x;
    moved.add_scaled(h, rates);
    system.rates(t + h, &moved)
}

/// Whether rates change by no more than themselves in a time, or move a coordinate by no more than itself: along them, and along those that are
/// then met, since what is pushed from rest does not know of its springs before it has moved.
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

/// Whether what time alone drives from rest at zero grows like a power of time for so long, and faster than the motion that follows changes it: by
/// an error that nothing measures a step that is a part of that is off by no more than is tolerated. None if time alone drives nothing.
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
            // A sine is half as steep after an eighth of its period; what begins on the way is no power.
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

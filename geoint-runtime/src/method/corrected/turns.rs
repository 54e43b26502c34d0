//! Checks whether an angle moves by more than half a turn in a step.
//!
//! A divided difference depends on the ends of a step only. It assumes that an angle `atan2(y, x)` takes the shorter way round. This is right up to
//! half a turn.

use crate::method::Failure;
use crate::scalar::{Real, signed, zero};
use crate::space::Array;
use crate::space::vector::moved;
use crate::system::VectorField;
use core::f64::consts::{FRAC_PI_2, PI};

/// The path of a step is halved at least [`LEAST_HALVINGS`] times, and at most [`MOST_HALVINGS`] times if an angle is not resolved.
const LEAST_HALVINGS: u32 = 2;
const MOST_HALVINGS: u32 = 12;

/// The rate of an angle is a difference quotient over this part of a step.
const PART: f64 = 1.0 / 1024.0;

/// Refuses a step between `ends` if an angle of the energy, or of integrals, moves by more than half a turn. The step starts at time t and has the
/// length h.
#[inline(always)]
pub(super) fn check_turns<S: VectorField<R>, R: Real>(
    system: &S,
    [t, h]: [R; 2],
    ends: [&S::Phase; 2],
) -> Result<(), Failure> {
    if S::ANGLES { check(system, [t, h], ends) } else { Ok(()) }
}

#[cold]
#[inline(never)]
fn check<S: VectorField<R>, R: Real>(
    system: &S,
    [t, h]: [R; 2],
    [before, after]: [&S::Phase; 2],
) -> Result<(), Failure> {
    let mut path = Path { system, t, h, before: *before, after: *after, rates: [S::Phase::zero(); 2] };
    let [first, last] = &mut path.rates;
    system.rate(t, before, first);
    system.rate(t + h, after, last);
    let mut found = Ok(());
    let mut index = 0;
    system.angles(t, before, &(), |what, _| {
        if path.is_lost(index) && found.is_ok() {
            found = Err(Failure::Turned { what });
        }
        index += 1;
    });
    found
}

/// The cubic Hermite polynomial of a step: it has the states and the rates of the step at its ends.
struct Path<'a, S: VectorField<R>, R: Real> {
    system: &'a S,
    t: R,
    h: R,
    before: S::Phase,
    after: S::Phase,
    rates: [S::Phase; 2],
}

impl<S: VectorField<R>, R: Real> Path<'_, S, R> {
    /// Returns whether the angle with this index does not take the shorter way between its ends. The cubic may miss many turns within one step. The
    /// step is then recognised by the rates of the angle at both ends.
    fn is_lost(&self, angle: usize) -> bool {
        let ends = [0.0, 1.0].map(|part| self.sides(angle, part));
        let followed = self.followed(angle, [0.0, 1.0], ends, MOST_HALVINGS);
        // NaN if the state is not finite, which other checks report.
        if followed == f64::INFINITY || (followed - between(ends)).abs() > FRAC_PI_2 {
            return true;
        }
        let [first, last] = [0, 1].map(|end| self.rate(angle, end));
        first.abs().min(last.abs()) > PI && first.is_sign_positive() == last.is_sign_positive()
    }

    /// Returns the change of the angle on a part of the path, from its sides at both ends of the part. Infinite if the change is not resolved.
    fn followed(&self, angle: usize, [from, to]: [f64; 2], ends: [[R; 2]; 2], left: u32) -> f64 {
        let whole = between(ends);
        let is_wide = whole.abs() > FRAC_PI_2;
        if left <= MOST_HALVINGS - LEAST_HALVINGS && !is_wide {
            return whole;
        }
        if left == 0 {
            return f64::INFINITY;
        }
        let middle = 0.5 * (from + to);
        let [start, end] = ends;
        let sides = self.sides(angle, middle);
        self.followed(angle, [from, middle], [start, sides], left - 1)
            + self.followed(angle, [middle, to], [sides, end], left - 1)
    }

    /// Returns the change of the angle in a step, extrapolated linearly from its rate at one end.
    fn rate(&self, angle: usize, end: usize) -> f64 {
        let z = [&self.before, &self.after][end];
        let near = moved(z, self.h * R::from_f64(PART), &self.rates[end]);
        let t = self.t + self.h * R::from_f64(end as f64);
        between([self.sides_at(angle, t, z), self.sides_at(angle, t, &near)]) / PART
    }

    /// Returns the sides y and x of the angle at this part of the path, from 0 to 1.
    fn sides(&self, angle: usize, part: f64) -> [R; 2] {
        let rest = 1.0 - part;
        let [first, last] = &self.rates;
        let [by_first, by_last] = [part * rest * rest, -part * part * rest].map(|weight| self.h * R::from_f64(weight));
        let mut z = S::Phase::zero();
        z.add_scaled(R::from_f64(rest * rest * (1.0 + 2.0 * part)), &self.before);
        z.add_scaled(R::from_f64(part * part * (1.0 + 2.0 * rest)), &self.after);
        z.add_scaled(by_first, first);
        z.add_scaled(by_last, last);
        self.sides_at(angle, self.t + self.h * R::from_f64(part), &z)
    }

    fn sides_at(&self, angle: usize, t: R, z: &S::Phase) -> [R; 2] {
        sides_of(self.system, angle, t, z)
    }
}

/// Returns the sides y and x of the angle with this index.
fn sides_of<S: VectorField<R>, R: Real>(system: &S, angle: usize, t: R, z: &S::Phase) -> [R; 2] {
    let (mut sides, mut index) = ([zero(); 2], 0);
    system.angles(t, z, &(), |_, found| {
        if index == angle {
            sides = found;
        }
        index += 1;
    });
    sides
}

/// Returns the jumps of an autonomous `energy` at the cuts of its angles on the straight line from `z` to `z + dz`. A difference of values contains
/// these jumps, but the motion does not.
pub(super) fn change_at_cuts<S: VectorField<R>, R: Real>(
    system: &S,
    z: &S::Phase,
    dz: &S::Phase,
    energy: impl Fn(&S::Phase) -> R,
) -> R {
    let mut change = zero();
    if !S::ANGLES {
        return change;
    }
    let mut index = 0;
    system.angles(zero(), z, &(), |_, _| {
        let at = |part: f64| moved(z, R::from_f64(part), dz);
        let value = |part: f64| {
            let [y, x] = sides_of(system, index, zero(), &at(part));
            signed(y.atan2(x))
        };
        // Bisection until the ends are neighbouring numbers.
        let (mut from, mut to) = (0.0, 1.0);
        if (value(to) - value(from)).abs() > PI {
            while 0.5 * (from + to) > from && 0.5 * (from + to) < to {
                let middle = 0.5 * (from + to);
                if (value(middle) - value(from)).abs() > PI { to = middle } else { from = middle }
            }
            change += energy(&at(to)) - energy(&at(from));
        }
        index += 1;
    });
    change
}

/// Returns the angle between two directions, in (−π, π]. Infinite if one of them is the zero vector.
fn between<R: Real>(ends: [[R; 2]; 2]) -> f64 {
    let sizes = ends.map(|[y, x]| y.magnitude() + x.magnitude());
    if sizes.contains(&0.0) {
        return f64::INFINITY;
    }
    let unit = |end: usize| ends[end].map(|side| side / R::from_f64(sizes[end]));
    let ([y0, x0], [y1, x1]) = (unit(0), unit(1));
    signed((x0 * y1 - y0 * x1).atan2(x0 * x1 + y0 * y1))
}

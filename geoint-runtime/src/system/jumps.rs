//! Conditions of the energy that rounding decides, and those that a step without secants would pass unseen.
//!
//! The equation of a step that keeps the energy decides every condition at the end of the step. The state that is returned has been rounded,
//! and may lie on the other side: where the energy jumps there, the step has not kept it.
//!
//! All other methods know derivatives alone, and a jump has none: on both sides of the edge of a square well there is no force.

use super::PhaseSpace;
use crate::scalar::{Enclosure, Interval, Real, bounds, signed};
use crate::space::{Action, Array, PerCoordinate, Snapshot};
use core::marker::PhantomData;

/// The first jump of the energy, if any, between two points that differ by rounding, at one of which a condition holds.
///
/// Where the energy has no jump, or one that cannot be told from rounding, there is none.
#[inline(always)]
pub(crate) fn jump_between<S: PhaseSpace<R>, R: Real>(
    system: &S,
    t: R,
    z: [&S::Phase; 2],
    s: [&S::Action; 2],
) -> Option<&'static str> {
    if Jumps::<S, R>::NONE || system.same_sides(t, z, s) { None } else { search(system, t, z, s) }
}

/// A time and a point.
pub(crate) type Moment<S, R> = (R, PerCoordinate<<S as PhaseSpace<R>>::Phase, <S as PhaseSpace<R>>::Action>);

/// A jump of the energy, by more than this part of it, on the straight line between the ends of a step.
#[inline(always)]
pub(crate) fn jump_on_way<S: PhaseSpace<R>, R: Real>(
    system: &S,
    ends: &[Moment<S, R>; 2],
    part: f64,
) -> Option<&'static str> {
    if S::CONTINUOUS {
        return None;
    }
    first_on_way(system, ends, Some(part))
}

/// Returns the first jump of an integral of a field on the straight line between the ends of a step that keeps integrals.
///
/// No flow leads from one side of such a jump to the other: where rounding does, the correction of a step would take the jump along. Energies
/// are different: motion goes over a jump of a potential, and gains or loses speed.
#[inline(always)]
pub(crate) fn jump_of_integral<S: PhaseSpace<R>, R: Real>(
    system: &S,
    t: [R; 2],
    z: [&S::Phase; 2],
    s: S::Action,
) -> Option<&'static str> {
    if S::State::MOMENTA || S::CONTINUOUS {
        return None;
    }
    let ends = [0, 1].map(|end| (t[end], PerCoordinate { z: *z[end], s }));
    first_on_way(system, &ends, None)
}

#[inline(always)]
fn first_on_way<S: PhaseSpace<R>, R: Real>(
    system: &S,
    ends: &[Moment<S, R>; 2],
    part: Option<f64>,
) -> Option<&'static str> {
    let crosses = |jump: &usize| Way { system, ends, jump: *jump, part }.crosses([0.0, 1.0], HALVINGS);
    (0..S::JUMPS.len()).find(crosses).map(|jump| S::JUMPS[jump])
}

/// After so many a part of a line is as short as a number between 0 and 1 can tell.
const HALVINGS: u32 = 52;

/// A line between two points is halved so often before a condition that is the same at both is taken to be the same on it.
const LOOKS: u32 = 8;

/// A straight line, and one of the conditions.
struct Way<'a, S: PhaseSpace<R>, R: Real> {
    system: &'a S,
    ends: &'a [Moment<S, R>; 2],
    jump: usize,
    /// The part of the energy by which it may jump; missing if every jump counts.
    part: Option<f64>,
}

/// How a condition is on a part of a line.
enum Seen {
    /// The same everywhere.
    Steady,
    /// The same at both ends.
    Same,
    /// Not the same.
    Changes,
}

impl<S: PhaseSpace<R>, R: Real> Way<'_, S, R> {
    /// Whether the energy jumps between two parts of the way: that is halved until intervals exclude that the condition changes, or there is
    /// nothing between its ends.
    fn crosses(&self, [from, to]: [f64; 2], left: u32) -> bool {
        match self.look([from, to]) {
            Seen::Steady => false,
            Seen::Same if left <= HALVINGS - LOOKS => false,
            Seen::Changes if left == 0 => self.jumps([from, to]),
            _ => {
                let middle = 0.5 * (from + to);
                self.crosses([from, middle], left - 1) || self.crosses([middle, to], left - 1)
            }
        }
    }

    // Points may be large: none is kept while halves are looked at.
    #[inline(never)]
    fn look(&self, ends: [f64; 2]) -> Seen {
        let [before, after] = ends.map(|part| self.at(part));
        let [side, _] = enclosed(self.system, self.jump, &before, &after);
        let side_of = |(t, x): &Moment<S, R>| {
            let s = x.s.scalar().unwrap_or(R::from_f64(0.0));
            signed(self.system.jump(self.jump, |parameter| parameter, *t, x.z.as_slice(), s)[0])
        };
        match () {
            () if !side.contains_zero() => Seen::Steady,
            () if side_of(&before) == side_of(&after) => Seen::Same,
            () => Seen::Changes,
        }
    }

    /// Whether the energy jumps between two points that are next to each other.
    #[inline(never)]
    fn jumps(&self, ends: [f64; 2]) -> bool {
        let [before, after] = ends.map(|part| self.at(part));
        let [_, height] = enclosed(self.system, self.jump, &before, &after);
        let Some(part) = self.part else { return !height.contains_zero() };
        let [h0, h1] = [&before, &after].map(|(t, x)| self.system.hamiltonian(*t, &x.z, &x.s));
        let least = part.max(16.0 * R::epsilon()) * h0.magnitude().max(h1.magnitude());
        (h1 - h0).magnitude() > least && !height.contains_zero()
    }

    /// The point after a part of the way.
    fn at(&self, part: f64) -> Moment<S, R> {
        let [(t, mut x), (end, after)] = *self.ends;
        let (before, after_part) = (R::from_f64(1.0 - part), R::from_f64(part));
        x.times(before);
        x.add_scaled(after_part, &after);
        (before * t + after_part * end, x)
    }
}

/// What is known of jumps at compile time.
struct Jumps<S, R>(PhantomData<(S, R)>);

impl<S: PhaseSpace<R>, R: Real> Jumps<S, R> {
    /// Nothing of a search is compiled then.
    const NONE: bool = S::JUMPS.is_empty();
}

#[cold]
#[inline(never)]
fn search<S: PhaseSpace<R>, R: Real>(system: &S, t: R, z: [&S::Phase; 2], s: [&S::Action; 2]) -> Option<&'static str> {
    let [before, after] = [0, 1].map(|end| (t, PerCoordinate { z: *z[end], s: *s[end] }));
    (0..S::JUMPS.len()).find_map(|i| {
        let [side, height] = enclosed(system, i, &before, &after);
        (side.contains_zero() && !height.contains_zero()).then_some(S::JUMPS[i])
    })
}

/// The side of a condition and the height of its jump, in the box between two points.
fn enclosed<S: PhaseSpace<R>, R: Real>(
    system: &S,
    jump: usize,
    before: &Moment<S, R>,
    after: &Moment<S, R>,
) -> [Interval; 2] {
    let constant = |x: Interval| Enclosure::<R>::new(x, Interval::WHOLE);
    let between = |a: R, b: R| constant(bounds(a).hull(bounds(b)));
    let mut all = S::Phase::fill(constant(Interval::WHOLE));
    let all = S::Phase::entries(&mut all);
    for (i, x) in all.iter_mut().enumerate() {
        *x = between(before.1.z.as_slice()[i], after.1.z.as_slice()[i]);
    }
    let [s0, s1] = [before, after].map(|(_, x)| x.s.scalar().unwrap_or(R::from_f64(0.0)));
    system.jump(jump, Enclosure::constant, between(before.0, after.0), all, between(s0, s1)).map(|x| x.value)
}

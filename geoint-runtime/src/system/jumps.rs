//! Search for jumps of the energy, at conditions such as that of an `if`.
//!
//! A step that keeps the energy evaluates each condition at the end of the step. The returned state is rounded, and may lie on the other side of the
//! condition. If the energy jumps there, the step has not kept it.
//!
//! All other methods evaluate derivatives only, which do not show a jump. On both sides of the edge of a square well, for example, the force is zero.

use super::PhaseSpace;
use crate::scalar::{Enclosure, Interval, Real, bounds, signed};
use crate::space::{Action, Array, PerCoordinate, Snapshot};
use core::marker::PhantomData;

/// Returns the first jump of the energy between two points that differ by rounding. A condition holds at one of the points, and not at the other one.
///
/// Returns `None` if the energy has no jump there, or a jump that cannot be distinguished from rounding.
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

/// Returns the first jump of the energy on the straight line between the ends of a step. Only jumps by more than `part` times the energy count.
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
/// No flow crosses such a jump. If rounding crosses it, the correction of a step would include the jump. Energies are
/// different: a motion crosses a jump of a potential, and gains or loses speed.
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
    let crosses = |jump: &usize| Line { system, ends, jump: *jump, part }.crosses([0.0, 1.0], HALVINGS);
    (0..S::JUMPS.len()).find(crosses).map(|jump| S::JUMPS[jump])
}

/// After this many bisections, a part of the line has the length of the spacing of numbers near 1.
const HALVINGS: u32 = 52;

/// A line is bisected this many times before a condition with equal values at both ends counts as constant on the line.
const LEAST_HALVINGS: u32 = 8;

/// The straight line between two points, and the index of one condition.
struct Line<'a, S: PhaseSpace<R>, R: Real> {
    system: &'a S,
    ends: &'a [Moment<S, R>; 2],
    jump: usize,
    /// Jumps by less than this part of the energy do not count. `None` if each jump counts.
    part: Option<f64>,
}

/// The behaviour of a condition on a part of a line.
enum Condition {
    /// Proven to be constant, by interval arithmetic.
    Steady,
    /// Equal at both ends, but not proven to be constant.
    Same,
    /// Different at both ends.
    Changes,
}

impl<S: PhaseSpace<R>, R: Real> Line<'_, S, R> {
    /// Returns whether the energy jumps between two parts of the line. The line is bisected until intervals prove that the condition is constant, or until
    /// no number lies between the ends.
    fn crosses(&self, [from, to]: [f64; 2], left: u32) -> bool {
        match self.condition_on([from, to]) {
            Condition::Steady => false,
            Condition::Same if left <= HALVINGS - LEAST_HALVINGS => false,
            Condition::Changes if left == 0 => self.jumps([from, to]),
            _ => {
                let middle = 0.5 * (from + to);
                self.crosses([from, middle], left - 1) || self.crosses([middle, to], left - 1)
            }
        }
    }

    // Not inlined, so that the points, which may be large, are not on the stack during the recursion.
    #[inline(never)]
    fn condition_on(&self, ends: [f64; 2]) -> Condition {
        let [before, after] = ends.map(|part| self.at(part));
        let [side, _] = enclosed(self.system, self.jump, &before, &after);
        let side_of = |(t, x): &Moment<S, R>| {
            let s = x.s.scalar().unwrap_or(R::from_f64(0.0));
            signed(self.system.jump(self.jump, |parameter| parameter, *t, x.z.as_slice(), s)[0])
        };
        match () {
            () if !side.contains_zero() => Condition::Steady,
            () if side_of(&before) == side_of(&after) => Condition::Same,
            () => Condition::Changes,
        }
    }

    /// Returns whether the energy jumps between two neighbouring points.
    #[inline(never)]
    fn jumps(&self, ends: [f64; 2]) -> bool {
        let [before, after] = ends.map(|part| self.at(part));
        let [_, height] = enclosed(self.system, self.jump, &before, &after);
        let Some(part) = self.part else { return !height.contains_zero() };
        let [h0, h1] = [&before, &after].map(|(t, x)| self.system.hamiltonian(*t, &x.z, &x.s));
        let least = part.max(16.0 * R::epsilon()) * h0.magnitude().max(h1.magnitude());
        (h1 - h0).magnitude() > least && !height.contains_zero()
    }

    /// Returns the point at this part of the line, from 0 to 1.
    fn at(&self, part: f64) -> Moment<S, R> {
        let [(t, mut x), (end, after)] = *self.ends;
        let (before, after_part) = (R::from_f64(1.0 - part), R::from_f64(part));
        x.times(before);
        x.add_scaled(after_part, &after);
        (before * t + after_part * end, x)
    }
}

/// Constants about jumps, known at compile time.
struct Jumps<S, R>(PhantomData<(S, R)>);

impl<S: PhaseSpace<R>, R: Real> Jumps<S, R> {
    /// `true` if the system has no conditions. The search is then not compiled.
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

/// Returns intervals that enclose the side of a condition and the height of its jump in the box between two points.
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

//! Poles of the energy between the ends of a step.
//!
//! The equation of a step may have a solution across a pole, such as q = 0 of 1/q, although no motion leads there. An implicit step is therefore refused
//! unless each pole is excluded on the straight line between its ends: the function that vanishes at the pole must have no zero there. The proof is a quick
//! test by the structure of the function ([`clear_of_poles`](PhaseSpace::clear_of_poles)), else a search by intervals (`segment.rs`).
//!
//! Limits: the motion itself is no straight line. A step may be refused near a pole that it does not cross.

use super::PhaseSpace;
use super::segment::{Line, is_negative_somewhere, vanishes_nowhere};
use crate::scalar::{Enclosure, Interval, Real, bounds};
use crate::space::{Action, Array};
use core::marker::PhantomData;

/// A pole of an energy, given by the function [`vanishing`](PhaseSpace::vanishing) that is zero there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pole {
    /// The message of a refused step.
    pub what: &'static str,
    /// `true` if [`clear_of_poles`](PhaseSpace::clear_of_poles) has a quick test for the pole.
    pub by_structure: bool,
    /// `true` if the function reads a parameter. The values of the parameters may then exclude the pole, as m > 0 for 1/(m + q²).
    pub by_parameters: bool,
    /// `true` if the function reads time, and no coordinate. Explicit steps, and flows at frozen time, would cross the pole unnoticed: `timed.rs` searches
    /// for it.
    pub timed: bool,
    /// `true` for the boundary of a domain in place of a pole. The function must not be negative there.
    pub edge: bool,
    /// `true` if the mass matrix ∂²L/∂v² of a Lagrangian is singular there, or the form Ω of a Lagrangian that is linear in the velocities.
    pub of_mass: bool,
}

/// The evaluations of the energy in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Evaluations {
    /// At points of the line.
    AtPoints,
    /// Divided differences between the ends. A pole between them makes most differences infinite or NaN, so some poles need no test.
    ByDifferences,
}

/// Two points of phase space, each with its time: t, z, s.
pub(crate) type Ends<'a, S, R> = ([R; 2], [&'a <S as PhaseSpace<R>>::Phase; 2], [&'a <S as PhaseSpace<R>>::Action; 2]);

/// The poles of a system with given parameters.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Poles {
    /// `true` unless the parameters exclude all poles.
    any: bool,
    /// `true` if one of the remaining poles has no quick test, or if a parameter does not have the sign that the tests assume.
    need_search: bool,
}

impl Poles {
    /// Evaluates the parameters of a system.
    pub(crate) fn of<S: PhaseSpace<R>, R: Real>(system: &S) -> Self {
        if Known::<S, R>::NONE {
            return Poles { any: false, need_search: false };
        }
        let trusted = system.signs_hold();
        let open = |(i, pole): (usize, &Pole)| !(pole.by_parameters && is_nowhere(system, i));
        let poles = || S::POLES.iter().enumerate();
        Poles {
            any: poles().any(open),
            need_search: poles().any(|(i, pole)| !(trusted && pole.by_structure) && open((i, pole))),
        }
    }

    /// Returns whether all poles on the straight line between two points are excluded without a search.
    #[inline(always)]
    pub(crate) fn is_clear<S: PhaseSpace<R>, R: Real>(
        &self,
        system: &S,
        evaluations: Evaluations,
        (t, z, s): Ends<'_, S, R>,
    ) -> bool {
        if Known::<S, R>::NONE {
            return true;
        }
        let clear = || system.clear_of_poles(evaluations == Evaluations::ByDifferences, t, z, s);
        if Known::<S, R>::QUICK_TESTS_SUFFICE { clear() } else { !self.any || (!self.need_search && clear()) }
    }

    /// Returns the message of the first pole that is not excluded on the straight line between two points.
    #[inline(always)]
    pub(crate) fn between<S: PhaseSpace<R>, R: Real>(
        &self,
        system: &S,
        evaluations: Evaluations,
        (t, z, s): Ends<'_, S, R>,
    ) -> Option<&'static str> {
        // This constant comes first, so that a system without poles compiles no search.
        if Known::<S, R>::NONE {
            return None;
        }
        if self.is_clear(system, evaluations, (t, z, s)) {
            return None;
        }
        // The search reads copies in memory. The state of the step may then stay in registers.
        search(*system, t, copied(z), s.map(|s| *s), |_| true)
    }

    /// Returns the message of the first pole with a singular mass matrix that is not excluded on the straight line between two points. Explicit methods
    /// check only these poles.
    #[inline(always)]
    pub(crate) fn of_mass_between<S: PhaseSpace<R>, R: Real>(
        &self,
        system: &S,
        (t, z, s): Ends<'_, S, R>,
    ) -> Option<&'static str> {
        if !Known::<S, R>::OF_MASS || self.is_clear(system, Evaluations::AtPoints, (t, z, s)) {
            return None;
        }
        search(*system, t, copied(z), s.map(|s| *s), |pole| pole.of_mass)
    }
}

/// Copies of two points, entry by entry.
#[inline(always)]
fn copied<A: Array>([start, end]: [&A; 2]) -> [A; 2] {
    let mut copies = [A::zero(); 2];
    copies[0].copy_from(start);
    copies[1].copy_from(end);
    copies
}

/// Returns whether the parameters exclude a pole in all of phase space, and at all times.
fn is_nowhere<S: PhaseSpace<R>, R: Real>(system: &S, pole: usize) -> bool {
    !Path::<S, R>::anywhere(system, Line::WHOLE).vanishing(pole, Interval::new(0.0, 1.0)).0.contains_zero()
}

/// Returns the message of the first pole with the property `is_asked` that intervals do not exclude between two points. Returns `None` if a point is not
/// finite: such a step has another error.
#[cold]
#[inline(never)]
fn search<S: PhaseSpace<R>, R: Real>(
    system: S,
    t: [R; 2],
    z: [S::Phase; 2],
    s: [S::Action; 2],
    is_asked: impl Fn(&Pole) -> bool,
) -> Option<&'static str> {
    if !z.iter().all(Array::is_finite) {
        return None;
    }
    let path = Path::between(&system, t, &z, s);
    let open = |i: usize| is_asked(&S::POLES[i]) && !(S::POLES[i].by_parameters && is_nowhere(&system, i));
    first_not_excluded(S::POLES, &open, &|pole, part| path.vanishing(pole, part))
}

/// Returns the message of the first of the `open` poles that may be on a line. `vanishing` takes the index of a pole and a part of the line, and returns
/// the values and the rate of the function that vanishes there. Compiled once for all systems.
#[inline(never)]
fn first_not_excluded(
    poles: &[Pole],
    open: &dyn Fn(usize) -> bool,
    vanishing: &dyn Fn(usize, Interval) -> (Interval, Interval),
) -> Option<&'static str> {
    let met = |(i, pole): &(usize, &Pole)| {
        let term = |part: Interval| vanishing(*i, part);
        open(*i) && if pole.edge { is_negative_somewhere(&term) } else { !vanishes_nowhere(&term) }
    };
    poles.iter().enumerate().find(met).map(|(_, pole)| pole.what)
}

/// A straight line in phase space, with the parameter 0 at its start and 1 at its end.
struct Path<'a, S: PhaseSpace<R>, R: Real> {
    system: &'a S,
    t: Line,
    z: <S::Phase as Array>::Map<Line>,
    s: Line,
}

impl<'a, S: PhaseSpace<R>, R: Real> Path<'a, S, R> {
    /// Returns the line between two points.
    fn between(system: &'a S, t: [R; 2], z: &[S::Phase; 2], s: [S::Action; 2]) -> Self {
        let mut path = Self::anywhere(system, line(t));
        path.s = line(s.map(|s| s.scalar().unwrap_or(R::from_f64(0.0))));
        lines(z[0].as_slice(), z[1].as_slice(), S::Phase::entries(&mut path.z));
        path
    }

    /// Returns the bundle of all lines with these times: z and s may have any values.
    fn anywhere(system: &'a S, t: Line) -> Self {
        Path { system, t, z: S::Phase::fill(Line::WHOLE), s: Line::WHOLE }
    }

    /// Returns the values and the rate of the function that vanishes at a pole, on a part of the line. The rate is the derivative by the line parameter.
    #[inline(never)]
    fn vanishing(&self, pole: usize, part: Interval) -> (Interval, Interval) {
        let on = |line: &Line| {
            let (value, rate) = line.on(part);
            Enclosure::<R>::new(value, rate)
        };
        let t = on(&self.t);
        let mut z = S::Phase::fill(t);
        let z = S::Phase::entries(&mut z);
        for (z, line) in z.iter_mut().zip(S::Phase::entries_of(&self.z)) {
            *z = on(line);
        }
        let Enclosure { value, rate, .. } = self.system.vanishing(pole, Enclosure::constant, t, z, on(&self.s));
        (value, rate)
    }
}

/// Returns the line between two values of a coordinate.
#[inline(never)]
fn line<R: Real>(ends: [R; 2]) -> Line {
    Line::new(ends.map(bounds))
}

/// Writes the lines of all coordinates to `lines`.
#[inline(never)]
fn lines<R: Real>(start: &[R], end: &[R], lines: &mut [Line]) {
    for (along, (start, end)) in lines.iter_mut().zip(start.iter().zip(end)) {
        *along = line([*start, *end]);
    }
}

/// Returns the addresses of functions that depend on the scalar only, so that this crate compiles them.
pub(crate) fn compiled<R: Real>() -> [*const (); 2] {
    [line::<R> as *const (), lines::<R> as *const ()]
}

/// Properties of the poles of a system that are known at compile time.
pub(crate) struct Known<S, R>(PhantomData<(S, R)>);

impl<S: PhaseSpace<R>, R: Real> Known<S, R> {
    /// `true` if there are no poles.
    pub(crate) const NONE: bool = S::POLES.is_empty();

    /// `true` if a pole has [`Pole::timed`].
    pub(super) const TIMED: bool = {
        let (mut any, mut i) = (false, 0);
        while i < S::POLES.len() {
            any |= S::POLES[i].timed;
            i += 1;
        }
        any
    };

    /// `true` if a pole has [`Pole::of_mass`].
    pub(crate) const OF_MASS: bool = {
        let (mut any, mut i) = (false, 0);
        while i < S::POLES.len() {
            any |= S::POLES[i].of_mass;
            i += 1;
        }
        any
    };

    /// `true` if all poles have quick tests, and no function reads a parameter.
    const QUICK_TESTS_SUFFICE: bool = {
        let (mut all, mut i) = (true, 0);
        while i < S::POLES.len() {
            all &= S::POLES[i].by_structure && !S::POLES[i].by_parameters;
            i += 1;
        }
        all
    };

    /// `true` if a pole has no quick test.
    pub(crate) const SEARCHED: bool = {
        let (mut any, mut i) = (false, 0);
        while i < S::POLES.len() {
            any |= !S::POLES[i].by_structure;
            i += 1;
        }
        any
    };
}

/// Returns the message of the first pole with [`Pole::timed`] that is not excluded after the time `t[0]` and up to and including `t[1]`.
#[inline(never)]
pub(super) fn search_time<S: PhaseSpace<R>, R: Real>(system: &S, t: [R; 2]) -> Option<&'static str> {
    let path = Path::anywhere(system, line(t));
    first_not_excluded(S::POLES, &|i| S::POLES[i].timed, &|pole, part| path.vanishing(pole, part))
}

//! Poles of the energy between the ends of a step.
//!
//! An implicit step is accepted where what vanishes at the poles is proven to have no zero on the straight line between its ends: by its
//! structure, else by intervals. What cannot be proven is refused.

use super::PhaseSpace;
use super::segment::{Line, is_negative_somewhere, vanishes_nowhere};
use crate::scalar::{Enclosure, Interval, Real, bounds};
use crate::space::{Action, Array};
use core::marker::PhantomData;

/// A pole of an energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pole {
    /// What a refused step says.
    pub what: &'static str,
    /// Whether [`clear_of_poles`](PhaseSpace::clear_of_poles) decides by structure.
    pub by_structure: bool,
    /// Whether the parameters alone may rule it out, as m of 1/(m + q²).
    pub by_parameters: bool,
    /// Whether it depends on time alone: explicit steps, and flows at frozen time, do not notice it.
    pub timed: bool,
    /// Whether it is no pole but the edge of a domain: what vanishes there must not be negative.
    pub edge: bool,
    /// Whether the mass matrix ∂²L/∂v² of a Lagrangian is singular there, or the form Ω of one that is linear in velocities.
    pub of_mass: bool,
}

/// Two points of phase space, each with its time: t, z, s.
pub(crate) type Ends<'a, S, R> = ([R; 2], [&'a <S as PhaseSpace<R>>::Phase; 2], [&'a <S as PhaseSpace<R>>::Action; 2]);

/// What the parameters of a system say of its poles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Poles {
    /// Whether there may be a pole anywhere.
    open: bool,
    /// Whether there may be one of which the structure says nothing.
    searched: bool,
}

impl Poles {
    pub(crate) fn of<S: PhaseSpace<R>, R: Real>(system: &S) -> Self {
        if Known::<S, R>::NONE {
            return Poles { open: false, searched: false };
        }
        let trusted = system.signs_hold();
        let open = |(i, pole): (usize, &Pole)| !(pole.by_parameters && is_nowhere(system, i));
        let poles = || S::POLES.iter().enumerate();
        Poles {
            open: poles().any(open),
            searched: poles().any(|(i, pole)| !(trusted && pole.by_structure) && open((i, pole))),
        }
    }

    /// Whether it is known, without a search, that there is no pole on the straight line between two points; `divided` as in
    /// [`clear_of_poles`](PhaseSpace::clear_of_poles).
    #[inline(always)]
    pub(crate) fn is_clear<S: PhaseSpace<R>, R: Real>(
        &self,
        system: &S,
        divided: bool,
        (t, z, s): Ends<'_, S, R>,
    ) -> bool {
        if Known::<S, R>::NONE {
            return true;
        }
        let clear = || system.clear_of_poles(divided, t, z, s);
        if Known::<S, R>::FIXED { clear() } else { !self.open || (!self.searched && clear()) }
    }

    /// The first pole, if any, that cannot be ruled out there.
    #[inline(always)]
    pub(crate) fn between<S: PhaseSpace<R>, R: Real>(
        &self,
        system: &S,
        divided: bool,
        (t, z, s): Ends<'_, S, R>,
    ) -> Option<&'static str> {
        // The constant first: nothing of a search is compiled then.
        if Known::<S, R>::NONE {
            return None;
        }
        if self.is_clear(system, divided, (t, z, s)) {
            return None;
        }
        // Copies: what is searched is in memory, and a step would otherwise keep its state there.
        search(*system, t, copied(z), s.map(|s| *s), |_| true)
    }

    /// Returns the first pole, if any, at which a mass matrix is singular and which cannot be ruled out there. Explicit methods ask for these
    /// alone.
    #[inline(always)]
    pub(crate) fn of_mass_between<S: PhaseSpace<R>, R: Real>(
        &self,
        system: &S,
        (t, z, s): Ends<'_, S, R>,
    ) -> Option<&'static str> {
        if !Known::<S, R>::OF_MASS || self.is_clear(system, false, (t, z, s)) {
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

/// Whether a pole is ruled out in all of phase space.
fn is_nowhere<S: PhaseSpace<R>, R: Real>(system: &S, pole: usize) -> bool {
    !Way::<S, R>::anywhere(system, Line::WHOLE).vanishing(pole, Interval::new(0.0, 1.0)).0.contains_zero()
}

/// The first pole, if any, that intervals cannot rule out. Points that are not finite are no question of poles.
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
    let way = Way::between(&system, t, &z, s);
    let open = |i: usize| is_asked(&S::POLES[i]) && !(S::POLES[i].by_parameters && is_nowhere(&system, i));
    first(S::POLES, &open, &|pole, part| way.vanishing(pole, part))
}

/// The first of the open poles, if any, that may be on a way. Here once for all systems.
#[inline(never)]
fn first(
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

/// A straight line in phase space.
struct Way<'a, S: PhaseSpace<R>, R: Real> {
    system: &'a S,
    t: Line,
    z: <S::Phase as Array>::Map<Line>,
    s: Line,
}

impl<'a, S: PhaseSpace<R>, R: Real> Way<'a, S, R> {
    fn between(system: &'a S, t: [R; 2], z: &[S::Phase; 2], s: [S::Action; 2]) -> Self {
        let mut way = Self::anywhere(system, line(t));
        way.s = line(s.map(|s| s.scalar().unwrap_or(R::from_f64(0.0))));
        lines(z[0].as_slice(), z[1].as_slice(), S::Phase::entries(&mut way.z));
        way
    }

    /// A way of which nothing but time is known.
    fn anywhere(system: &'a S, t: Line) -> Self {
        Way { system, t, z: S::Phase::fill(Line::WHOLE), s: Line::WHOLE }
    }

    /// What vanishes at a pole, and its rate, on a part of the way.
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

/// From one value of a coordinate to another.
#[inline(never)]
fn line<R: Real>(ends: [R; 2]) -> Line {
    Line::new(ends.map(bounds))
}

/// The same for all coordinates.
#[inline(never)]
fn lines<R: Real>(start: &[R], end: &[R], lines: &mut [Line]) {
    for (way, (start, end)) in lines.iter_mut().zip(start.iter().zip(end)) {
        *way = line([*start, *end]);
    }
}

/// The addresses of what is compiled once for a scalar.
pub(crate) fn compiled<R: Real>() -> [*const (); 2] {
    [line::<R> as *const (), lines::<R> as *const ()]
}

/// What is known of the poles of a system at compile time.
pub(crate) struct Known<S, R>(PhantomData<(S, R)>);

impl<S: PhaseSpace<R>, R: Real> Known<S, R> {
    /// Whether there are no poles.
    pub(crate) const NONE: bool = S::POLES.is_empty();

    /// Whether there are poles in time alone.
    pub(super) const TIMED: bool = {
        let (mut any, mut i) = (false, 0);
        while i < S::POLES.len() {
            any |= S::POLES[i].timed;
            i += 1;
        }
        any
    };

    /// Whether there are poles at which a mass matrix is singular.
    pub(crate) const OF_MASS: bool = {
        let (mut any, mut i) = (false, 0);
        while i < S::POLES.len() {
            any |= S::POLES[i].of_mass;
            i += 1;
        }
        any
    };

    /// Whether the structure decides, whatever the parameters are.
    const FIXED: bool = {
        let (mut all, mut i) = (true, 0);
        while i < S::POLES.len() {
            all &= S::POLES[i].by_structure && !S::POLES[i].by_parameters;
            i += 1;
        }
        all
    };

    /// Whether there are poles of which the structure says nothing.
    pub(crate) const SEARCHED: bool = {
        let (mut any, mut i) = (false, 0);
        while i < S::POLES.len() {
            any |= !S::POLES[i].by_structure;
            i += 1;
        }
        any
    };
}

/// The first pole in time alone, if any, that cannot be ruled out behind one time and up to another, with it.
#[inline(never)]
pub(super) fn search_time<S: PhaseSpace<R>, R: Real>(system: &S, t: [R; 2]) -> Option<&'static str> {
    let way = Way::anywhere(system, line(t));
    first(S::POLES, &|i| S::POLES[i].timed, &|pole, part| way.vanishing(pole, part))
}

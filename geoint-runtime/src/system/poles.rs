//! Poles of the energy between the ends of a step.
//!
//! An implicit step is accepted where what vanishes at the poles is proven to have no zero on the straight line between its ends: by its
//! structure, else by intervals. What cannot be proven is refused.

use super::PhaseSpace;
use crate::scalar::{Enclosure, Interval, Real, bounds};
use crate::solving::segment::vanishes_nowhere;
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
    /// Whether it depends on time alone: no flow at frozen time notices it.
    pub timed: bool,
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
        if S::POLES.is_empty() {
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
        if self.is_clear(system, divided, (t, z, s)) {
            return None;
        }
        // Copies: what is searched is in memory, and a step would otherwise keep its state there.
        search(*system, t, copied(z), s.map(|s| *s))
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
    let anything = Enclosure::<R>::new(Interval::WHOLE, Interval::WHOLE);
    let mut all = S::Phase::fill(anything);
    let all = S::Phase::entries(&mut all);
    !system.vanishing(pole, Enclosure::constant, anything, all, anything).value.contains_zero()
}

/// The first pole, if any, that intervals cannot rule out. Points that are not finite are no question of poles.
#[cold]
#[inline(never)]
fn search<S: PhaseSpace<R>, R: Real>(
    system: S,
    t: [R; 2],
    z: [S::Phase; 2],
    s: [S::Action; 2],
) -> Option<&'static str> {
    if !z.iter().all(Array::is_finite) {
        return None;
    }
    let t = Line::new(t);
    let s = Line::new(s.map(|s| s.scalar().unwrap_or(R::from_f64(0.0))));
    let open = |(i, pole): &(usize, &Pole)| !(pole.by_parameters && is_nowhere(&system, *i));
    let clear = |(i, _): &(usize, &Pole)| {
        vanishes_nowhere(|part| {
            let mut on = S::Phase::fill(t.on(part));
            let on = S::Phase::entries(&mut on);
            for (j, on) in on.iter_mut().enumerate() {
                *on = Line::new([z[0].as_slice()[j], z[1].as_slice()[j]]).on(part);
            }
            system.vanishing(*i, Enclosure::constant, t.on(part), on, s.on(part))
        })
    };
    S::POLES.iter().enumerate().filter(open).find(|pole| !clear(pole)).map(|(_, pole)| pole.what)
}

/// What is known of the poles of a system at compile time.
pub(crate) struct Known<S, R>(PhantomData<(S, R)>);

impl<S: PhaseSpace<R>, R: Real> Known<S, R> {
    /// Whether there are poles in time alone.
    const TIMED: bool = {
        let (mut any, mut i) = (false, 0);
        while i < S::POLES.len() {
            any |= S::POLES[i].timed;
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
#[inline(always)]
pub(crate) fn singular_time<S: PhaseSpace<R>, R: Real>(system: &S, t: [R; 2]) -> Option<&'static str> {
    if Known::<S, R>::TIMED { search_time(system, t) } else { None }
}

/// The same, searched.
fn search_time<S: PhaseSpace<R>, R: Real>(system: &S, t: [R; 2]) -> Option<&'static str> {
    let t = Line::new(t);
    let anything = Enclosure::new(Interval::WHOLE, Interval::WHOLE);
    let clear = |i: usize| {
        vanishes_nowhere(|part| {
            let mut all = S::Phase::fill(anything);
            let all = S::Phase::entries(&mut all);
            system.vanishing(i, Enclosure::constant, t.on(part), all, anything)
        })
    };
    let timed = S::POLES.iter().enumerate().filter(|(_, pole)| pole.timed);
    timed.filter(|(i, _)| !clear(*i)).map(|(_, pole)| pole.what).next()
}

/// A coordinate on the way from one value to another.
#[derive(Clone, Copy)]
struct Line<R> {
    ends: [Interval; 2],
    scalar: PhantomData<R>,
}

impl<R: Real> Line<R> {
    fn new(ends: [R; 2]) -> Self {
        Line { ends: ends.map(bounds), scalar: PhantomData }
    }

    /// On a part of the way from 0 to 1.
    fn on(&self, part: Interval) -> Enclosure<R> {
        let [start, end] = self.ends;
        let change = end - start;
        let at = |x: f64| match x {
            0.0 => start,
            1.0 => end,
            _ => start + change * Interval::point(x),
        };
        Enclosure::new(at(part.low).hull(at(part.high)), change)
    }
}

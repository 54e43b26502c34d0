//! A point of phase space while it moves: its coordinates, and how increments are added to them.

use super::array::Array;
use super::double_word::DoubleWord;
use super::per_coordinate::PerCoordinate;
use super::record::{Record, Tape};
use super::state::Action;
use super::summation::{Summation, add_compensated};
use crate::scalar::{Real, zero};

/// A point with sums of kind `C`, and an action if its space has one.
#[derive(Clone, Copy, Debug)]
pub struct Point<Z: Array, C, S = ()> {
    /// All coordinates: [q, p], or x.
    pub z: Z,
    /// The action of a contact system.
    pub s: S,
    pub(crate) sums: C,
    /// What s is too small by, where sums compensate.
    pub(crate) compensation: S,
    /// How far time is ahead of t₀ + n·h: methods that scale their steps say so here.
    pub ahead: DoubleWord<Z::Real>,
    /// A step of the fast path can not tell that it was good: it is to be repeated, watched.
    pub(crate) needs_recheck: bool,
}

impl<Z: Array, C: Summation<Z>, S: Action<Z::Real>> Point<Z, C, S> {
    /// A point without rounding errors so far.
    pub fn with_action(z: Z, s: S) -> Self {
        Point { z, s, sums: C::new(), compensation: S::zero(), ahead: DoubleWord::new(zero()), needs_recheck: false }
    }

    /// The same point with sums of another kind, without rounding errors so far.
    pub(crate) fn with_sums<D: Summation<Z>>(self) -> Point<Z, D, S> {
        Point { ahead: self.ahead, ..Point::with_action(self.z, self.s) }
    }

    /// Whether every coordinate is a finite number, and no step is in doubt.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        !self.needs_recheck && self.z.is_finite() && self.s.is_finite()
    }

    /// z ← z + dz.
    #[inline(always)]
    pub fn add(&mut self, dz: &Z) {
        self.sums.add(&mut self.z, |z| z.add_scaled(Z::Real::from_f64(1.0), dz));
    }

    /// The same for every coordinate, the action too.
    #[inline(always)]
    pub(crate) fn add_everywhere(&mut self, d: &PerCoordinate<Z, S>) {
        self.add(&d.z);
        add_action::<Z, C, S>(&mut self.s, &mut self.compensation, d.s);
    }

    /// Adds to the action.
    #[inline(always)]
    pub(crate) fn add_action(&mut self, ds: S) {
        add_action::<Z, C, S>(&mut self.s, &mut self.compensation, ds);
    }

    /// Adds a correction to a step that led from `before` by `moved` to here: both together, with sums of the method's own unless those
    /// of the point compensate.
    #[inline(always)]
    pub(crate) fn correct<D: Summation<Z>>(&mut self, sums: &mut D, before: &Z, moved: &Z, correction: &Z) {
        if !C::PLAIN {
            return self.add(correction);
        }
        self.z = *before;
        let mut whole = *moved;
        whole.add_scaled(Z::Real::from_f64(1.0), correction);
        self.add_with(sums, &whole, &Z::zero());
    }

    /// The same, with sums of the method's own unless those of the point compensate: those outlive a change of the step size.
    /// `rounding_error` is the rounding error of dz.
    #[inline(always)]
    pub fn add_with<D: Summation<Z>>(&mut self, sums: &mut D, dz: &Z, rounding_error: &Z) {
        if !C::PLAIN {
            self.add(dz);
            return self.sums.compensate(rounding_error);
        }
        sums.add(&mut self.z, |z| z.add_scaled(Z::Real::from_f64(1.0), dz));
        sums.compensate(rounding_error);
    }

    /// Copies what sums have lost, if they compensate.
    #[inline(always)]
    pub(crate) fn lost_to(&self, lost: &mut PerCoordinate<Z, S>) {
        if !C::PLAIN {
            *lost = PerCoordinate { z: self.sums.compensation(), s: self.compensation };
        }
    }
}

impl<Z: Array, C: Summation<Z>> Point<Z, C> {
    /// A point without rounding errors so far.
    pub fn new(z: Z) -> Self {
        Self::with_action(z, ())
    }
}

impl<Z: Array, S: Action<Z::Real>> PerCoordinate<Z, S> {
    /// The coordinates of a point.
    #[inline(always)]
    pub(crate) fn of<C>(x: &Point<Z, C, S>) -> Self {
        PerCoordinate { z: x.z, s: x.s }
    }
}

/// s ← s + ds, if there is an action.
#[inline(always)]
pub(crate) fn add_action<Z: Array, C: Summation<Z>, S: Action<Z::Real>>(s: &mut S, compensation: &mut S, ds: S) {
    for ((s, compensation), ds) in s.numbers_mut().iter_mut().zip(compensation.numbers_mut()).zip(ds.numbers()) {
        if C::PLAIN {
            *s += *ds;
        } else {
            add_compensated(s, compensation, *ds);
        }
    }
}

/// Coordinates, the action, what sums have lost of both, and how far time is ahead.
impl<Z: Array, C: Summation<Z>, S: Action<Z::Real>> Record<Z::Real> for Point<Z, C, S> {
    fn record(&mut self, tape: &mut impl Tape<Z::Real>) {
        tape.array(&mut self.z);
        self.s.numbers_mut().iter_mut().for_each(|s| tape.scalar(s));
        self.sums.record(tape);
        self.compensation.numbers_mut().iter_mut().for_each(|s| tape.scalar(s));
        self.ahead.record(tape);
        tape.flag(&mut self.needs_recheck);
    }
}

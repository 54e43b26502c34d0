//! A moving point of phase space: its coordinates, and the sums that add increments to them.

use super::array::Array;
use super::double_word::DoubleWord;
use super::per_coordinate::PerCoordinate;
use super::record::{Record, Tape};
use super::state::Action;
use super::summation::{Summation, add_compensated};
use crate::scalar::{Real, zero};

/// A point with sums of type `C`, and an action if the system has one.
#[derive(Clone, Copy, Debug)]
pub struct Point<Z: Array, C, S = ()> {
    /// All coordinates: [q, p], or x.
    pub z: Z,
    /// The action of a contact system.
    pub s: S,
    pub(crate) sums: C,
    /// The rounding error of s, which is to be added to s. Used by compensated sums.
    pub(crate) compensation: S,
    /// The time minus t₀ + n·h. Not zero for methods that scale their steps.
    pub ahead: DoubleWord<Z::Real>,
    /// A quick step could not verify its result. It is repeated with all checks.
    pub(crate) needs_recheck: bool,
}

impl<Z: Array, C: Summation<Z>, S: Action<Z::Real>> Point<Z, C, S> {
    /// Returns a point with an action, and with compensations of zero.
    pub fn with_action(z: Z, s: S) -> Self {
        Point { z, s, sums: C::new(), compensation: S::zero(), ahead: DoubleWord::new(zero()), needs_recheck: false }
    }

    /// Returns this point with sums of another type, and with compensations of zero.
    pub(crate) fn with_sums<D: Summation<Z>>(self) -> Point<Z, D, S> {
        Point { ahead: self.ahead, ..Point::with_action(self.z, self.s) }
    }

    /// Returns whether all coordinates are finite, and no step needs a recheck.
    #[inline(always)]
    pub fn is_finite(&self) -> bool {
        !self.needs_recheck && self.z.is_finite() && self.s.is_finite()
    }

    /// z ← z + dz.
    #[inline(always)]
    pub fn add(&mut self, dz: &Z) {
        self.sums.add(&mut self.z, |z| z.add_scaled(Z::Real::from_f64(1.0), dz));
    }

    /// Adds increments to all coordinates and to the action.
    #[inline(always)]
    pub(crate) fn add_everywhere(&mut self, d: &PerCoordinate<Z, S>) {
        self.add(&d.z);
        add_action::<Z, C, S>(&mut self.s, &mut self.compensation, d.s);
    }

    /// Adds an increment to the action.
    #[inline(always)]
    pub(crate) fn add_action(&mut self, ds: S) {
        add_action::<Z, C, S>(&mut self.s, &mut self.compensation, ds);
    }

    /// Adds a correction to a step from `before` with the increment `moved`.
    ///
    /// If the sums of the point are not compensated, the step is undone. Increment and correction are then added together by the method's own `sums`.
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

    /// z ← z + dz. `rounding_error` is the rounding error of dz.
    ///
    /// Uses the method's own `sums` if the sums of the point are not compensated. The sums of the point persist if the step size changes.
    #[inline(always)]
    pub fn add_with<D: Summation<Z>>(&mut self, sums: &mut D, dz: &Z, rounding_error: &Z) {
        if !C::PLAIN {
            self.add(dz);
            return self.sums.compensate(rounding_error);
        }
        sums.add(&mut self.z, |z| z.add_scaled(Z::Real::from_f64(1.0), dz));
        sums.compensate(rounding_error);
    }

    /// Copies the compensations to `lost`, if the sums are compensated.
    #[inline(always)]
    pub(crate) fn lost_to(&self, lost: &mut PerCoordinate<Z, S>) {
        if !C::PLAIN {
            *lost = PerCoordinate { z: self.sums.compensation(), s: self.compensation };
        }
    }
}

impl<Z: Array, C: Summation<Z>> Point<Z, C> {
    /// Returns a point without an action, and with compensations of zero.
    pub fn new(z: Z) -> Self {
        Self::with_action(z, ())
    }
}

impl<Z: Array, S: Action<Z::Real>> PerCoordinate<Z, S> {
    /// Returns the coordinates of a point.
    #[inline(always)]
    pub(crate) fn of<C>(x: &Point<Z, C, S>) -> Self {
        PerCoordinate { z: x.z, s: x.s }
    }
}

/// s ← s + ds, if the system has an action.
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

/// Records the coordinates, the action, the compensations of both, `ahead` and `needs_recheck`.
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

//! The points of a step: departure, stages, increments, and arrival.

use crate::scalar::Real;
use crate::space::Array;
use crate::system::PhaseSpace;

/// The point from which a step leads.
#[derive(Debug)]
pub struct Departure<'a, S: PhaseSpace<R>, R: Real> {
    /// The system with its parameters.
    pub system: &'a S,
    /// The time at the start of the step.
    pub t: R,
    /// The time at its end, which is the start of the next step. It differs from t + h by a rounding.
    pub end: R,
    /// The length of the step.
    pub h: R,
    /// Coordinates at the start.
    pub z: S::Phase,
    /// The action at the start.
    pub s: S::Action,
    /// The compensation of the sums: the coordinates are z + `compensation`. Zero if neither the run nor the method compensates.
    pub compensation: S::Phase,
}

impl<S: PhaseSpace<R>, R: Real> Clone for Departure<'_, S, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: PhaseSpace<R>, R: Real> Copy for Departure<'_, S, R> {}

impl<S: PhaseSpace<R>, R: Real> Departure<'_, S, R> {
    /// The time in the middle of the step.
    #[inline(always)]
    pub fn middle(&self) -> R {
        self.t + R::from_f64(0.5) * self.h
    }
}

/// The increments of the state in a step.
#[derive(Clone, Copy, Debug)]
pub struct Increment<Z, A> {
    /// The increments of coordinates.
    pub z: Z,
    /// The increment of the action.
    pub s: A,
    /// The part of the increments of coordinates that was lost by rounding: the exact increments are z + `lost`. Only methods with
    /// compensated sums add it.
    pub lost: Z,
}

impl<Z: Array> Increment<Z, ()> {
    /// Returns the increments of a system without an action, without a rounding error.
    #[inline(always)]
    pub fn of(z: Z) -> Self {
        Increment { z, s: (), lost: Z::zero() }
    }
}

/// A point that a step evaluates, and reaches without crossing a pole.
pub struct Stage<S: PhaseSpace<R>, R: Real> {
    /// Its time.
    pub t: R,
    /// Its coordinates.
    pub z: S::Phase,
    /// Its action.
    pub s: S::Action,
}

/// The end of a step, which a method may refuse.
pub struct Arrival<'a, S: PhaseSpace<R>, R: Real> {
    /// Coordinates.
    pub z: &'a S::Phase,
    /// The action.
    pub s: &'a S::Action,
    /// Set it to true if a fast attempt cannot verify the step. The caller then repeats the step thoroughly.
    pub doubtful: &'a mut bool,
}

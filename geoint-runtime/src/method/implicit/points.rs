//! The points of a step: where it starts, what it passes, what it adds, and where it ends.

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
    /// The time at its end, which is when the next one starts: t + h, but for rounding.
    pub end: R,
    /// The length of the step.
    pub h: R,
    /// Coordinates at the start.
    pub z: S::Phase,
    /// The action at the start.
    pub s: S::Action,
    /// What z is too small by, where sums compensate.
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

/// What a step adds to the state.
#[derive(Clone, Copy, Debug)]
pub struct Increment<Z, A> {
    /// The increments of coordinates.
    pub z: Z,
    /// The increment of the action.
    pub s: A,
    /// The rounding error of the increments of coordinates.
    pub lost: Z,
}

impl<Z: Array> Increment<Z, ()> {
    /// The increment of a system without an action.
    #[inline(always)]
    pub fn of(z: Z) -> Self {
        Increment { z, s: (), lost: Z::zero() }
    }
}

/// A point that a step evaluates, or passes.
pub struct Stage<S: PhaseSpace<R>, R: Real> {
    /// Its time.
    pub t: R,
    /// Its coordinates.
    pub z: S::Phase,
    /// Its action.
    pub s: S::Action,
}

/// The end of a step, where a method looks for reasons to refuse it.
pub struct Arrival<'a, S: PhaseSpace<R>, R: Real> {
    /// Coordinates.
    pub z: &'a S::Phase,
    /// The action.
    pub s: &'a S::Action,
    /// Is set where a step of the fast path cannot tell that it was good. The step is then repeated with more effort.
    pub doubtful: &'a mut bool,
}

//! The points of an implicit step: its start, its stages, the increments, and its end. The driver exchanges them with an [`ImplicitStep`](super::ImplicitStep).

use crate::scalar::Real;
use crate::space::Array;
use crate::system::PhaseSpace;

/// The start of a step, with its times.
#[derive(Debug)]
pub struct Departure<'a, S: PhaseSpace<R>, R: Real> {
    /// The system with its parameters.
    pub system: &'a S,
    /// The time at the start of the step.
    pub t: R,
    /// The time at its end, which is the start of the next step bit for bit. It may differ from t + h by a rounding.
    pub end: R,
    /// The length of the step.
    pub h: R,
    /// Coordinates at the start.
    pub z: S::Phase,
    /// The action s at the start. `()` for a system without an action.
    pub s: S::Action,
    /// The compensation of the sums: the exact coordinates are z + `compensation`. Zero if neither the run nor the method compensates.
    pub compensation: S::Phase,
}

impl<S: PhaseSpace<R>, R: Real> Clone for Departure<'_, S, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: PhaseSpace<R>, R: Real> Copy for Departure<'_, S, R> {}

impl<S: PhaseSpace<R>, R: Real> Departure<'_, S, R> {
    /// Returns the time t + h/2 in the middle of the step. It follows from h, as the coefficients of the step do. The mean of t and
    /// [`end`](Self::end) may differ by a rounding.
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
    /// The exact increments of coordinates are z + `rounding_error`. The driver reads it only with [`Sums::Compensated`](super::Sums::Compensated).
    pub rounding_error: Z,
}

impl<Z: Array, A> Increment<Z, A> {
    /// Returns increments without a rounding error.
    #[inline(always)]
    pub fn of(z: Z, s: A) -> Self {
        Increment { z, s, rounding_error: Z::zero() }
    }
}

/// A point at which a step evaluates the energy. The step is refused if the energy may have a pole on the straight line from the start to this point.
/// A method declares no stage if its other checks cover the way.
pub struct Stage<S: PhaseSpace<R>, R: Real> {
    /// Its time.
    pub t: R,
    /// Its coordinates.
    pub z: S::Phase,
    /// Its action.
    pub s: S::Action,
}

/// The rounded end of a step, at the time [`Departure::end`]. A method may refuse it in [`ImplicitStep::finish`](super::ImplicitStep::finish).
pub struct Arrival<'a, S: PhaseSpace<R>, R: Real> {
    /// Coordinates.
    pub z: &'a S::Phase,
    /// The action.
    pub s: &'a S::Action,
    /// Set to true by a method that cannot verify the step in a fast attempt. The caller then repeats the step with
    /// [`Effort::Thorough`](crate::method::Effort::Thorough). It may be true already, by a check of poles, and is never reset to false.
    pub needs_recheck: &'a mut bool,
}

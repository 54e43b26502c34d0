//! An equation for code that does not know its type: the residual is called through a pointer, and the other values are copied.
//!
//! The long searches of [`rescue`](super::rescue) are therefore compiled once for all equations with unknowns of the same shape. The cost is an indirect call
//! for each evaluation.

use super::equation::{Magnitudes, StepEquation};
use super::rounding::Convergence;
use super::{Effort, Observer};
use crate::space::{Array, Square};

/// The results of the functions of a [`StepEquation`] that a search reads, under their names, and the convergence of its iteration.
#[derive(Clone, Copy)]
pub(super) struct Distant<A> {
    pub(super) origin: A,
    /// The guess from the start of the step, or zero if this guess is not finite.
    pub(super) guess: A,
    pub(super) standstill: f64,
    pub(super) is_bound_by_energy: bool,
    pub(super) effort: Effort,
    pub(super) magnitudes: Magnitudes,
    pub(super) convergence: Convergence,
}

/// A residual r(x) for calls through a pointer, with the observer of its points.
pub(super) trait Residual<A: Array>: Observer {
    /// Returns r(x), and writes its derivative to `matrix`.
    fn at(&mut self, x: &A, matrix: &mut Square<A>) -> A;
}

/// The residual of `equation`. The observer `watch` receives its points.
pub(super) struct ResidualOf<'a, E, W: ?Sized> {
    pub(super) equation: E,
    pub(super) watch: &'a mut W,
}

impl<E, W: Observer + ?Sized> Observer for ResidualOf<'_, E, W> {
    fn pause(&mut self, paused: bool) {
        self.watch.pause(paused);
    }
}

impl<A: Array, W: Observer + ?Sized, E: StepEquation<A, W>> Residual<A> for ResidualOf<'_, E, W> {
    fn at(&mut self, x: &A, matrix: &mut Square<A>) -> A {
        self.equation.residual(self.watch, x, matrix)
    }
}

//! A *distant* equation: its residual is called through a pointer, and its other values are copied.
//!
//! The long searches of [`rescue`](super::rescue) are therefore compiled once for all equations with unknowns of the same shape. The price is an indirect call
//! for each evaluation.

use super::equation::{Magnitudes, StepEquation};
use super::rounding::Convergence;
use super::{Effort, Observer};
use crate::space::{Array, Square};

/// The values of a [`StepEquation`] that a search reads, and the convergence of its iteration.
#[derive(Clone, Copy)]
pub(super) struct Distant<A> {
    pub(super) origin: A,
    pub(super) guess: A,
    pub(super) standstill: f64,
    pub(super) is_bound_by_energy: bool,
    pub(super) effort: Effort,
    pub(super) magnitudes: Magnitudes,
    pub(super) convergence: Convergence,
}

/// A residual r(x) that is called through a pointer.
pub(super) trait Residual<A: Array>: Observer {
    /// Returns r(x), and writes its derivative to `matrix`.
    fn at(&mut self, x: &A, matrix: &mut Square<A>) -> A;
}

/// The residual of `equation`, with its observer `watch`.
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

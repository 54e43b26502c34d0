//! Equations behind pointers. Rescues are compiled once for all equations with the same number of unknowns.

use super::equation::{Magnitudes, StepEquation};
use super::rounding::Convergence;
use super::{Effort, Observer};
use crate::space::{Array, Square};

/// The parts of an equation that a rescue reads.
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

/// The residual of an equation behind a pointer.
pub(super) trait Residual<A: Array>: Observer {
    /// Returns r(x), and writes its derivative to `matrix`.
    fn at(&mut self, x: &A, matrix: &mut Square<A>) -> A;
}

/// The residual of one equation, and who watches.
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

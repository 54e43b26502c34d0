//! What an implicit step solves.

use crate::space::vector::difference;
use crate::space::{Array, Square};

/// An equation x = g(x) for the increment of a step. `W` watches where g is evaluated.
///
/// `Copy`, because what is done seldom is done with a copy: what is pointed at from elsewhere is not kept in registers. The functions are
/// to be inlined in the iteration, which has one place where it evaluates.
pub(crate) trait StepEquation<A: Array, W>: Copy {
    /// At this multiple of the origin, if that is asked for, nothing moves: the energy is defined there if it is at the start of the step.
    const STANDSTILL: Option<f64>;

    /// What x is added to.
    fn origin(&self) -> A;
    /// A guess that needs no step before this one.
    fn explicit(&self) -> A;
    /// g(x); and 1 − g'(x) in `matrix`.
    fn evaluate(&self, watch: &mut W, x: &A, matrix: &mut Square<A>) -> A;

    /// g(x) alone.
    #[inline(always)]
    fn image(&self, watch: &mut W, x: &A) -> A {
        self.evaluate(watch, x, &mut A::fill(A::zero()))
    }

    /// x − g(x), and 1 − g'(x) in `matrix`.
    #[inline(always)]
    fn residual(&self, watch: &mut W, x: &A, matrix: &mut Square<A>) -> A {
        difference(x, &self.evaluate(watch, x, matrix))
    }
}

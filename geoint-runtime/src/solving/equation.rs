//! What an implicit step solves.

use crate::space::vector::difference;
use crate::space::{Array, Square};

/// Sees the points at which an equation is evaluated.
pub trait Observer {
    /// Whether what is evaluated from now on is no point of the step, and explains nothing: one looks there for rounding only.
    fn pause(&mut self, paused: bool);
}

impl Observer for () {
    fn pause(&mut self, _: bool) {}
}

/// An equation x = g(x) for the increment of a step. `W` watches where g is evaluated.
///
/// `Copy`, because what is done seldom is done with a copy: what is pointed at from elsewhere is not kept in registers. The functions are
/// to be inlined in the iteration, which has one place where it evaluates.
pub(crate) trait StepEquation<A: Array, W: Observer + ?Sized>: Copy {
    /// Whether all is done to find a solution: a search from afar, and a measure of what is rounding.
    const PATIENT: bool;
    /// Whether what steps keep is settled now and then: then a solution may be off by a part of the last digit, which elsewhere adds up.
    const SETTLED: bool = false;
    /// Whether coordinates count as large as they are where the step starts, not as they have been lately: what fields keep is often steep where
    /// they become small, as a logarithm is. Forces that cancel need the other: a momentum is then rounded as they are.
    const OF_NOW: bool = false;

    /// Whether [`nearly`](Self::nearly) has less to do than [`evaluate`](Self::evaluate).
    const NEARLY: bool = false;

    /// Returns whether a law for the energy binds all solutions, so that none is far away.
    fn is_bound_by_energy(&self) -> bool {
        Self::SETTLED
    }

    /// At this multiple of the origin nothing moves: the energy is defined there if it is at the start of the step.
    fn standstill(&self) -> f64 {
        0.0
    }

    /// What x is added to.
    fn origin(&self) -> A;
    /// A guess that needs no step before this one.
    fn explicit(&self) -> A;
    /// g(x) for the x of an evaluation point; and 1 − g'(x) in `matrix`.
    fn evaluate(&self, watch: &mut W, point: &A, matrix: &mut Square<A>) -> A;

    /// The same, where a part of g'(x) of the order of its square is missing in `matrix`.
    #[inline(always)]
    fn nearly(&self, watch: &mut W, point: &A, matrix: &mut Square<A>) -> A {
        self.evaluate(watch, point, matrix)
    }

    /// The evaluation point of x: x, moved by what sums have lost where the equation counts with that.
    #[inline(always)]
    fn point(&self, x: &A) -> A {
        *x
    }

    /// The x of an evaluation point. What is extrapolated is taken for a point: what sums have lost in the step before is known late, and would
    /// keep the evaluation waiting.
    #[inline(always)]
    fn unknown(&self, point: &A) -> A {
        *point
    }

    /// g(x) alone.
    #[inline(always)]
    fn image(&self, watch: &mut W, x: &A) -> A {
        self.evaluate(watch, &self.point(x), &mut A::fill(A::zero()))
    }

    /// x − g(x), and 1 − g'(x) in `matrix`.
    #[inline(always)]
    fn residual(&self, watch: &mut W, x: &A, matrix: &mut Square<A>) -> A {
        self.residual_at(watch, x, &self.point(x), matrix)
    }

    /// The same for x and its evaluation point. Where there is no g but this, x − (x − residual) would lose digits.
    #[inline(always)]
    fn residual_at(&self, watch: &mut W, x: &A, point: &A, matrix: &mut Square<A>) -> A {
        difference(x, &self.evaluate(watch, point, matrix))
    }
}

/// An equation behind pointers, for what is done seldom: it is compiled once for all equations of so many unknowns.
#[derive(Clone, Copy)]
pub(crate) struct Distant<A> {
    pub(crate) is_bound_by_energy: bool,
    pub(crate) origin: A,
    pub(crate) standstill: f64,
    pub(crate) explicit: A,
}

/// x − g(x), and 1 − g'(x) in a matrix, as a [`Distant`] equation is evaluated, and who watches that.
pub(crate) trait Residual<A: Array>: Observer {
    fn at(&mut self, x: &A, matrix: &mut Square<A>) -> A;
}

/// The residual of an equation.
pub(crate) struct ResidualOf<'a, E, W: ?Sized> {
    pub(crate) equation: E,
    pub(crate) watch: &'a mut W,
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

impl<A: Array> StepEquation<A, dyn Residual<A> + '_> for Distant<A> {
    const PATIENT: bool = true;

    fn is_bound_by_energy(&self) -> bool {
        self.is_bound_by_energy
    }

    fn standstill(&self) -> f64 {
        self.standstill
    }

    fn origin(&self) -> A {
        self.origin
    }

    fn explicit(&self) -> A {
        self.explicit
    }

    fn evaluate(&self, residual: &mut (dyn Residual<A> + '_), x: &A, matrix: &mut Square<A>) -> A {
        difference(x, &residual.at(x, matrix))
    }

    fn residual_at(&self, residual: &mut (dyn Residual<A> + '_), x: &A, _: &A, matrix: &mut Square<A>) -> A {
        residual.at(x, matrix)
    }
}

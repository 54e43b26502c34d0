//! The equation of an implicit step, r(x) = x − g(x) = 0, and the interface of its solvers.
//!
//! The unknown x contains increments, rates or velocities of stages, or multipliers of constraints. A method states its equation as a [`StepEquation`]. A
//! [`Solver`] returns a [`Solution`], or the [`Failure`] of the step. Solvers use the derivative of r, so r has to be smooth near the solution.

use super::Failure;
pub use super::size::Units;
use crate::ablation;
use crate::space::vector::difference;
use crate::space::{Array, Record, Square};

/// Observes the points at which an equation is evaluated. Equations report points by functions of the observer's own type. Solvers call `pause` only.
pub trait Observer {
    /// Starts a pause if `paused` is true, and ends it otherwise. Points of a pause do not belong to the step: they measure rounding, or follow a solution. An
    /// observer that explains refusals ignores them. After a pause, solvers evaluate the solution again before they return it.
    fn pause(&mut self, paused: bool);
}

impl Observer for () {
    fn pause(&mut self, _: bool) {}
}

/// The work that may be spent on a solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// For the first attempt at a step. The caller repeats a refused step with [`Effort::Thorough`].
    Fast,
    /// For refused steps: with damped corrections, measurements of the rounding of the residual, and tests of the branch of the solution.
    Thorough,
}

impl Effort {
    /// Returns whether this is [`Effort::Thorough`].
    #[inline(always)]
    pub const fn is_thorough(self) -> bool {
        matches!(self, Effort::Thorough)
    }
}

/// The magnitudes of coordinates relative to which corrections must be small.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Magnitudes {
    /// The largest magnitudes of recent steps. If large forces cancel, the rounding error of a momentum is that of its largest recent value.
    Recent,
    /// The magnitudes at the start of the step. A first integral such as a logarithm is steep at small coordinates, and then needs small corrections.
    /// [`QuasiNewton`](crate::method::implicit::QuasiNewton) compares with recent magnitudes in any case.
    Present,
}

/// r(x) = 0 for the unknown of one step. The observer `W` receives the points at which r is evaluated.
///
/// Precondition: the derivative of r has a positive determinant in short steps. It tends to the identity for most methods. An equation is `Copy`, because cold
/// functions get a copy: the optimiser keeps an equation in registers only if nothing points to it.
pub trait StepEquation<A: Array, W: Observer + ?Sized>: Copy {
    /// The work that may be spent on the solution.
    const EFFORT: Effort;
    /// The magnitudes relative to which corrections must be small.
    const MAGNITUDES: Magnitudes = Magnitudes::Recent;

    /// Returns whether all solutions satisfy the energy balance of the step. They are then accepted without a test of continuity in the step size h.
    fn is_bound_by_energy(&self) -> bool {
        false
    }

    /// Returns the factor f for which a step with x = f·origin ends at its start positions: 0 for increments and velocities, and −2 for impulses, which then
    /// reverse the momentum. Damped corrections start at this x, because the energy is usually defined there. Limits: stages of Gauss methods of second order
    /// lie elsewhere, and multipliers have no such x.
    fn standstill(&self) -> f64 {
        0.0
    }

    /// Returns the values to which x is added, in the units of x: p₀ for an impulse, y₀/h for a rate. Rounding of x is relative to them.
    fn origin(&self) -> A;

    /// Returns a guess from the start of the step alone.
    fn guess(&self) -> A;

    /// Returns r(x), and writes its derivative to `matrix`. Entry i of r has the unit of unknown i.
    fn residual(&self, watch: &mut W, x: &A, matrix: &mut Square<A>) -> A;

    /// Returns g(x) of the equation x = g(x), where r(x) = x − g(x). The default computes the matrix and discards it.
    #[inline(always)]
    fn image(&self, watch: &mut W, x: &A) -> A {
        difference(x, &self.residual(watch, x, &mut A::fill(A::zero())))
    }
}

/// A solution x + `rounding_error`. Methods with compensated sums add both parts, because the rounding errors of many steps have a bias.
#[derive(Clone, Copy, Debug)]
pub struct Solution<A> {
    /// The solution.
    pub x: A,
    /// The exact x less the rounded `x`: the part of the last correction that rounding has removed. Zero if the solver does not compute it.
    pub rounding_error: A,
}

impl<A: Array> Solution<A> {
    /// Returns the solution x with the rounding error 0.
    #[inline(always)]
    pub fn of(x: A) -> Self {
        Solution { x, rounding_error: A::zero() }
    }

    /// Returns the solution x₁, the rounded x − δ, with the rounding error (x − x₁) − δ. This error is exact in entries with |δ| ≤ |x|.
    #[inline(always)]
    pub(crate) fn corrected(x: &A, delta: &A) -> Self {
        let after = difference(x, delta);
        Solution { x: after, rounding_error: difference(&difference(x, &after), delta) }
    }
}

/// An iteration that solves one equation per step, with the experience of earlier steps.
pub trait Solver<A: Array>: Clone + Record<A::Real> {
    /// Creates a solver without experience, for unknowns with these units.
    fn new(units: Units) -> Self;

    /// Solves r(x) = 0 to rounding. After an error the solver is invalid: the caller creates a new one, or restores a copy.
    ///
    /// # Errors
    /// If no solution is found. Unless the equation is bound by energy, also if a solution after many evaluations fails the test of continuity in h, or is not
    /// tested because of [`Effort::Fast`].
    fn solve<W: Observer, E: StepEquation<A, W>>(
        &mut self,
        equation: &E,
        watch: &mut W,
    ) -> Result<Solution<A>, Failure>;
}

/// Returns the guess from the start of the step. Returns zero if this guess is not finite: an explicit step may leave the domain of the energy although the
/// solution lies inside.
#[cold]
#[inline(never)]
pub(super) fn explicit_guess<A: Array, W: Observer + ?Sized, E: StepEquation<A, W>>(equation: E) -> A {
    let guess = equation.guess();
    if ablation::EXPLICIT_GUESS && guess.is_finite() { guess } else { A::zero() }
}

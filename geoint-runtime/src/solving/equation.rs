//! The equation of an implicit step, r(x) = x − g(x) = 0, and the interface of its solvers.
//!
//! The unknown x is an increment, or the rates or velocities of stages. A method states its equation as a [`StepEquation`]. A [`Solver`] returns a
//! [`Solution`], or the [`Refusal`] of the step. Solvers use the derivative of r, so r has to be smooth near the solution.

use super::Refusal;
pub use super::size::Units;
use crate::ablation;
use crate::space::vector::difference;
use crate::space::{Array, Record, Square};

/// Receives the points at which an equation is evaluated. The equation passes points by functions of the concrete type. Solvers call `pause` only.
pub trait Observer {
    /// Starts a pause if `paused` is true, and ends it otherwise. Points of a pause do not belong to the step: they are evaluated to measure rounding, or to
    /// follow a solution. An observer that explains refusals ignores them. After a pause, the solution is evaluated again.
    fn pause(&mut self, paused: bool);
}

impl Observer for () {
    fn pause(&mut self, _: bool) {}
}

/// The work that may be spent on a solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// For steps in a loop. Steps that are refused are repeated with the other effort.
    Fast,
    /// For refused steps: with damped corrections, and with measurements of the rounding of the residual.
    Thorough,
}

impl Effort {
    /// Returns whether this is [`Effort::Thorough`].
    #[inline(always)]
    pub const fn is_thorough(self) -> bool {
        matches!(self, Effort::Thorough)
    }
}

/// The magnitudes of coordinates with which corrections are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Magnitudes {
    /// The largest of the last steps. If large forces cancel, the rounding error of a momentum is that of its largest recent value.
    Recent,
    /// The magnitudes at the start of the step. First integrals, such as a logarithm, may have large derivatives where coordinates are small.
    Present,
}

/// r(x) = 0 for the unknown of one step. The derivative of r tends to the identity for short steps. The observer `W` receives the points at which r is
/// evaluated.
///
/// An equation is `Copy`, because cold functions get a copy: the optimiser keeps an equation in registers only if nothing points to it.
pub trait StepEquation<A: Array, W: Observer + ?Sized>: Copy {
    /// The work that may be spent on the solution.
    const EFFORT: Effort;
    /// The magnitudes with which corrections are compared.
    const MAGNITUDES: Magnitudes = Magnitudes::Recent;

    /// Returns whether all solutions satisfy the energy balance of the step. Solutions are then not followed to h = 0.
    fn is_bound_by_energy(&self) -> bool {
        false
    }

    /// Returns the factor f for which x = f·origin leaves the positions unchanged: 0 for an increment. It is −2 for an impulse: the momentum is reversed, and
    /// its mean is 0. Damped corrections start at this x, because the energy is defined there if it is defined at the start of the step.
    fn standstill(&self) -> f64 {
        0.0
    }

    /// Returns the point to which x is added. Rounding of x is relative to it.
    fn origin(&self) -> A;

    /// Returns a guess from the start of the step alone.
    fn guess(&self) -> A;

    /// Returns r(x), and writes its derivative to `matrix`. Row i has the unit of unknown i.
    fn residual(&self, watch: &mut W, x: &A, matrix: &mut Square<A>) -> A;

    /// Returns g(x) of the equation x = g(x), where r(x) = x − g(x). The default computes the matrix and discards it.
    #[inline(always)]
    fn image(&self, watch: &mut W, x: &A) -> A {
        difference(x, &self.residual(watch, x, &mut A::fill(A::zero())))
    }
}

/// A solution x + `rounding_error`. Without the second part, the errors of many steps would have a bias.
#[derive(Clone, Copy, Debug)]
pub struct Solution<A> {
    /// The solution.
    pub x: A,
    /// The part of the last correction that was lost when `x` was rounded.
    pub rounding_error: A,
}

impl<A: Array> Solution<A> {
    /// Returns the solution x with the rounding error 0.
    #[inline(always)]
    pub fn of(x: A) -> Self {
        Solution { x, rounding_error: A::zero() }
    }

    /// Returns the solution x − δ, rounded to x₁, with the rounding error (x − x₁) − δ. This error is exact in entries with |δ| ≤ |x|.
    #[inline(always)]
    pub(crate) fn corrected(x: &A, delta: &A) -> Self {
        let after = difference(x, delta);
        Solution { x: after, rounding_error: difference(&difference(x, &after), delta) }
    }
}

/// An iteration that solves one equation per step, with the experience of earlier steps.
pub trait Solver<A: Array>: Clone + Record<A::Real> {
    /// Creates a solver of unknowns with these units.
    fn new(units: Units) -> Self;

    /// Solves r(x) = 0 to rounding. After an error, the caller creates a new solver, because the sequence of unknowns has a gap.
    ///
    /// # Errors
    /// If no solution is found, or if the solution is not connected to h = 0.
    fn solve<W: Observer, E: StepEquation<A, W>>(
        &mut self,
        equation: &E,
        watch: &mut W,
    ) -> Result<Solution<A>, Refusal>;
}

/// Returns the guess from the start of the step. Returns zero if this guess is not finite: an explicit step may leave the domain of the energy although the
/// solution lies inside.
#[cold]
#[inline(never)]
pub(super) fn explicit_guess<A: Array, W: Observer + ?Sized, E: StepEquation<A, W>>(equation: E) -> A {
    let guess = equation.guess();
    if ablation::EXPLICIT_GUESS && guess.is_finite() { guess } else { A::zero() }
}

//! The trait by which a method states its implicit step: unknown x, guess, residual r(x), and the increments of the state that follow from r(x) = 0.
//!
//! A [`Policy`] states the properties of the equation that the solver and the driver need, such as the branch of the solution and the checks of the end.

use super::points::{Arrival, Departure, Increment, Stage};
use super::watch::Watch;
use crate::method::corrected::kept;
use crate::method::{Claims, Estimate, Failure, Probe};
use crate::scalar::Real;
use crate::solving::equation::{Magnitudes, Solution, Solver, Units};
use crate::space::vector::difference;
use crate::space::{Array, Record, Square};
use crate::system::{Invariants, PhaseSpace};

/// The properties that all equations of a method have in common.
#[derive(Clone, Copy, Debug)]
pub struct Policy {
    /// The units of the unknowns: positions and momenta are two kinds.
    pub units: Units,
    /// The magnitudes of coordinates relative to which corrections must be small.
    pub magnitudes: Magnitudes,
    /// The solutions that the step accepts if there are several.
    pub branch: Branch,
    /// The factor f for which a step with x = f·[origin](ImplicitStep::origin) ends at its start positions. It is 0 for increments and velocities. It is −2
    /// for impulses, which then reverse the momentum, so that the mean momentum is 0. The search for a distant solution starts at this x, because the
    /// energy is usually defined there. Limits: stages of Gauss methods of second order lie elsewhere, and multipliers have no such x.
    pub standstill: f64,
    /// The sums that add the increments to the state.
    pub sums: Sums,
    /// The points at which the equation evaluates the energy. The checks of the end depend on them.
    pub evaluated: Evaluated,
    /// See [`Handling::is_rough_if_short`](crate::method::Handling::is_rough_if_short).
    pub is_rough_if_short: bool,
}

impl Policy {
    /// Returns the policy of many methods: recent magnitudes, solutions continuous in h, standstill 0, sums of the run, no evaluation at the end.
    pub const fn of(units: Units) -> Self {
        Policy {
            units,
            magnitudes: Magnitudes::Recent,
            branch: Branch::Continuous,
            standstill: 0.0,
            sums: Sums::OfTheRun,
            evaluated: Evaluated::Elsewhere,
            is_rough_if_short: false,
        }
    }
}

/// The solutions that a step accepts if there are several. It takes the first accepted solution that the solver finds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// Solutions that are continuous in h down to h = 0. The solver tests this by a heuristic, after more than five evaluations or damped corrections.
    Continuous,
    /// Any solution at which the derivative of r has a positive determinant. For methods whose solutions all satisfy the balance of the energy, with
    /// friction, or of a first integral.
    OfEnergy,
}

/// The sums that add the increments of a step to the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sums {
    /// The sums of the run. They are plain, unless the user has asked for compensation.
    OfTheRun,
    /// Sums with compensation for rounding errors: those of the run if it has them, otherwise sums of the method. Methods that keep the energy need them.
    /// With plain sums, rounding errors have a bias at some step sizes, and the energy drifts by 10⁻¹² in a million steps.
    Compensated,
}

/// The points at which an equation evaluates the energy. The checks of the driver depend on them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evaluated {
    /// Points other than the end. The driver checks that the energy is defined at the end, and checks the straight line to it for poles.
    Elsewhere,
    /// The end, among other points. The driver makes the checks of `Elsewhere`. It also checks that the energy does not jump at a condition (`if`, `abs`)
    /// between the end in the equation and the rounded end.
    AtTheEnd,
    /// Both ends, by divided differences, which are infinite or NaN for most poles between the ends. The driver checks conditions as in `AtTheEnd`, and
    /// the poles that differences miss.
    ByDifferences,
}

/// The equation of one step of the method `M`.
///
/// It is `Copy`, because cold functions take copies: the optimiser keeps an equation in registers only if no pointer refers to it.
pub struct Equation<'a, M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> {
    /// The start of the step, with its times.
    pub from: Departure<'a, S, R>,
    /// Values that depend on the method, on parameters, and on h.
    pub coefficients: &'a M::Coefficients,
    /// The result of [`begin`](ImplicitStep::begin).
    pub start: M::Start,
}

impl<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> Clone for Equation<'_, M, S, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> Copy for Equation<'_, M, S, R> {}

/// An implicit step of systems `S`: an equation r(x) = 0 for the unknown of each step, and the increments of the state that follow from its solution.
///
/// The solver starts from a prediction or from the guess, and solves the equation to rounding. [`Branch`] states which solutions it accepts. The driver
/// calls `begin`, `solve` (which calls `guess` and `residual`), `stage`, `update` and `finish`. It adds the increments, and checks poles and conditions.
///
/// Precondition: the derivative of r has a positive determinant in short steps, as it has if it tends to the identity. Multiply a row by −1 otherwise.
pub trait ImplicitStep<S: PhaseSpace<R>, R: Real = f64>: Copy + core::fmt::Debug {
    /// The unknown x: increments, rates, velocities or multipliers.
    type Unknown: Array<Real = R>;
    /// Values that depend on the method, on parameters, and on h.
    type Coefficients: Clone;
    /// Values that depend on the start of a step. All evaluations of the step share them.
    type Start: Copy;
    /// Values that a step passes to the next one, beside the unknowns: `()` for most methods.
    type History: Clone + Record<R>;
    /// Values of the last evaluation that [`update`](Self::update) reuses, `()` for most methods. Its point is the solution, or the solution before the
    /// last correction.
    type LastEvaluation;
    /// The invariants that a step keeps to rounding. A run removes their accumulated rounding error after each 1024 steps. `()` if a step keeps none.
    type Kept: Invariants<S, R> + Default;
    /// The iteration that solves r(x) = 0.
    type Solver: Solver<Self::Unknown>;

    /// The properties of the equation that the solver and the driver need.
    const POLICY: Policy;
    /// The number of [stages](Self::stage). The straight line from the start to each of them is checked for poles.
    const STAGES: usize = 0;
    /// See [`Method::COMPOSES_TO`](crate::Method::COMPOSES_TO).
    const COMPOSES_TO: u32 = u32::MAX;
    /// The order of the error that [`estimate`](Self::estimate) returns. `None` if the method has no estimate.
    const ORDER_OF_ESTIMATE: Option<u32> = None;

    /// Computes the values that depend on the method, on parameters, and on the step size h.
    fn coefficients(self, system: &S, h: R) -> Self::Coefficients;

    /// Returns the claims of the method for systems of this type, from its claims for all systems.
    fn claims(claims: Claims) -> Claims {
        claims
    }

    /// Returns the history before the first step.
    fn history() -> Self::History;

    /// Returns the value of `LastEvaluation` before the first evaluation.
    fn no_evaluation() -> Self::LastEvaluation;

    /// Computes the values that all evaluations of a step share.
    ///
    /// # Errors
    /// If no step can start at this point.
    fn begin(
        from: &Departure<'_, S, R>,
        coefficients: &Self::Coefficients,
        history: &mut Self::History,
    ) -> Result<Self::Start, Failure>;

    /// Returns the values to which x is added, in the units of x: p₀ for an impulse, y₀/h for a rate. Rounding of x is relative to them.
    fn origin(equation: &Equation<'_, Self, S, R>) -> Self::Unknown;

    /// Returns a guess of x from the start of the step alone.
    fn guess(equation: &Equation<'_, Self, S, R>) -> Self::Unknown;

    /// Returns r(x), and writes its derivative to `matrix`. Entry i of r has the unit of unknown i. Implementations show `watch` the points at which they
    /// evaluate the energy, and store values of this evaluation in `watch.last`.
    fn residual<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, Self::LastEvaluation>,
        x: &Self::Unknown,
        matrix: &mut Square<Self::Unknown>,
    ) -> Self::Unknown;

    /// Returns g(x) of the equation x = g(x), where r(x) = x − g(x), with the side effects of [`residual`](Self::residual). With more than twelve unknowns,
    /// [`Newton`](crate::method::implicit::Newton) iterates x ← g(x) as long as this converges fast. The default computes the matrix and discards it.
    #[inline(always)]
    fn image<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, Self::LastEvaluation>,
        x: &Self::Unknown,
    ) -> Self::Unknown {
        difference(x, &Self::residual(equation, watch, x, &mut Self::Unknown::fill(Self::Unknown::zero())))
    }

    /// Returns the solution of r(x) = 0. The default calls the solver.
    ///
    /// # Errors
    /// If no solution is found, or if the [`Branch`] of the policy excludes the solution.
    #[inline(always)]
    fn solve<P: Probe<S, R>>(
        equation: Equation<'_, Self, S, R>,
        solver: &mut Self::Solver,
        watch: &mut Watch<'_, S, R, P, Self::LastEvaluation>,
    ) -> Result<Solution<Self::Unknown>, Failure> {
        solver.solve(&equation, watch)
    }

    /// Returns stage `i` < [`STAGES`](Self::STAGES) of the solution x, a point at which the step evaluates the energy. The default is never called.
    fn stage(equation: &Equation<'_, Self, S, R>, i: usize, x: &Self::Unknown) -> Stage<S, R> {
        let _ = (i, x);
        let Departure { t, z, s, .. } = equation.from;
        Stage { t, z, s }
    }

    /// Returns the increments of the state that follow from a solution. `last` holds the values of the last evaluation.
    ///
    /// # Errors
    /// If no increments follow from the solution.
    fn update(
        equation: &Equation<'_, Self, S, R>,
        solution: &Solution<Self::Unknown>,
        last: &Self::LastEvaluation,
    ) -> Result<Increment<S::Phase, S::Action>, Failure>;

    /// Checks the rounded end of a step, and records values for the next step in `history`. The default does nothing.
    ///
    /// # Errors
    /// If the end does not have the properties that the method promises.
    #[inline(always)]
    fn finish<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        solution: &Solution<Self::Unknown>,
        history: &mut Self::History,
        end: Arrival<'_, S, R>,
    ) -> Result<(), Failure> {
        let _ = (equation, solution, history, end);
        Ok(())
    }

    /// Returns a more specific refusal than the refusal of the solver. The default returns `refusal`.
    #[cold]
    fn explained(equation: &Equation<'_, Self, S, R>, last: &Self::LastEvaluation, refusal: Failure) -> Failure {
        let _ = (equation, last);
        refusal
    }

    /// Returns two estimates of the error of a step, for adaptive steps. See [`Method::estimated`](crate::Method::estimated). It is called only if
    /// [`ORDER_OF_ESTIMATE`](Self::ORDER_OF_ESTIMATE) is not `None`.
    ///
    /// # Errors
    /// If the error cannot be estimated. The default is always an error.
    fn estimate<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        x: &Self::Unknown,
        probe: &mut P,
    ) -> Result<Estimate<S, R>, Failure> {
        let _ = (equation, x, probe);
        Err(Failure::Singular)
    }

    /// Returns the correction that must be added to `z` to restore the kept invariants to their values at the start of a run.
    #[inline]
    fn way_back(system: &S, start_of_run: &S::Phase, z: &S::Phase) -> S::Phase {
        kept::way_back(system, &Self::Kept::default(), start_of_run, z)
    }

    /// Returns whether no invariant that steps compare underflows or overflows at the start `z` of a run. The default, `true`, suits steps that compare none.
    fn is_in_range(system: &S, z: &S::Phase) -> bool {
        let _ = (system, z);
        true
    }
}

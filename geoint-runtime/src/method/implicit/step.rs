//! One implicit step, as a method states it: unknown, guess, residual, and the increments of the state that belong to a solution.

use super::points::{Arrival, Departure, Increment, Stage};
use super::watch::Watch;
use crate::method::corrected::kept;
use crate::method::{Claims, Estimate, Probe, Refusal};
use crate::scalar::Real;
use crate::solving::equation::{Magnitudes, Solution, Solver, Units};
use crate::space::vector::difference;
use crate::space::{Array, Record, Square};
use crate::system::{Invariants, PhaseSpace};

/// The properties that all equations of a method have in common.
#[derive(Clone, Copy, Debug)]
pub struct Policy {
    /// The units of the unknowns.
    pub units: Units,
    /// The coordinates with which corrections are compared.
    pub magnitudes: Magnitudes,
    /// The solution that is the step, if there are several.
    pub branch: Branch,
    /// The factor f for which x = f·origin leaves the positions unchanged: 0 for an increment. It is −2 for an impulse: the momentum is reversed, and its mean is 0.
    /// The search for a distant solution starts there, because the energy is defined there if it is defined at the start of the step.
    pub standstill: f64,
    /// The sums by which the step is added to the state.
    pub sums: Sums,
    /// The points at which the equation evaluates the energy.
    pub evaluated: Evaluated,
}

impl Policy {
    /// Returns the policy of most methods: the solution that is continuous in h is added by the sums of the run, and the energy is not evaluated at the end.
    pub const fn of(units: Units) -> Self {
        Policy {
            units,
            magnitudes: Magnitudes::Recent,
            branch: Branch::Continuous,
            standstill: 0.0,
            sums: Sums::OfTheRun,
            evaluated: Evaluated::Elsewhere,
        }
    }
}

/// The solution that is the step, if there are several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// The solution that is continuous in h. A solution that took many corrections is followed to h = 0.
    Continuous,
    /// Each solution at which the derivative has a positive determinant, because all of them satisfy the energy balance of the step. Friction is part of this balance.
    OfEnergy,
}

/// The sums by which a step is added to the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sums {
    /// The sums of the run. They are plain, unless the user has asked for compensation.
    OfTheRun,
    /// Sums of the method with compensation for rounding errors. Methods that keep the energy need them: with plain sums, rounding errors have a bias at some step
    /// sizes, and the energy drifts by 10⁻¹² in a million steps. They add about 5 % to a cheap step.
    Compensated,
}

/// The points at which an equation evaluates the energy. The driver checks what follows from them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evaluated {
    /// Points other than the end. The driver checks that the energy is defined at the end, and that there is no pole on the way.
    Elsewhere,
    /// The end, too. The driver also checks that the rounded end lies on the same side of each condition of the energy (`if`, `abs`) as the end in the equation.
    AtTheEnd,
    /// Both ends, by divided differences. A pole between the ends makes most differences infinite. The driver checks conditions, and the poles that differences miss.
    ByDifferences,
}

/// The equation of one step of the method `M`.
///
/// It is `Copy`, because cold functions get a copy: the optimiser keeps an equation in registers only if nothing points to it.
pub struct Equation<'a, M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> {
    /// The point from which the step leads.
    pub from: Departure<'a, S, R>,
    /// Values that depend on the method, on parameters, and on h.
    pub constants: &'a M::Constants,
    /// Values that depend on the start of the step.
    pub start: M::Start,
}

impl<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> Clone for Equation<'_, M, S, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> Copy for Equation<'_, M, S, R> {}

/// An implicit step of systems `S`: an equation r(x) = 0 for the unknown of each step, and the increments of the state that belong to its solution.
///
/// The solver starts from a prediction or from the guess, and solves the equation to rounding. It refuses a suspicious solution that is not connected to h = 0 (see
/// [`Branch`]). The driver adds the increments, and checks for poles and conditions. The order of calls is begin, guess, residual (repeated), update, finish.
pub trait ImplicitStep<S: PhaseSpace<R>, R: Real = f64>: Copy + core::fmt::Debug {
    /// The unknown x.
    type Unknown: Array<Real = R>;
    /// Values that depend on the method, on parameters, and on h.
    type Constants: Clone;
    /// Values that depend on the start of a step. All evaluations have them in common.
    type Start: Copy;
    /// Values that a step passes to the next one, beside the unknowns: `()` for most methods.
    type History: Clone + Record<R>;
    /// Values of the last evaluation that [`update`](Self::update) reads, so that it does not evaluate them again: `()` for most methods.
    type Seen;
    /// The invariants that a step keeps to rounding. After each 1024 steps the accumulated rounding error is removed. `()` if a step keeps none.
    type Kept: Invariants<S, R> + Default;
    /// The iteration.
    type Solver: Solver<Self::Unknown>;

    /// The properties that all equations have in common.
    const POLICY: Policy;
    /// The number of [stages](Self::stage) of a step.
    const STAGES: usize = 0;
    /// See [`Method::COMPOSES_TO`](crate::Method::COMPOSES_TO).
    const COMPOSES_TO: u32 = u32::MAX;
    /// See [`Method::ROUGH_IF_SHORT`](crate::Method::ROUGH_IF_SHORT).
    const ROUGH_IF_SHORT: bool = false;
    /// The order of the error that [`estimate`](Self::estimate) finds, if it does.
    const ORDER_OF_ESTIMATE: Option<u32> = None;

    /// Returns the values that depend on the method, on parameters, and on h.
    fn constants(self, system: &S, h: R) -> Self::Constants;

    /// Adjusts the claims of the method to systems of this type.
    fn claims(claims: Claims) -> Claims {
        claims
    }

    /// Returns the history before the first step.
    fn history() -> Self::History;

    /// Returns the values of `Seen` before the first evaluation.
    fn unseen() -> Self::Seen;

    /// Returns the values that all evaluations of a step have in common.
    ///
    /// # Errors
    /// If a step cannot start here.
    fn begin(
        from: &Departure<'_, S, R>,
        constants: &Self::Constants,
        history: &mut Self::History,
    ) -> Result<Self::Start, Refusal>;

    /// Returns the point to which x is added. Rounding of x is relative to it.
    fn origin(equation: &Equation<'_, Self, S, R>) -> Self::Unknown;

    /// Returns a guess from the start of the step alone.
    fn guess(equation: &Equation<'_, Self, S, R>) -> Self::Unknown;

    /// Returns r(x), and writes its derivative to `matrix`. Row i has the unit of unknown i. The points at which the energy is evaluated are shown to `watch`.
    fn residual<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, Self::Seen>,
        x: &Self::Unknown,
        matrix: &mut Square<Self::Unknown>,
    ) -> Self::Unknown;

    /// Returns g(x) of the equation x = g(x), where r(x) = x − g(x). [`Newton`](crate::method::implicit::Newton) iterates x = g(x) with more than twelve
    /// unknowns, while this converges fast. The default computes the matrix and discards it.
    #[inline(always)]
    fn image<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        watch: &mut Watch<'_, S, R, P, Self::Seen>,
        x: &Self::Unknown,
    ) -> Self::Unknown {
        difference(x, &Self::residual(equation, watch, x, &mut Self::Unknown::fill(Self::Unknown::zero())))
    }

    /// Returns the solution.
    ///
    /// # Errors
    /// If no solution is found, or if the solution is not connected to h = 0.
    #[inline(always)]
    fn solve<P: Probe<S, R>>(
        equation: Equation<'_, Self, S, R>,
        solver: &mut Self::Solver,
        watch: &mut Watch<'_, S, R, P, Self::Seen>,
    ) -> Result<Solution<Self::Unknown>, Refusal> {
        solver.solve(&equation, watch)
    }

    /// Returns stage `i`. The energy must not have a pole on the line from the start to this stage.
    fn stage(equation: &Equation<'_, Self, S, R>, i: usize, x: &Self::Unknown) -> Stage<S, R> {
        let _ = (i, x);
        let Departure { t, z, s, .. } = equation.from;
        Stage { t, z, s }
    }

    /// Returns the increments of the state that belong to a solution.
    ///
    /// # Errors
    /// If the step has no end.
    fn update(
        equation: &Equation<'_, Self, S, R>,
        solution: &Solution<Self::Unknown>,
        seen: &Self::Seen,
    ) -> Result<Increment<S::Phase, S::Action>, Refusal>;

    /// Refuses the end of a step, or prepares the next one.
    ///
    /// # Errors
    /// If the end does not have the properties that the method promises.
    #[inline(always)]
    fn finish<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        solution: &Solution<Self::Unknown>,
        history: &mut Self::History,
        end: Arrival<'_, S, R>,
    ) -> Result<(), Refusal> {
        let _ = (equation, solution, history, end);
        Ok(())
    }

    /// Replaces the refusal of the solver by a more specific one, if the method knows it.
    #[cold]
    fn explained(equation: &Equation<'_, Self, S, R>, seen: &Self::Seen, refusal: Refusal) -> Refusal {
        let _ = (equation, seen);
        refusal
    }

    /// Returns two estimates of the error of a step, for steps that adapt. See [`Method::estimated`](crate::Method::estimated). It is called only if
    /// [`ORDER_OF_ESTIMATE`](Self::ORDER_OF_ESTIMATE) is not `None`.
    ///
    /// # Errors
    /// If the error cannot be estimated.
    fn estimate<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        x: &Self::Unknown,
        probe: &mut P,
    ) -> Result<Estimate<S, R>, Refusal> {
        let _ = (equation, x, probe);
        Err(Refusal::Singular)
    }

    /// Returns the correction of `z` that restores the invariants which steps keep to their values at the `origin` of a run.
    #[inline]
    fn way_back(system: &S, origin: &S::Phase, z: &S::Phase) -> S::Phase {
        kept::way_back(system, &Self::Kept::default(), origin, z)
    }

    /// Returns whether the invariants that steps compare are finite and not subnormal at the start of a run.
    fn is_in_range(system: &S, z: &S::Phase) -> bool {
        let _ = (system, z);
        true
    }
}

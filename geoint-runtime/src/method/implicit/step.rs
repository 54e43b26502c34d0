//! One implicit step, as a method states it: the unknown, a guess, the residual, and what a solution adds to the state.

use super::points::{Arrival, Departure, Increment, Stage};
use super::watch::Watch;
use crate::method::corrected::kept;
use crate::method::{Claims, Estimate, Probe, Refusal};
use crate::scalar::Real;
use crate::solving::equation::{Magnitudes, Solution, Solver, Units};
use crate::space::vector::difference;
use crate::space::{Array, Record, Square};
use crate::system::{Invariants, PhaseSpace};

/// What each equation of a method has in common with the others.
#[derive(Clone, Copy, Debug)]
pub struct Policy {
    /// The number of unknowns that follow each other and have one unit, and the number of such kinds.
    pub units: Units,
    /// The coordinates with which corrections are compared.
    pub magnitudes: Magnitudes,
    /// Which one of several solutions is the step.
    pub branch: Branch,
    /// The factor f for which x = f·origin moves nothing: 0 for an increment, −2 for an impulse that reverses a momentum. The energy is defined there if it is
    /// defined at the start of the step.
    pub standstill: f64,
    /// How the step is added to the state.
    pub sums: Sums,
    /// Where the equation evaluates the energy.
    pub evaluated: Evaluated,
}

impl Policy {
    /// The policy of most methods, for unknowns with these units: the solution that is continuous in h is added plainly, and the energy is not evaluated at
    /// the end.
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

/// Which one of several solutions is the step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// The one that is continuous in h. A solution that took many corrections is followed to h = 0.
    Continuous,
    /// Each one: all solutions have the energy of the start.
    OfEnergy,
}

/// How a step is added to the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sums {
    /// As the run adds: plainly, unless it compensates.
    OfTheRun,
    /// With compensation for rounding errors. The energy of a method that keeps it is worth that: with plain sums, rounding errors have a bias at some step sizes,
    /// and the energy drifts by 10⁻¹² in a million steps. The cost is a twentieth.
    Compensated,
}

/// Where an equation evaluates the energy. The driver examines the remaining points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evaluated {
    /// At other points than the end. The energy has to be defined at the end, and to have no pole on the way there.
    Elsewhere,
    /// At the end, where it decides conditions. It has to have no pole on the way there.
    AtTheEnd,
    /// At both ends, by divided differences. They are defined on the whole way, unless a pole of the energy is not one of its differences.
    ByDifferences,
}

/// The equation of one step of the method `M`.
///
/// It is `Copy`, because cold functions get a copy: the optimiser keeps an equation in registers only if nothing points to it.
pub struct Equation<'a, M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> {
    /// The point from which the step leads.
    pub from: Departure<'a, S, R>,
    /// What depends on parameters and h.
    pub constants: &'a M::Constants,
    /// What depends on the start of the step.
    pub start: M::Start,
}

impl<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> Clone for Equation<'_, M, S, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> Copy for Equation<'_, M, S, R> {}

/// An implicit step of systems `S`: an equation r(x) = 0 for the unknown of each step, and what its solution adds to the state.
///
/// A driver predicts x from the steps before, solves the equation to rounding, and refuses the step where the solution is not the one of short steps, or where the
/// energy has a pole on the way. The functions have the names of the parts of a step: begin, guess, residual, update, finish.
pub trait ImplicitStep<S: PhaseSpace<R>, R: Real = f64>: Copy + core::fmt::Debug {
    /// The unknown x.
    type Unknown: Array<Real = R>;
    /// What depends on the method, on parameters, and on h.
    type Constants: Clone;
    /// What depends on the start of a step. All evaluations have it in common.
    type Start: Copy;
    /// What steps hand on to the next one, beside the unknowns: `()` for most methods.
    type History: Clone + Record<R>;
    /// What the last evaluation leaves for [`update`](Self::update), so that it is not evaluated again: `()` for most methods.
    type Seen;
    /// What steps keep to rounding; what roundings add up to is taken away once in 1024 steps. `()` if they keep nothing.
    type Kept: Invariants<S, R> + Default;
    /// The iteration.
    type Solver: Solver<Self::Unknown>;

    /// What each equation has in common with the others.
    const POLICY: Policy;
    /// The number of [stages](Self::stage) of a step.
    const STAGES: usize = 0;
    /// See [`Method::COMPOSES_TO`](crate::Method::COMPOSES_TO).
    const COMPOSES_TO: u32 = u32::MAX;
    /// See [`Method::ROUGH_IF_SHORT`](crate::Method::ROUGH_IF_SHORT).
    const ROUGH_IF_SHORT: bool = false;
    /// The order of the error that [`estimate`](Self::estimate) finds, if it does.
    const ORDER_OF_ESTIMATE: Option<u32> = None;

    /// Returns what depends on the method, on parameters, and on h.
    fn constants(self, system: &S, h: R) -> Self::Constants;

    /// Returns what the method claims for systems of this type, from what it claims for others.
    fn claims(claims: Claims) -> Claims {
        claims
    }

    /// Returns the history before the first step.
    fn history() -> Self::History;

    /// Returns what the last evaluation has left before the first one.
    fn unseen() -> Self::Seen;

    /// Returns what all evaluations of a step have in common.
    ///
    /// # Errors
    /// Where a step cannot start.
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

    /// Returns g(x) of the equation x = g(x), where r(x) = x − g(x). With many unknowns, x is iterated by this, without a matrix.
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
    /// Where none is found, or not that of short steps.
    #[inline(always)]
    fn solve<P: Probe<S, R>>(
        equation: Equation<'_, Self, S, R>,
        solver: &mut Self::Solver,
        watch: &mut Watch<'_, S, R, P, Self::Seen>,
    ) -> Result<Solution<Self::Unknown>, Refusal> {
        solver.solve(&equation, watch)
    }

    /// Returns the `i`-th point between which and the start the energy must not have a pole.
    fn stage(equation: &Equation<'_, Self, S, R>, i: usize, x: &Self::Unknown) -> Stage<S, R> {
        let _ = (i, x);
        let Departure { t, z, s, .. } = equation.from;
        Stage { t, z, s }
    }

    /// Returns what a solution adds to the state.
    ///
    /// # Errors
    /// Where the step has no end.
    fn update(
        equation: &Equation<'_, Self, S, R>,
        solution: &Solution<Self::Unknown>,
        seen: &Self::Seen,
    ) -> Result<Increment<S::Phase, S::Action>, Refusal>;

    /// Refuses the end of a step, or prepares the next one.
    ///
    /// # Errors
    /// Where a step ends otherwise than the method promises.
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

    /// Returns the reason for which an equation has no solution, if it is another one than the solver sees.
    #[cold]
    fn explained(equation: &Equation<'_, Self, S, R>, seen: &Self::Seen, refusal: Refusal) -> Refusal {
        let _ = (equation, seen);
        refusal
    }

    /// Returns two estimates of the error of a step, for steps that adapt.
    ///
    /// # Errors
    /// Where there are none.
    fn estimate<P: Probe<S, R>>(
        equation: &Equation<'_, Self, S, R>,
        x: &Self::Unknown,
        probe: &mut P,
    ) -> Result<Estimate<S, R>, Refusal> {
        let _ = (equation, x, probe);
        Err(Refusal::Singular)
    }

    /// Returns what leads from `z` to where the invariants that steps keep were at the `origin` of a run.
    #[inline]
    fn way_back(system: &S, origin: &S::Phase, z: &S::Phase) -> S::Phase {
        kept::way_back(system, &Self::Kept::default(), origin, z)
    }

    /// Returns whether the invariants that steps compare are numbers with all their digits at the start of a run.
    fn is_in_range(system: &S, z: &S::Phase) -> bool {
        let _ = (system, z);
        true
    }
}

//! The driver of implicit steps. It solves the equation of a step, adds the increments to the state, and checks the result.
//!
//! The checks follow from the [`Policy`](super::Policy) of the method. A step is refused unless the straight lines from its start to each of its
//! [`STAGES`](ImplicitStep::STAGES) and to its end provably cross no pole of the energy. Limit: other points at which a step evaluates the energy are not
//! checked.
//!
//! If the equation evaluates the energy at the end, a step is also refused if the energy jumps between the end of the last evaluation and the end. The two
//! ends differ by the last correction and by rounding.
//!
//! An attempt is fast if [`Probe::EFFORT`] is [`Effort::Fast`]. It may set `needs_recheck` in place of a search for poles. The caller then repeats the step
//! with [`Effort::Thorough`]. The driver does not restore the point of a refused step.

use super::points::{Arrival, Departure, Increment, Stage};
use super::step::{Branch, Equation, Evaluated, ImplicitStep, Sums};
use super::watch::Watch;
use crate::method::{Effort, Estimate, Failure, Probe, Step, check_end, check_poles, check_way, start as start_point};
use crate::scalar::Real;
use crate::solving::equation::{Magnitudes, Solution, Solver, StepEquation};
use crate::space::{Compensated, Record, Square, Summation, Tape};
use crate::system::{Evaluations, PhaseSpace, Poles, jump_between};

/// Coefficients of steps of one length h.
#[derive(Clone)]
pub struct Prepared<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> {
    coefficients: M::Coefficients,
    h: R,
    /// The poles that the parameters of the system do not exclude.
    poles: Poles,
}

/// Values that a step passes to the next one.
#[derive(Clone)]
pub struct Memory<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> {
    /// The solver, with its experience of earlier steps.
    solver: M::Solver,
    history: M::History,
    /// The compensation of coordinates, with [`Sums::Compensated`] in a run with plain sums, whose point has no place for rounding errors. Zero otherwise.
    sums: Compensated<S::Phase>,
}

impl<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> Record<R> for Memory<M, S, R> {
    fn record(&mut self, tape: &mut impl Tape<R>) {
        self.solver.record(tape);
        self.history.record(tape);
        self.sums.record(tape);
    }
}

impl<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> Memory<M, S, R> {
    /// Returns the memory before the first step.
    #[expect(clippy::new_without_default, reason = "it discards rounding errors, so calls must be explicit")]
    pub fn new() -> Self {
        Memory { solver: M::Solver::new(M::POLICY.units), history: M::history(), sums: Compensated::new() }
    }
}

impl<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> Prepared<M, S, R> {
    /// See [`ImplicitStep::ORDER_OF_ESTIMATE`].
    pub const ORDER_OF_ESTIMATE: Option<u32> = M::ORDER_OF_ESTIMATE;

    /// Computes the coefficients of steps of length `h`.
    pub fn new(method: M, system: &S, h: R) -> Self {
        Prepared { coefficients: method.coefficients(system, h), h, poles: Poles::of(system) }
    }

    /// Takes one step, in place.
    ///
    /// # Errors
    /// If the step has no result. The point and the memory are then invalid. The caller must restore the point, and create or restore a memory.
    #[inline(always)]
    pub fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        memory: &mut Memory<M, S, R>,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        self.take(step.system, memory, step).map(drop)
    }

    /// Takes one step, in place, and returns an [`Estimate`], which holds two estimates of its error; see [`Method::estimated`](crate::Method::estimated).
    /// Returns `None`, and takes no step, if the method never estimates errors.
    ///
    /// # Errors
    /// The inner result is an error if the step has no result, or if the error of this step cannot be estimated. The point and the memory are then invalid.
    #[inline]
    pub fn estimated<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        memory: &mut Memory<M, S, R>,
        mut step: Step<'_, S, R, C, P>,
    ) -> Option<Result<Estimate<S, R>, Failure>> {
        Self::ORDER_OF_ESTIMATE?;
        // The whole step, reborrowed: the estimate uses its probe.
        let taken = self.take(step.system, memory, step.part([step.t, step.end]));
        Some(taken.and_then(|SolvedStep { equation, solution }| M::estimate(&equation, &solution.x, step.probe)))
    }

    /// Takes one step, in place, and returns its equation with the solution. `system` is an argument of its own: the result borrows it for `'a`, longer than
    /// the other parts of the step.
    #[inline(always)]
    fn take<'a, C: Summation<S::Phase>, P: Probe<S, R>>(
        &'a self,
        system: &'a S,
        Memory { solver, history, sums }: &mut Memory<M, S, R>,
        Step { t, end, x, probe, .. }: Step<'_, S, R, C, P>,
    ) -> Result<SolvedStep<'a, M, S, R>, Failure> {
        // The coordinates z, such as (q, p), and the action s, both at the start.
        let before = start_point::<S, R, C>(x);
        // A run with compensated sums stores the compensation in its point, so that it survives a change of h. In a plain run the memory stores it.
        let compensation = if C::PLAIN { sums.compensation() } else { x.sums.compensation() };
        // `end` is bit for bit the start of the next step. The coefficients belong to h, which may differ from `end − t` by a rounding.
        let from = Departure { system, t, end, h: self.h, z: before.0, s: before.1, compensation };
        probe.visit(t, &from.z, &from.s);
        let start = M::begin(&from, &self.coefficients, history)?;
        let equation = Equation { from, coefficients: &self.coefficients, start };
        let mut watch = Watch::new(probe, &from, M::no_evaluation());
        let solution = match M::solve(equation, solver, &mut watch) {
            Ok(solution) => solution,
            // The method may know a more specific reason than its solver.
            Err(refusal) => return Err(M::explained(&equation, &watch.last, refusal)),
        };
        // `Watch::visit` and `Watch::record_end` have set `solved_end` in the last evaluation, if the energy has conditions.
        let Watch { probe, solved_end, last } = watch;

        // A stage may lie beyond a pole, although the line to the end crosses none.
        for i in 0..M::STAGES {
            let Stage { t: stage_time, z, s } = M::stage(&equation, i, &solution.x);
            let ends = ([t, stage_time], [&from.z, &z], [&from.s, &s]);
            check_way::<S, R, P>(&self.poles, Evaluations::AtPoints, system, ends, &mut x.needs_recheck)?;
        }
        let Increment { z, s, rounding_error } = M::update(&equation, &solution, &last)?;
        match const { M::POLICY.sums } {
            Sums::Compensated => x.add_with(sums, &z, &rounding_error),
            Sums::OfTheRun => x.add(&z),
        }
        x.add_action(s);
        let arrival = Arrival { z: &x.z, s: &x.s, needs_recheck: &mut x.needs_recheck };
        M::finish::<P>(&equation, &solution, history, arrival)?;
        // The last correction, or rounding, may move the end across a condition at which the energy jumps. With `Elsewhere`, the equation has evaluated no
        // condition at the end.
        if const { !matches!(M::POLICY.evaluated, Evaluated::Elsewhere) } {
            Failure::outside(jump_between(system, from.middle(), [&solved_end.0, &x.z], [&solved_end.1, &x.s]))?;
        }
        let step = Step { system, t, end, x, probe };
        match const { M::POLICY.evaluated } {
            // Divided differences have read the energy at the end, and are not finite for most poles. The others are checked.
            Evaluated::ByDifferences => check_poles(&self.poles, Evaluations::ByDifferences, &before, step)?,
            // Also checks that the energy is defined at the end.
            _ => check_end(&self.poles, &before, step)?,
        }
        Ok(SolvedStep { equation, solution })
    }
}

/// The equation of a step that was taken, and its solution.
struct SolvedStep<'a, M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> {
    equation: Equation<'a, M, S, R>,
    solution: Solution<M::Unknown>,
}

/// Passes the equation of the method to its solver.
impl<M, S, R, P> StepEquation<M::Unknown, Watch<'_, S, R, P, M::LastEvaluation>> for Equation<'_, M, S, R>
where
    M: ImplicitStep<S, R>,
    S: PhaseSpace<R>,
    R: Real,
    P: Probe<S, R>,
{
    const EFFORT: Effort = P::EFFORT;
    const MAGNITUDES: Magnitudes = M::POLICY.magnitudes;

    /// See [`Branch::OfEnergy`].
    fn is_bound_by_energy(&self) -> bool {
        matches!(M::POLICY.branch, Branch::OfEnergy)
    }

    /// See [`Policy::standstill`](super::Policy::standstill).
    fn standstill(&self) -> f64 {
        M::POLICY.standstill
    }

    #[inline(always)]
    fn origin(&self) -> M::Unknown {
        M::origin(self)
    }

    fn guess(&self) -> M::Unknown {
        M::guess(self)
    }

    #[inline(always)]
    fn residual(
        &self,
        watch: &mut Watch<'_, S, R, P, M::LastEvaluation>,
        x: &M::Unknown,
        matrix: &mut Square<M::Unknown>,
    ) -> M::Unknown {
        M::residual(self, watch, x, matrix)
    }

    #[inline(always)]
    fn image(&self, watch: &mut Watch<'_, S, R, P, M::LastEvaluation>, x: &M::Unknown) -> M::Unknown {
        M::image(self, watch, x)
    }
}

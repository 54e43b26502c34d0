//! The driver of implicit steps: it begins a step, lets the solver solve its equation, adds the increments, and checks the end.

use super::points::{Arrival, Departure, Increment, Stage};
use super::step::{Branch, Equation, Evaluated, ImplicitStep, Sums};
use super::watch::Watch;
use crate::method::{Effort, Estimate, Probe, Refusal, Step, check_end, check_poles, check_way, start};
use crate::scalar::Real;
use crate::solving::equation::{Magnitudes, Solution, Solver, StepEquation};
use crate::space::{Compensated, Record, Square, Summation, Tape};
use crate::system::{PhaseSpace, Poles, jump_between};

/// Whether a step evaluates divided differences: a pole between their ends is a pole of most of them.
const BY_DIFFERENCES: bool = true;
const BY_POINTS: bool = false;

/// Coefficients of steps of one length.
#[derive(Clone)]
pub struct Prepared<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> {
    constants: M::Constants,
    h: R,
    poles: Poles,
}

/// Values that a step passes to the next one.
#[derive(Clone)]
pub struct Memory<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> {
    solver: M::Solver,
    history: M::History,
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
    /// Creates the memory before the first step.
    #[expect(clippy::new_without_default, reason = "a default memory would look valid in the middle of a run")]
    pub fn new() -> Self {
        Memory { solver: M::Solver::new(M::POLICY.units), history: M::history(), sums: Compensated::new() }
    }
}

impl<M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> Prepared<M, S, R> {
    /// The order of the error that steps estimate, if they do.
    pub const ORDER_OF_ESTIMATE: Option<u32> = M::ORDER_OF_ESTIMATE;

    /// Prepares steps of length `h`.
    pub fn new(method: M, system: &S, h: R) -> Self {
        Prepared { constants: method.constants(system, h), h, poles: Poles::of(system) }
    }

    /// Takes one step, in place.
    ///
    /// # Errors
    /// If the step has no result. The point and the memory are then not valid, and the caller restores the point.
    #[inline(always)]
    pub fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        memory: &mut Memory<M, S, R>,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        self.take(step.system, memory, step).map(drop)
    }

    /// Takes one step, and estimates its error. Returns `None`, and takes no step, if the method has no estimate.
    #[inline]
    pub fn estimated<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        memory: &mut Memory<M, S, R>,
        mut step: Step<'_, S, R, C, P>,
    ) -> Option<Result<Estimate<S, R>, Refusal>> {
        Self::ORDER_OF_ESTIMATE?;
        let taken = self.take(step.system, memory, step.part([step.t, step.end]));
        Some(taken.and_then(|Taken { equation, solution }| M::estimate(&equation, &solution.x, step.probe)))
    }

    /// Takes one step, and returns its equation with the solution.
    #[inline(always)]
    fn take<'a, C: Summation<S::Phase>, P: Probe<S, R>>(
        &'a self,
        system: &'a S,
        Memory { solver, history, sums }: &mut Memory<M, S, R>,
        Step { t, end, x, probe, .. }: Step<'_, S, R, C, P>,
    ) -> Result<Taken<'a, M, S, R>, Refusal> {
        let before = start::<S, R, C>(x);
        // A run that compensates stores the compensation in its point, and keeps it when h changes. In a plain run the method stores it.
        let compensation = if C::PLAIN { sums.compensation() } else { x.sums.compensation() };
        let from = Departure { system, t, end, h: self.h, z: before.0, s: before.1, compensation };
        probe.visit(t, &from.z, &from.s);
        let begun = M::begin(&from, &self.constants, history)?;
        let equation = Equation { from, constants: &self.constants, start: begun };
        let mut watch = Watch::new(probe, &from, M::unseen());
        let solution = match M::solve(equation, solver, &mut watch) {
            Ok(solution) => solution,
            Err(refusal) => return Err(M::explained(&equation, &watch.seen, refusal)),
        };
        let Watch { probe, decided, seen } = watch;

        for i in 0..M::STAGES {
            let Stage { t: later, z, s } = M::stage(&equation, i, &solution.x);
            let way = ([t, later], [&from.z, &z], [&from.s, &s]);
            check_way::<S, R, P>(&self.poles, BY_POINTS, system, way, &mut x.doubtful)?;
        }
        let Increment { z, s, lost } = M::update(&equation, &solution, &seen)?;
        match const { M::POLICY.sums } {
            Sums::Compensated => x.add_with(sums, &z, &lost),
            Sums::OfTheRun => x.add(&z),
        }
        x.add_action(s);
        let arrival = Arrival { z: &x.z, s: &x.s, doubtful: &mut x.doubtful };
        M::finish::<P>(&equation, &solution, history, arrival)?;
        if const { !matches!(M::POLICY.evaluated, Evaluated::Elsewhere) } {
            // After rounding, the end may lie on the other side of a condition than the end in the equation.
            Refusal::outside(jump_between(system, from.middle(), [&decided.0, &x.z], [&decided.1, &x.s]))?;
        }
        let step = Step { system, t, end, x, probe };
        match const { M::POLICY.evaluated } {
            Evaluated::ByDifferences => check_poles(&self.poles, BY_DIFFERENCES, &before, step)?,
            _ => check_end(&self.poles, &before, step)?,
        }
        Ok(Taken { equation, solution })
    }
}

/// A step that was taken.
struct Taken<'a, M: ImplicitStep<S, R>, S: PhaseSpace<R>, R: Real> {
    equation: Equation<'a, M, S, R>,
    solution: Solution<M::Unknown>,
}

impl<M, S, R, P> StepEquation<M::Unknown, Watch<'_, S, R, P, M::Seen>> for Equation<'_, M, S, R>
where
    M: ImplicitStep<S, R>,
    S: PhaseSpace<R>,
    R: Real,
    P: Probe<S, R>,
{
    const EFFORT: Effort = P::EFFORT;
    const MAGNITUDES: Magnitudes = M::POLICY.magnitudes;

    fn is_bound_by_energy(&self) -> bool {
        matches!(M::POLICY.branch, Branch::OfEnergy)
    }

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
        watch: &mut Watch<'_, S, R, P, M::Seen>,
        x: &M::Unknown,
        matrix: &mut Square<M::Unknown>,
    ) -> M::Unknown {
        M::residual(self, watch, x, matrix)
    }

    #[inline(always)]
    fn image(&self, watch: &mut Watch<'_, S, R, P, M::Seen>, x: &M::Unknown) -> M::Unknown {
        M::image(self, watch, x)
    }
}

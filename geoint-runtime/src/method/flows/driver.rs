//! The driver of alternating flows: one step, or many steps, of every splitting method.
//!
//! A step applies flows in alternation: outer, inner, outer, inner, …, outer. Its last flow and the first flow of the next step belong to the same part of the
//! energy, so that a run applies both as one flow, the joint. A state is the point after the last flow. The next step continues from a stored point: the start of
//! the joint, or its end if the state is the middle of the joint. A run therefore has the same digits in single steps and in one call, and reading a state does
//! not change the run.

use super::open::Open;
use crate::method::{Clock, Failure, Probe, Step, Unwatched};
use crate::scalar::Real;
use crate::space::{Array, Point, Summation};
use crate::system::PhaseSpace;

/// The place of an outer flow.
#[derive(Clone, Copy, Debug)]
pub(super) enum Outer {
    /// The first flow of a step that does not continue another step.
    First,
    /// The flow after the given inner flow, counted from 0. After the last inner flow, it includes the first flow of the next step.
    Joint(usize),
    /// The last flow of a step that is not continued.
    Last,
}

/// Outer and inner flows in alternation, prepared for steps of one length.
///
/// Each flow gets the step that it belongs to: the time at which the step starts, and the point that the flow moves.
pub(super) trait Alternation<S: PhaseSpace<R>, R: Real> {
    /// The number of inner flows of a step.
    const INNER: usize;
    /// Returns whether the last flow of a step and the first one of the next are one flow.
    fn are_merged(&self) -> bool;
    /// Returns whether the last flow and the first one are equal, add an increment, and need the same evaluation of the force. The state is then the mean of
    /// the two ends of the joint, so that a single step with plain sums needs one evaluation, not two. The joint must not change the action.
    fn shows_middle_of_joint(&self) -> bool;
    /// Applies an outer flow.
    ///
    /// # Errors
    /// If the flow has no result.
    fn outer<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        place: Outer,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure>;
    /// Applies the `i`-th inner flow.
    ///
    /// # Errors
    /// If the flow has no result.
    fn inner<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        i: usize,
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure>;
}

/// Takes one step.
///
/// # Errors
/// If a flow has no result. The point is then invalid.
#[inline(always)]
pub(super) fn step<F: Alternation<S, R>, S: PhaseSpace<R>, R: Real, C: Summation<S::Phase>, P: Probe<S, R>>(
    flows: &F,
    open: &mut Open<S::Phase, S::Action>,
    mut step: Step<'_, S, R, C, P>,
) -> Result<(), Failure> {
    begin(flows, open, step.part([step.t, step.end]))?;
    finish(flows, open, step)
}

/// Takes `steps` steps. The i-th one starts at `clock.at(i)` and ends at `clock.at(i + 1)`.
///
/// # Errors
/// If a flow has no result. The point is then invalid.
#[inline(always)]
pub(super) fn advance<F: Alternation<S, R>, S: PhaseSpace<R>, R: Real, C: Summation<S::Phase>>(
    flows: &F,
    open: &mut Open<S::Phase, S::Action>,
    system: &S,
    clock: &Clock<R>,
    steps: u64,
    x: &mut Point<S::Phase, C, S::Action>,
) -> Result<(), Failure> {
    let Some(last) = steps.checked_sub(1) else { return Ok(()) };
    let probe = &mut Unwatched;
    begin(flows, open, Step { system, t: clock.at(0), end: clock.at(1), x, probe })?;
    rounds(flows, system, clock, last, x)?;
    finish(flows, open, Step { system, t: clock.at(last), end: clock.at(steps), x, probe })
}

/// Applies the first flow of a step, or the joint with the step before.
#[inline(always)]
fn begin<F: Alternation<S, R>, S: PhaseSpace<R>, R: Real, C: Summation<S::Phase>, P: Probe<S, R>>(
    flows: &F,
    open: &Open<S::Phase, S::Action>,
    step: Step<'_, S, R, C, P>,
) -> Result<(), Failure> {
    let before = if merges::<F, S, R, P>(flows) { open.return_to(step.t, step.x) } else { None };
    match before {
        Some(_) if flows.shows_middle_of_joint() => Ok(()),
        Some(before) => flows.outer(Outer::Joint(F::INNER - 1), Step { t: before, end: step.t, ..step }),
        None => flows.outer(Outer::First, step),
    }
}

/// Applies the flows of steps after their first flow, with the joint to the next step.
///
/// A function of its own with a local copy of the point: the coordinates of small systems stay in registers.
#[inline(never)]
fn rounds<F: Alternation<S, R>, S: PhaseSpace<R>, R: Real, C: Summation<S::Phase>>(
    flows: &F,
    system: &S,
    clock: &Clock<R>,
    steps: u64,
    x: &mut Point<S::Phase, C, S::Action>,
) -> Result<(), Failure> {
    let mut here = *x;
    for n in 0..steps {
        let [t, end] = [clock.at(n), clock.at(n + 1)];
        for i in 0..F::INNER {
            flows.inner(i, Step { system, t, end, x: &mut here, probe: &mut Unwatched })?;
            flows.outer(Outer::Joint(i), Step { system, t, end, x: &mut here, probe: &mut Unwatched })?;
        }
    }
    *x = here;
    Ok(())
}

/// Applies the flows of a step after its first flow. Stores the point from which the next step continues.
#[inline(always)]
fn finish<F: Alternation<S, R>, S: PhaseSpace<R>, R: Real, C: Summation<S::Phase>, P: Probe<S, R>>(
    flows: &F,
    open: &mut Open<S::Phase, S::Action>,
    mut step: Step<'_, S, R, C, P>,
) -> Result<(), Failure> {
    let times = [step.t, step.end];
    for i in 0..F::INNER {
        flows.inner(i, step.part(times))?;
        if i + 1 < F::INNER {
            flows.outer(Outer::Joint(i), step.part(times))?;
        }
    }
    if !merges::<F, S, R, P>(flows) {
        return flows.outer(Outer::Last, step);
    }
    if flows.shows_middle_of_joint() {
        let before = *step.x;
        flows.outer(Outer::Joint(F::INNER - 1), step.part(times))?;
        open.leave(step.x);
        if C::PLAIN {
            step.x.z = mean(&before.z, &step.x.z);
        } else {
            // A mean would lose the compensation of the sums.
            *step.x = before;
            flows.outer(Outer::Last, step.part(times))?;
        }
    } else {
        open.leave(step.x);
        flows.outer(Outer::Last, step.part(times))?;
    }
    open.end(times, step.x);
    Ok(())
}

/// Returns whether flows are merged between steps. A thorough step repeats a refused step, and evaluates the same flows whatever came before. It neither
/// continues a step nor is continued.
#[inline(always)]
fn merges<F: Alternation<S, R>, S: PhaseSpace<R>, R: Real, P: Probe<S, R>>(flows: &F) -> bool {
    !P::EFFORT.is_thorough() && flows.are_merged()
}

/// Returns (a + b)/2.
#[inline(always)]
fn mean<A: Array>(a: &A, b: &A) -> A {
    let mut mean = *a;
    for (mean, b) in mean.as_mut_slice().iter_mut().zip(b.as_slice()) {
        *mean = A::Real::from_f64(0.5) * (*mean + *b);
    }
    mean
}

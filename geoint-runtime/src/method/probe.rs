//! Probes, which receive the points at which a step evaluates the energy, and the checks of the end of a step.
//!
//! A step runs fast and [`Unwatched`] first. If it is refused, the caller repeats it with a probe that finds the reason.

use crate::method::Step;
use crate::scalar::Real;
use crate::solving::Failure;
use crate::solving::{Effort, Observer};
use crate::space::{Array, Point};
use crate::system::{Ends, Evaluations, Known, PhaseSpace, Poles, jump_between};

/// Receives every point at which a step evaluates the energy.
pub trait Probe<S: PhaseSpace<R>, R: Real>: Observer {
    /// The effort that a step spends on a solution. A step that is refused with [`Effort::Fast`] is repeated with [`Effort::Thorough`].
    const EFFORT: Effort = Effort::Thorough;

    /// Called before the energy is evaluated at a time and a point.
    fn visit(&mut self, t: R, z: &S::Phase, s: &S::Action);

    /// Called after an exact flow of a piece of the energy. `finite` returns whether the result is finite.
    #[inline(always)]
    fn flown(&mut self, piece: &'static str, finite: impl FnOnce() -> bool) {
        let _ = (piece, finite);
    }

    /// Called if the equation of a step in a plane has no solution. `plane` names its coordinates.
    #[inline(always)]
    fn unsolved(&mut self, plane: &'static str) {
        let _ = plane;
    }
}

/// The probe of fast steps. It ignores all points.
#[derive(Clone, Copy, Debug)]
pub struct Unwatched;

impl Observer for Unwatched {
    #[inline(always)]
    fn pause(&mut self, _: bool) {}
}

impl<S: PhaseSpace<R>, R: Real> Probe<S, R> for Unwatched {
    const EFFORT: Effort = Effort::Fast;

    #[inline(always)]
    fn visit(&mut self, _: R, _: &S::Phase, _: &S::Action) {}
}

/// Refuses a step from `before` if the energy is not defined at its end, or may have a pole on the straight line to it. For methods that do not evaluate
/// the energy at the end.
#[inline(always)]
pub(crate) fn check_end<S: PhaseSpace<R>, R: Real, C, P: Probe<S, R>>(
    poles: &Poles,
    before: &Start<S, R>,
    step: Step<'_, S, R, C, P>,
) -> Result<(), Failure> {
    let x = &*step.x;
    Failure::outside(step.system.outside_domain(step.end, &x.z, &x.s))?;
    check_poles(poles, Evaluations::AtPoints, before, step)
}

/// Refuses a step from `before` if the energy may have a pole on the straight line to its end.
///
/// A fast attempt does not search for poles, unless the system has a pole without a quick test. It sets `needs_recheck`, and the caller repeats the step
/// thoroughly: one more exit from the loop over steps would cost a tenth of a short step.
#[inline(always)]
pub(crate) fn check_poles<S: PhaseSpace<R>, R: Real, C, P: Probe<S, R>>(
    poles: &Poles,
    evaluations: Evaluations,
    (z, s): &Start<S, R>,
    Step { system, t, end: later, x, .. }: Step<'_, S, R, C, P>,
) -> Result<(), Failure> {
    let Point { z: end, s: end_s, needs_recheck, .. } = x;
    check_way::<S, R, P>(poles, evaluations, system, ([t, later], [z, end], [s, end_s]), needs_recheck)
}

/// Refuses a step if the energy may have a pole on the straight line between two points, such as its start and a stage. See [`check_poles`].
#[inline(always)]
pub(crate) fn check_way<S: PhaseSpace<R>, R: Real, P: Probe<S, R>>(
    poles: &Poles,
    evaluations: Evaluations,
    system: &S,
    ends: Ends<'_, S, R>,
    needs_recheck: &mut bool,
) -> Result<(), Failure> {
    if P::EFFORT.is_thorough() || Known::<S, R>::SEARCHED {
        return Failure::outside(poles.between(system, evaluations, ends));
    }
    *needs_recheck |= !poles.is_clear(system, evaluations, ends);
    Ok(())
}

/// Refuses a step if the energy jumps between `z` and the end of the step `x`, which differ by rounding. The equation of the step has evaluated the
/// conditions of the energy (`if`, `abs`) at `z`.
#[inline(always)]
pub(crate) fn check_conditions<S: PhaseSpace<R, Action = ()>, R: Real, C>(
    system: &S,
    t: R,
    z: &S::Phase,
    x: &Point<S::Phase, C>,
) -> Result<(), Failure> {
    Failure::outside(jump_between(system, t, [z, &x.z], [&(), &()]))
}

/// The start of a step: z and s.
pub(crate) type Start<S, R> = (<S as PhaseSpace<R>>::Phase, <S as PhaseSpace<R>>::Action);

/// Returns a copy of z and s of a point. It is made entry by entry, so that both copies may stay in registers.
#[inline(always)]
pub(crate) fn start<S: PhaseSpace<R>, R: Real, C>(x: &Point<S::Phase, C, S::Action>) -> Start<S, R> {
    let mut start = (S::Phase::zero(), x.s);
    start.0.copy_from(&x.z);
    start
}

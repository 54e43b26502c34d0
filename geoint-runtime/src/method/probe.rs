//! What sees the points at which a step evaluates the energy.

use crate::method::Step;
use crate::scalar::Real;
use crate::solving::Refusal;
use crate::solving::{Effort, Observer};
use crate::space::{Array, Point};
use crate::system::{Ends, Known, PhaseSpace, Poles, jump_between};

/// Is shown every point at which a step evaluates the energy.
pub trait Probe<S: PhaseSpace<R>, R: Real>: Observer {
    /// The effort that a step spends on a solution. A step that is refused with [`Effort::Fast`] is repeated with [`Effort::Thorough`], and watched.
    const EFFORT: Effort = Effort::Thorough;

    /// The energy is about to be evaluated here.
    fn visit(&mut self, t: R, z: &S::Phase, s: &S::Action);

    /// An exact flow of a piece of the energy has been applied, with a result that is finite or not.
    #[inline(always)]
    fn flown(&mut self, piece: &'static str, finite: impl FnOnce() -> bool) {
        let _ = (piece, finite);
    }

    /// A plane of these coordinates was not solved for.
    #[inline(always)]
    fn unsolved(&mut self, plane: &'static str) {
        let _ = plane;
    }
}

/// Sees nothing: the probe of the fast path.
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

/// Whether the energy is defined at the end of a step from `before`, and has no pole on the way there, for methods that evaluate it in
/// between only.
#[inline(always)]
pub(crate) fn check_end<S: PhaseSpace<R>, R: Real, C, P: Probe<S, R>>(
    poles: &Poles,
    before: &Start<S, R>,
    step: Step<'_, S, R, C, P>,
) -> Result<(), Refusal> {
    let x = &*step.x;
    Refusal::outside(step.system.outside_domain(step.end, &x.z, &x.s))?;
    check_poles(poles, false, before, step)
}

/// Whether the energy has no pole on the way of a step from `before`; `divided` as in [`PhaseSpace::clear_of_poles`].
///
/// Without patience the step is marked where only a search can tell, so that it is repeated: one more way out of the loop over steps
/// would cost a tenth of a short step.
#[inline(always)]
pub(crate) fn check_poles<S: PhaseSpace<R>, R: Real, C, P: Probe<S, R>>(
    poles: &Poles,
    divided: bool,
    (z, s): &Start<S, R>,
    Step { system, t, end: later, x, .. }: Step<'_, S, R, C, P>,
) -> Result<(), Refusal> {
    let Point { z: end, s: end_s, doubtful, .. } = x;
    check_way::<S, R, P>(poles, divided, system, ([t, later], [z, end], [s, end_s]), doubtful)
}

/// The same of any way: that to a stage need not be between the ends of a step.
#[inline(always)]
pub(crate) fn check_way<S: PhaseSpace<R>, R: Real, P: Probe<S, R>>(
    poles: &Poles,
    divided: bool,
    system: &S,
    ends: Ends<'_, S, R>,
    doubtful: &mut bool,
) -> Result<(), Refusal> {
    if P::EFFORT.is_thorough() || Known::<S, R>::SEARCHED {
        return Refusal::outside(poles.between(system, divided, ends));
    }
    *doubtful |= !poles.is_clear(system, divided, ends);
    Ok(())
}

/// Refuses the end of a step where rounding has decided a condition otherwise than the equation of the step has, which decided it at
/// `decided`, and the energy jumps there.
#[inline(always)]
pub(crate) fn check_conditions<S: PhaseSpace<R, Action = ()>, R: Real, C>(
    system: &S,
    t: R,
    z: &S::Phase,
    x: &Point<S::Phase, C>,
) -> Result<(), Refusal> {
    Refusal::outside(jump_between(system, t, [z, &x.z], [&(), &()]))
}

/// Where a step starts: z, s.
pub(crate) type Start<S, R> = (<S as PhaseSpace<R>>::Phase, <S as PhaseSpace<R>>::Action);

/// A copy of a point, entry by entry, so that both may stay in registers.
#[inline(always)]
pub(crate) fn start<S: PhaseSpace<R>, R: Real, C>(x: &Point<S::Phase, C, S::Action>) -> Start<S, R> {
    let mut start = (S::Phase::zero(), x.s);
    start.0.copy_from(&x.z);
    start
}

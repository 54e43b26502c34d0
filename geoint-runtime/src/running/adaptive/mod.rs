//! Steps as long as their error allows.
//!
//! What a method keeps for every h it keeps here as well: the energy under a discrete gradient, a projection, a relaxation.
//! What rests on equal steps is lost: a symplectic method drifts like any other.

mod attempt;
#[cfg(feature = "alloc")]
mod saved;
mod start;
mod steps;
mod way;

use crate::method::{Clock, Method};
use crate::running::error::StepError;
use crate::running::output::{Samples, Until};
use crate::running::reported::Reported;
use crate::running::step_size::Bounds;
use crate::running::trajectory::{Trajectory, adapt_to};
use crate::scalar::{Real, signed, zero};
use crate::space::{Coordinates, PerCoordinate, Point, Snapshot};
use crate::system::{Lagrangian, PhaseSpace, Rates, StateOf};
use core::fmt::{self, Debug, Formatter};
use steps::Steps;

/// A system under a method whose steps adapt to a tolerance: a plain value, no borrow, no allocation.
///
/// [`DOP853`](crate::DOP853) estimates the error of a step from what it evaluates, and so do Runge–Kutta–Nyström tables
/// ([`BlanesMoanSrkn14a`](crate::BlanesMoanSrkn14a) …) of canonical systems; [`Gauss`](crate::Gauss) with three and four stages of
/// at most six unknowns looks at its polynomial between them. By every other method a step is done in two halves, which are kept, and once as a
/// whole: their difference is the error. In every coordinate it may be as large as
/// `tolerance` times the largest magnitude that this coordinate has had so far, and as an absolute error beside that
/// ([`absolute`](Self::absolute)): lengths and angles, large and small motions are each followed with the same relative accuracy,
/// in any units. A coordinate at rest at zero is measured by what it becomes. What the tolerated errors of other coordinates cause
/// in a coordinate within the time in which the state changes is tolerated there as well, so that a wave that has not arrived, or a
/// node that is rounding, does not hold up the others; this is measured where a run begins, and in steps that are longer than all before. The first
/// step is no longer than the state takes to change, and one by which time alone drives a coordinate from rest, too short for that to be seen.
///
/// The difference is the error of the whole step; for a method of order p the error of the halves is a 2ᵖ-th part of it, which is
/// not counted on, because it holds for short steps only. Likewise an estimate is that of a formula of lower order than the step's, or, of Gauss's
/// methods, 2ᵖ times the error that is found. A step that is too inaccurate, or that the method refuses, is repeated with a shorter one; after an
/// error the last good state is still there.
///
/// Steps come in lengths 2^(k/4), so that most have the length of the one before: coefficients are then at hand, and implicit
/// methods know how to guess. Sums of coordinates and of time are compensated.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// /// Planar pendulum; q in rad, p in kg m²/s.
/// #[hamiltonian]
/// fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
///     p * p / (2.0 * m * l * l) - m * g * l * q.cos()
/// }
///
/// let system = Pendulum { m: 0.7, l: 1.2, g: 9.81 };
/// let mut sim = system.adaptive(DOP853, 1e-10, State::new(3.1, 0.0));
/// // Almost upside down it takes long steps, and short ones on the way down.
/// sim.advance_to(10.0)?;
/// assert_eq!(sim.time(), 10.0);
/// # Ok::<(), StepError>(())
/// ```
#[doc(alias("error control", "variable step"))]
#[derive(Clone)]
pub struct Adaptive<S: PhaseSpace<R>, M: Method<S, R>, R: Real = f64> {
    steps: Steps<S, M, R>,
    pub(in crate::running) reported: Reported<R>,
    /// Steps on the way to a time.
    most_steps: u64,
}

impl<S: PhaseSpace<R> + Rates<R>, M: Method<S, R>, R: Real> Adaptive<S, M, R> {
    /// A system under a method, with steps as long as the tolerance of a step's error allows, from `state` on.
    ///
    /// Nothing is checked yet: an unusable tolerance or state is reported by the first step.
    pub fn new(system: S, method: M, tolerance: f64, state: StateOf<S, R>) -> Self {
        let (t, z, s) = state.parts();
        let x = Point::with_action(z, s);
        let steps = Steps::new((system, method), tolerance, t, x);
        Adaptive { steps, reported: Reported::nothing(), most_steps: u64::MAX }
    }

    /// Steps between two lengths only. Without bounds the shortest is what changes time at all.
    ///
    /// The last step on the way to a given time may be shorter.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn steps_between(mut self, shortest: f64, longest: f64) -> Self {
        self.steps.bounds = Bounds { shortest: shortest.abs(), longest: longest.abs() };
        self
    }

    /// Steps of at most this length. A run may step over a force that acts for a shorter time than a step, such as a pulse. Choose `h` below the duration of
    /// the pulse.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn longest_step(mut self, h: f64) -> Self {
        self.steps.bounds.longest = h.abs();
        self
    }

    /// The first step; negative to go back in time. Without it one is guessed, forwards.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn first_step(mut self, h: f64) -> Self {
        self.steps.controller.set(h);
        self
    }

    /// Errors that are tolerated beside those relative to coordinates: one for each coordinate, in its unit, written as a state is.
    /// Without this they are zero.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn absolute(mut self, errors: StateOf<S, R>) -> Self {
        let (_, z, s) = errors.parts();
        self.steps.tolerance.absolute = PerCoordinate { z, s };
        self
    }

    /// At most so many steps in one [`advance_to`](Self::advance_to). Without this there is no limit.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn steps_at_most(mut self, steps: u64) -> Self {
        self.most_steps = steps;
        self
    }

    /// One step, of whatever length the tolerance allows.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then unchanged.
    pub fn step(&mut self) -> Result<(), StepError> {
        self.steps.check_start()?;
        self.steps.take(f64::INFINITY)
    }

    /// Steps to the time `t`, before or after now: the last one ends there.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then the last good one.
    pub fn advance_to(&mut self, t: R) -> Result<(), StepError> {
        adapt_to(self, t, self.most_steps)
    }

    /// One step to the time `t`, before or after now, or towards it; `false` if that is now.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then unchanged. A `t` that is not a number is a step size that is none.
    pub fn step_towards(&mut self, t: R) -> Result<bool, StepError> {
        self.steps.check_start()?;
        if self.time() == t {
            return Ok(false);
        }
        let left = self.steps.clock.left(t);
        if left.is_nan() {
            return Err(StepError::InvalidStepSize { h: left });
        }
        let backwards = left < 0.0;
        self.steps.controller.turn(backwards);
        self.steps.take(left.abs())?;
        loop {
            let rest = self.steps.clock.left(t);
            if rest.is_finite() && rest.abs() <= R::epsilon() * (signed(t).abs() + self.step_size().abs()) {
                self.steps.clock = Clock::new(t, zero());
                return Ok(true);
            }
            // Methods that scale their steps end a little beside it: before it, and the next step leads there, or beyond, and this one leads back.
            if (rest < 0.0) == backwards {
                return Ok(true);
            }
            self.steps.controller.turn(!backwards);
            let outcome = self.steps.take(rest.abs());
            self.steps.controller.turn(backwards);
            outcome?;
        }
    }

    /// The state after every step to the time `t`, before or after now: the last one is there.
    pub fn until(&mut self, t: R) -> Until<'_, Self> {
        Until::new(self, t)
    }

    /// The state after every `k` steps, without end. `k` = 0 counts as 1.
    pub fn sampled(&mut self, k: u64) -> Samples<'_, Self> {
        Samples::new(self, k)
    }

    /// `n` steps, of whatever lengths the tolerance allows.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then the last good one.
    pub fn advance(&mut self, n: u64) -> Result<(), StepError> {
        (0..n).try_for_each(|_| self.step())
    }

    /// Returns whether no step was taken since the state was set, by the user or at an event.
    pub(in crate::running) fn is_fresh(&self) -> bool {
        self.steps.taken == self.steps.given
    }

    /// What the next step says of the state before it does anything.
    pub(in crate::running) fn check_start(&self) -> Result<(), StepError> {
        self.steps.check_start()
    }

    /// Goes on from this state, with a first step that is guessed.
    pub(in crate::running) fn restart(&mut self, state: StateOf<S, R>) {
        let (t, z, s) = state.parts();
        self.steps.restart(t, Point::with_action(z, s));
    }

    /// Replaces the system by one with other parameters. Time, state, settings and the number of steps stay; the next step size is guessed anew.
    pub fn set_system(&mut self, system: S) {
        self.steps.set_system(system);
    }

    /// Time now.
    pub fn time(&self) -> R {
        self.steps.time()
    }

    /// The state now.
    pub fn state(&self) -> StateOf<S, R> {
        S::State::of(self.time(), self.steps.x.z, self.steps.x.s)
    }

    /// The energy now.
    pub fn energy(&self) -> R {
        let Steps { system, x, .. } = &self.steps;
        system.hamiltonian(self.time(), &x.z, &x.s)
    }

    /// The velocities now, of a system that was written as a Lagrangian.
    pub fn velocity(&self) -> S::Coordinates
    where
        S: Lagrangian<R>,
    {
        let Steps { system, x, .. } = &self.steps;
        S::Coordinates::from_array(system.velocity(self.time(), &x.z, &x.s))
    }

    /// The length of the next step, if the tolerance allows it and no time to end at is nearer.
    pub fn step_size(&self) -> f64 {
        self.steps.size()
    }

    /// The number of steps taken; two halves are one.
    pub fn steps(&self) -> u64 {
        self.steps.taken
    }

    /// The number of steps that were tried and not taken.
    pub fn rejections(&self) -> u64 {
        self.steps.rejections
    }

    /// The system with its parameters.
    pub fn system(&self) -> &S {
        &self.steps.system
    }

    /// The method.
    pub fn method(&self) -> &M {
        &self.steps.method
    }
}

impl<S: PhaseSpace<R> + Debug, M: Method<S, R> + Debug, R: Real> Debug for Adaptive<S, M, R> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Steps { system, method, clock, x, taken, rejections, .. } = &self.steps;
        let mut run = f.debug_struct("Adaptive");
        run.field("system", system).field("method", method).field("clock", clock).field("x", x);
        run.field("steps", taken).field("rejections", rejections).finish_non_exhaustive()
    }
}

impl<S: PhaseSpace<R> + Rates<R>, M: Method<S, R>, R: Real> Trajectory for Adaptive<S, M, R> {
    type State = StateOf<S, R>;

    fn step(&mut self) -> Result<(), StepError> {
        self.step()
    }
    fn advance(&mut self, n: u64) -> Result<(), StepError> {
        self.advance(n)
    }
    fn step_towards(&mut self, t: R) -> Result<bool, StepError> {
        self.step_towards(t)
    }
    fn advance_to(&mut self, t: R) -> Result<(), StepError> {
        self.advance_to(t)
    }
    fn time(&self) -> R {
        self.time()
    }
    fn state(&self) -> Self::State {
        self.state()
    }
    fn energy(&self) -> R {
        self.energy()
    }
    fn steps(&self) -> u64 {
        self.steps()
    }
}

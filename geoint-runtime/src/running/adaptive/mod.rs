//! Integration with an adaptive step size.
//!
//! A method that conserves a quantity for every step size h also conserves it here. Examples are the energy under a discrete gradient, a projection,
//! or a relaxation. Properties that require equal steps are lost: under a symplectic method the energy drifts as under any other method.

mod attempt;
#[cfg(feature = "alloc")]
mod saved;
mod start;
mod steps;
mod way;

use crate::method::{Clock, Method};
use crate::running::error::StepError;
use crate::running::reported::Reported;
use crate::running::step_size::Bounds;
use crate::running::trajectory::{Samples, Trajectory, Until, adapt_to};
use crate::scalar::{Real, signed, zero};
use crate::space::{Coordinates, PerCoordinate, Point, Snapshot};
use crate::system::{Lagrangian, PhaseSpace, Rates, StateOf};
use core::fmt::{self, Debug, Formatter};
use steps::Steps;

/// Integrates a system with a step size that adapts to a tolerance. The value borrows nothing and allocates nothing.
///
/// # Error estimate
/// - [`DOP853`](crate::DOP853) estimates the error from the stages of the step.
/// - Runge–Kutta–Nyström tables ([`BlanesMoanSrkn14a`](crate::BlanesMoanSrkn14a) …) of canonical systems have estimates of their own, too.
/// - [`Gauss`](crate::Gauss) with three or four stages and at most six unknowns checks its polynomial between the stages.
/// - Every other method takes the step as two halves and as a whole. The error is the difference. The run continues from the two halves.
///
/// The difference is the error of the whole step. For a method of order p, the halves have an error that is smaller by 2ᵖ. This factor is not used,
/// because it holds only for short steps. An estimate by stages is the error of a formula of lower order than the step. For Gauss methods, the
/// estimate is 2ᵖ times the error found.
///
/// # Tolerance
/// The tolerated error of a coordinate is `tolerance` times the largest magnitude that the coordinate has had so far. An [`absolute`](Self::absolute)
/// error may be added. Lengths and angles, and large and small motions, then have the same relative accuracy in any units.
///
/// The size of a coordinate at rest at zero is the magnitude that it reaches. Such a coordinate also tolerates the error that the tolerated errors of
/// other coordinates cause in it, within the time in which the state changes. Without this rule, a site that a wave has not reached yet would force
/// tiny steps, and so would a node that contains only rounding. This error is measured at the start of a run, and in steps longer than all steps
/// before.
///
/// # Steps
/// The first step is at most the time in which the state changes. If time alone drives a coordinate from rest, the error of the step is not measured.
/// Such a step is short enough to keep this error within the tolerance. A step that is too inaccurate, or that the method refuses, is repeated with a
/// shorter length. After an error, the last good state is still available.
///
/// Step lengths are 2^(k/4), so most steps have the length of the step before. Coefficients are then reused, and implicit methods can extrapolate
/// their first guess. Sums of coordinates and of time are compensated.
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
    /// Maximum number of steps in one `advance_to`.
    most_steps: u64,
}

impl<S: PhaseSpace<R> + Rates<R>, M: Method<S, R>, R: Real> Adaptive<S, M, R> {
    /// Integrates a system from `state` on, with a step size that adapts to the tolerance.
    ///
    /// Nothing is checked yet: the first step reports an unusable tolerance or state.
    pub fn new(system: S, method: M, tolerance: f64, state: StateOf<S, R>) -> Self {
        let (t, z, s) = state.parts();
        let x = Point::with_action(z, s);
        let steps = Steps::new((system, method), tolerance, t, x);
        Adaptive { steps, reported: Reported::nothing(), most_steps: u64::MAX }
    }

    /// Sets the shortest and the longest step. Without bounds, the shortest step is the least one that changes the time.
    ///
    /// The last step before a given time may be shorter.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn steps_between(mut self, shortest: f64, longest: f64) -> Self {
        self.steps.bounds = Bounds { shortest: shortest.abs(), longest: longest.abs() };
        self
    }

    /// Sets the longest step. A run may step over a force that acts for a shorter time than a step, such as a pulse. Choose `h` below the duration of
    /// the pulse.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn longest_step(mut self, h: f64) -> Self {
        self.steps.bounds.longest = h.abs();
        self
    }

    /// Sets the first step; a negative one goes back in time. Without this setting, the first step is estimated, and goes forwards.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn first_step(mut self, h: f64) -> Self {
        self.steps.controller.set(h);
        self
    }

    /// Sets tolerated absolute errors, which are added to the relative ones. Each coordinate has an error in its own unit, written in the form of a
    /// state. The default is zero.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn absolute(mut self, errors: StateOf<S, R>) -> Self {
        let (_, z, s) = errors.parts();
        self.steps.tolerance.absolute = PerCoordinate { z, s };
        self
    }

    /// Limits the number of steps in one [`advance_to`](Self::advance_to). The default is no limit.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn steps_at_most(mut self, steps: u64) -> Self {
        self.most_steps = steps;
        self
    }

    /// Takes one step. Its length follows from the tolerance.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then unchanged.
    pub fn step(&mut self) -> Result<(), StepError> {
        self.steps.check_start()?;
        self.steps.take(f64::INFINITY)
    }

    /// Steps to the time `t`, before or after the present time. The last step ends there.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then the last good one.
    pub fn advance_to(&mut self, t: R) -> Result<(), StepError> {
        adapt_to(self, t, self.most_steps)
    }

    /// Takes one step to the time `t`, or towards it. The time may lie before or after the present time. Returns `false` if `t` is the present time.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then unchanged. A `t` that is not a number gives the error of an invalid step size.
    pub fn step_towards(&mut self, t: R) -> Result<bool, StepError> {
        self.steps.check_start()?;
        if self.time() == t {
            return Ok(false);
        }
        let left = self.steps.clock.left(t);
        if left.is_nan() {
            return Err(StepError::of_step_size(signed(self.time()), left));
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
            // Methods that scale their steps end near `t`, not at it. Before `t`, the next step leads there. Beyond `t`, a step back follows here.
            if (rest < 0.0) == backwards {
                return Ok(true);
            }
            self.steps.controller.turn(!backwards);
            let outcome = self.steps.take(rest.abs());
            self.steps.controller.turn(backwards);
            outcome?;
        }
    }

    /// Returns an iterator over the states after every step to the time `t`, before or after the present time. The last state is at `t`.
    pub fn until(&mut self, t: R) -> Until<'_, Self> {
        Until::new(self, t)
    }

    /// Returns an endless iterator over the states after every `k` steps. `k` = 0 counts as 1.
    pub fn sampled(&mut self, k: u64) -> Samples<'_, Self> {
        Samples::new(self, k)
    }

    /// Takes `n` steps. Their lengths follow from the tolerance.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then the last good one.
    pub fn advance(&mut self, n: u64) -> Result<(), StepError> {
        (0..n).try_for_each(|_| self.step())
    }

    /// Returns whether no step was taken since the state was set, by the user or at an event.
    pub(in crate::running) fn is_fresh(&self) -> bool {
        self.steps.taken == self.steps.given
    }

    /// Checks the state in the way of the next step.
    pub(in crate::running) fn check_start(&self) -> Result<(), StepError> {
        self.steps.check_start()
    }

    /// Continues from this state, with an estimated first step.
    pub(in crate::running) fn restart(&mut self, state: StateOf<S, R>) {
        let (t, z, s) = state.parts();
        self.steps.restart(t, Point::with_action(z, s));
    }

    /// Replaces the system by one with other parameters. Time, state, settings and the number of steps remain. The next step size is estimated anew.
    pub fn set_system(&mut self, system: S) {
        self.steps.set_system(system);
    }

    /// Returns the present time.
    pub fn time(&self) -> R {
        self.steps.time()
    }

    /// Returns the present state.
    pub fn state(&self) -> StateOf<S, R> {
        S::State::of(self.time(), self.steps.x.z, self.steps.x.s)
    }

    /// Returns the present energy.
    pub fn energy(&self) -> R {
        let Steps { system, x, .. } = &self.steps;
        system.hamiltonian(self.time(), &x.z, &x.s)
    }

    /// Returns the present velocities of a system that was written as a Lagrangian.
    pub fn velocity(&self) -> S::Coordinates
    where
        S: Lagrangian<R>,
    {
        let Steps { system, x, .. } = &self.steps;
        S::Coordinates::from_array(system.velocity(self.time(), &x.z, &x.s))
    }

    /// Returns the length of the next step. A rejection, or the end of the integration, may shorten it.
    pub fn step_size(&self) -> f64 {
        self.steps.size()
    }

    /// Returns the number of steps taken. Two halves count as one step.
    pub fn steps(&self) -> u64 {
        self.steps.taken
    }

    /// Returns the number of rejected steps.
    pub fn rejections(&self) -> u64 {
        self.steps.rejections
    }

    /// Returns the system with its parameters.
    pub fn system(&self) -> &S {
        &self.steps.system
    }

    /// Returns the method.
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

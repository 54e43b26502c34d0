//! Integration by Taylor series of the solution.
//!
//! The coefficients at the end of a step are computed with this step, and reused for the next one. Their first order, the rates, checks whether the
//! polynomial led to a solution.

#[cfg(feature = "alloc")]
mod saved;
pub(in crate::running) mod steps;

use crate::running::error::StepError;
use crate::running::reported::Reported;
use crate::running::step_size::Bounds;
use crate::running::trajectory::{Trajectory, adapt_to};
use crate::scalar::{Real, signed};
use crate::space::{Coordinates, Snapshot};
use crate::system::{Jets, Lagrangian, StateOf};
use crate::taylor::TaylorMethod;
use core::fmt::{self, Debug, Formatter};
use steps::Steps;

/// Integrates a system by Taylor series of its solution. The value borrows nothing and allocates nothing.
///
/// The last coefficients determine the step length ([`Taylor`](crate::Taylor), [`TaylorOrder`](crate::TaylorOrder)), or it is fixed
/// ([`TaylorFixed`](crate::TaylorFixed)). After each step, the rates at its end are compared with those of its polynomial. If they differ by much
/// more than the tolerance, the step is repeated with half the length. This happens at poles that the last coefficients do not show.
///
/// A step ends where a condition of the energy changes, even a step of fixed length. The function that decides a condition is used only within the
/// range of its own series. The run is refused if it cannot leave a condition: if both sides lead back to it (sliding), or if it bounces there with
/// decreasing height.
///
/// Sums of coordinates and of time are compensated.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// #[hamiltonian]
/// fn kepler(q: [f64; 2], p: [f64; 2]) -> f64 {
///     (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
/// }
///
/// let mut sim = Kepler.taylor(Taylor::default(), State::new([0.4, 0.0], [0.0, 2.0]));
/// let energy = sim.energy();
/// sim.advance_to(200.0 * std::f64::consts::PI)?;
/// assert!((sim.energy() - energy).abs() < 1e-14);
/// // The polynomial of the last step.
/// let before = sim.at(sim.time() - sim.step_size() / 2.0).expect("within the last step");
/// assert!((Kepler.energy(&before) - energy).abs() < 1e-14);
/// # Ok::<(), StepError>(())
/// ```
#[doc(alias = "jet transport")]
#[derive(Clone)]
pub struct TaylorIntegrator<S: Jets<R>, M: TaylorMethod<S, R>, R: Real = f64> {
    pub(in crate::running) steps: Steps<S, M, R>,
    pub(in crate::running) reported: Reported<R>,
    /// Maximum number of steps in one `advance_to`.
    most_steps: u64,
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> TaylorIntegrator<S, M, R> {
    /// Integrates a system by Taylor series of its solution, from `state` on.
    ///
    /// Nothing is checked yet: the first step reports an unusable tolerance, order or state.
    pub fn new(system: S, method: M, state: StateOf<S, R>) -> Self {
        let (t, z, s) = state.parts();
        let steps = Steps::new((system, method), t, (z, s));
        TaylorIntegrator { steps, reported: Reported::nothing(), most_steps: u64::MAX }
    }

    /// Sets the shortest and the longest step. Without bounds, the shortest step is the least one that changes the time. Steps of fixed length ignore
    /// the bounds.
    ///
    /// The last step before a given time may be shorter, and so may a step that ends where a condition of the energy changes.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn steps_between(mut self, shortest: f64, longest: f64) -> Self {
        self.steps.bounds = Bounds { shortest: shortest.abs(), longest: longest.abs() };
        self
    }

    /// Sets the longest step. A run may step over a force that acts for a shorter time than a step, such as a pulse. Choose `h` below the duration of
    /// the pulse. Steps of fixed length ignore this setting.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn longest_step(mut self, h: f64) -> Self {
        self.steps.bounds.longest = h.abs();
        self
    }

    /// Limits the number of steps in one [`advance_to`](Self::advance_to). The default is no limit.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn steps_at_most(mut self, steps: u64) -> Self {
        self.most_steps = steps;
        self
    }

    /// Takes one step: forwards, or in the direction of the last step.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then unchanged.
    pub fn step(&mut self) -> Result<(), StepError> {
        self.steps.check_start()?;
        self.steps.take(f64::INFINITY)
    }

    /// Takes `n` steps.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then the last good one.
    pub fn advance(&mut self, n: u64) -> Result<(), StepError> {
        (0..n).try_for_each(|_| self.step())
    }

    /// Steps to the time `t`, before or after the present time. The last step ends there.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then the last good one. A `t` that is not finite gives the error of an invalid step size.
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
        let left = self.steps.here().clock.left(t);
        if left.is_nan() {
            return Err(StepError::of_step_size(signed(self.time()), left));
        }
        self.steps.backwards = left < 0.0;
        self.steps.take(left.abs())?;
        if left.is_finite() && self.steps.here().clock.left(t).abs() <= R::epsilon() * signed(t).abs() {
            self.steps.here_mut().clock.name(t);
        }
        Ok(true)
    }

    /// Returns the state at a time within the last step, by its polynomial. Returns `None` outside of this step, and also if there is no last step.
    /// This is so if no step was taken, if a step was refused since, or if the run continued from an event, another state or a saved run.
    pub fn at(&self, t: R) -> Option<StateOf<S, R>> {
        self.steps.at(t)
    }

    /// Continues from this state.
    pub(in crate::running) fn restart(&mut self, state: StateOf<S, R>) {
        let (t, z, s) = state.parts();
        self.steps.restart(t, (z, s));
    }

    /// Replaces the system by one with other parameters. Time, state, settings and the number of steps remain.
    pub fn set_system(&mut self, system: S) {
        self.steps.set_system(system);
    }

    /// Returns the present time.
    pub fn time(&self) -> R {
        self.steps.time()
    }

    /// Returns the present state.
    pub fn state(&self) -> StateOf<S, R> {
        S::State::of(self.time(), self.steps.here().x.z, self.steps.here().x.s)
    }

    /// Returns the present energy.
    pub fn energy(&self) -> R {
        self.steps.system.hamiltonian(self.time(), &self.steps.here().x.z, &self.steps.here().x.s)
    }

    /// Returns the present velocities of a system that was written as a Lagrangian.
    pub fn velocity(&self) -> S::Coordinates
    where
        S: Lagrangian<R>,
    {
        let x = &self.steps.here().x;
        S::Coordinates::from_array(self.steps.system.velocity(self.time(), &x.z, &x.s))
    }

    /// Returns the length of the last step; zero before the first one.
    pub fn step_size(&self) -> f64 {
        self.steps.step
    }

    /// Returns the number of steps taken.
    pub fn steps(&self) -> u64 {
        self.steps.taken
    }

    /// Returns the order of the series.
    pub fn order(&self) -> usize {
        self.steps.order()
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

impl<S: Jets<R> + Debug, M: TaylorMethod<S, R>, R: Real> Debug for TaylorIntegrator<S, M, R> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (Steps { system, method, taken, .. }, here) = (&self.steps, self.steps.here());
        let mut run = f.debug_struct("TaylorIntegrator");
        run.field("system", system).field("method", method).field("order", &self.order());
        run.field("clock", &here.clock).field("x", &here.x);
        run.field("steps", taken).finish_non_exhaustive()
    }
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Trajectory for TaylorIntegrator<S, M, R> {
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

//! Integration by Taylor series of the solution.
//!
//! The coefficients at the end of a step are computed with this step, and reused for the next one. Their first order, the rates, checks whether the
//! polynomial led to a solution.

mod steps;

use crate::running::error::StepError;
use crate::running::pace::{Coordinates, Pace, step_until};
use crate::running::run::Run;
use crate::running::step_size::Bounds;
use crate::scalar::{Real, signed};
use crate::solving::Failure;
use crate::space::{PerCoordinate, Snapshot};
use crate::system::{Jets, StateOf};
use crate::taylor::TaylorMethod;
#[cfg(feature = "alloc")]
use crate::{method::Name, space::Tape};
use core::fmt::{self, Debug, Formatter};
pub use steps::Series;

/// A run by Taylor series of the solution.
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
/// let before = sim.at(sim.time() - sim.last_step() / 2.0)?;
/// assert!((Kepler.energy(&before) - energy).abs() < 1e-14);
/// # Ok::<(), StepError>(())
/// ```
#[doc(alias = "jet transport")]
pub type TaylorIntegrator<S, M, R = f64> = Run<Series<S, M, R>>;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Run<Series<S, M, R>> {
    /// Integrates a system by Taylor series of its solution, from `state` on.
    ///
    /// Nothing is checked yet: the first step reports an unusable tolerance, order or state.
    pub fn new(system: S, method: M, state: StateOf<S, R>) -> Self {
        let (t, z, s) = state.parts();
        Run::of(Series::new((system, method), t, (z, s)))
    }

    /// Sets the shortest and the longest step. Without bounds, the shortest step is the least one that changes the time. Steps of fixed length ignore
    /// the bounds.
    ///
    /// The last step before a given time may be shorter, and so may a step that ends where a condition of the energy changes.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn steps_between(mut self, shortest: f64, longest: f64) -> Self {
        self.pace.bounds = Bounds { shortest: shortest.abs(), longest: longest.abs() };
        self
    }

    /// Sets the longest step. A run may step over a force that acts for a shorter time than a step, such as a pulse. Choose `h` below the duration of
    /// the pulse. Steps of fixed length ignore this setting.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn longest_step(mut self, h: f64) -> Self {
        self.pace.bounds.longest = h.abs();
        self
    }

    /// Limits the number of steps in one [`advance_to`](Run::advance_to): more are the error [`TooManySteps`](crate::Failure::TooManySteps). The default is no
    /// limit. Iterators of steps, states within steps, and searches for events are not limited.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn steps_at_most(mut self, steps: u64) -> Self {
        self.most_steps = steps;
        self
    }

    /// Returns the length of the last step, negative if it went back in time; zero before the first one.
    pub fn last_step(&self) -> f64 {
        self.pace.step
    }

    /// Returns the order of the series.
    pub fn order(&self) -> usize {
        self.pace.terms()
    }
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Pace for Series<S, M, R> {
    type Real = R;
    type System = S;
    type Method = M;

    fn system(&self) -> &S {
        &self.system
    }
    fn method(&self) -> &M {
        &self.method
    }
    fn taken(&self) -> u64 {
        self.taken
    }
    fn time(&self) -> R {
        self.now()
    }
    fn point(&self) -> Coordinates<Self> {
        PerCoordinate::of(&self.here().x)
    }
    fn steps_backwards(&self) -> bool {
        self.backwards
    }
    fn is_fresh(&self) -> bool {
        false
    }

    fn check_start(&self) -> Result<(), StepError> {
        self.check()
    }
    /// Takes one step: forwards, or in the direction of the last step.
    fn step(&mut self) -> Result<(), StepError> {
        self.check()?;
        self.take(f64::INFINITY)
    }
    fn step_towards(&mut self, t: R) -> Result<bool, StepError> {
        self.check()?;
        if self.now() == t {
            return Ok(false);
        }
        let left = self.here().clock.left(t);
        if left.is_nan() {
            return Err(StepError::of_step_size(signed(self.now()), left));
        }
        self.backwards = left < 0.0;
        self.take(left.abs())?;
        if left.is_finite() && self.here().clock.left(t).abs() <= R::epsilon() * signed(t).abs() {
            self.here_mut().clock.name(t);
        }
        Ok(true)
    }
    fn advance_to(&mut self, t: R, most_steps: u64) -> Result<(), StepError> {
        step_until(self, t, most_steps)
    }

    fn restart(&mut self, state: StateOf<S, R>) {
        let (t, z, s) = state.parts();
        self.continue_from(t, (z, s));
    }
    fn set_system(&mut self, system: S) {
        self.replace_system(system);
    }

    fn end_at(&mut self, t: R, most_steps: u64) -> Result<(), StepError> {
        step_until(self, t, most_steps)
    }
    fn before(&self) -> Option<Self> {
        self.at_start_of_last_step()
    }
    fn between(_: &Self, after: &Self, t: R) -> Result<StateOf<S, R>, StepError> {
        after.state_within(t).ok_or(StepError::without_step(Failure::TimePassed, signed(t)))
    }

    #[cfg(feature = "alloc")]
    fn name(&self) -> Name {
        Name::new("Taylor")
    }
    #[cfg(feature = "alloc")]
    fn record(&mut self, tape: &mut impl Tape<R>) {
        self.record_steps(tape);
    }
    #[cfg(feature = "alloc")]
    fn complete(&mut self) -> bool {
        self.forget();
        self.here().x.is_finite() && self.now().magnitude() < f64::INFINITY
    }
}

impl<S: Jets<R> + Debug, M: TaylorMethod<S, R>, R: Real> Debug for Series<S, M, R> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (Series { system, method, taken, .. }, here) = (self, self.here());
        let mut run = f.debug_struct("TaylorIntegrator");
        run.field("system", system).field("method", method).field("order", &self.terms());
        run.field("clock", &here.clock).field("x", &here.x);
        run.field("steps", taken).finish_non_exhaustive()
    }
}

//! Integration with an adaptive step size.
//!
//! A method that conserves a quantity for every step size h also conserves it here. Examples are the energy under a discrete gradient, a projection,
//! or a relaxation. Properties that require equal steps are lost: under a symplectic method the energy drifts as under any other method.

mod attempt;
mod start;
mod steps;
mod take;
mod way;

use crate::method::{Clock, Method};
use crate::running::error::StepError;
use crate::running::pace::{Coordinates, Pace, PartialSteps, step_until};
use crate::running::run::Run;
use crate::running::step_size::Bounds;
use crate::scalar::{Real, signed, zero};
use crate::space::{PerCoordinate, Point, Snapshot};
use crate::system::{PhaseSpace, Rates, StateOf};
#[cfg(feature = "alloc")]
use crate::{method::Name, space::Record, space::Tape};
use attempt::no_history;
use core::fmt::{self, Debug, Formatter};
pub use steps::Controlled;
use steps::Past;

/// A run with a step size that adapts to a tolerance.
///
/// # Error estimate
/// - [`DOP853`](crate::DOP853) estimates the error from the stages of the step.
/// - Runge–Kutta–Nyström tables ([`BlanesMoanSrkn14a`](crate::BlanesMoanSrkn14a) …) of canonical systems have estimates of their own, too.
/// - [`Gauss`](crate::Gauss) with three or four stages, whose unknowns are at most six values of the field a stage, checks its polynomial between the stages.
/// - Every other method takes the step as two halves and as a whole. The error is the difference. The run continues from the two halves.
///
/// The difference is the error of the whole step. For a method of order p, the halves have an error that is smaller by 2ᵖ. This factor is not used,
/// because it holds only for short steps. An estimate by stages is the error of a formula of lower order than the step. For Gauss methods, the
/// estimate is 2ᵖ times the error found.
///
/// # Tolerance
/// The tolerated error of a coordinate is `tolerance` times the largest magnitude that the coordinate has had so far. An [`absolute`](Run::absolute)
/// error may be added. Lengths and angles, and large and small motions, then have the same relative accuracy in any units.
///
/// The size of a coordinate at rest at zero is the magnitude that it reaches. Errors of other coordinates cause an error in it. The error that their
/// tolerated errors cause, within the time in which the state changes, is tolerated, too. Without this rule, a site that a wave has not reached yet would force
/// tiny steps, and so would a node that contains only rounding. This error is measured at the start of a run, and in steps longer than all steps
/// before.
///
/// # Steps
/// The first step is at most the time in which the state changes. If time alone drives a coordinate from rest, its error is not measured. The step is shortened
/// until the force grows like a power of time within it, but not below √ε |t|: a sudden onset is stepped over. A step that is too inaccurate, or that the
/// method refuses, is repeated with a shorter length. After an error, the last good state is still available.
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
pub type Adaptive<S, M, R = f64> = Run<Controlled<S, M, R>>;

impl<S: PhaseSpace<R> + Rates<R>, M: Method<S, R>, R: Real> Run<Controlled<S, M, R>> {
    /// Integrates a system from `state` on, with a step size that adapts to the tolerance.
    ///
    /// Nothing is checked yet: the first step reports an unusable tolerance or state.
    pub fn new(system: S, method: M, tolerance: f64, state: StateOf<S, R>) -> Self {
        let (t, z, s) = state.parts();
        Run::of(Controlled::new((system, method), tolerance, t, Point::with_action(z, s)))
    }

    /// Sets the shortest and the longest step. Steps are never below the resolution of time, whatever the bounds.
    ///
    /// The last step before a given time may be shorter.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn steps_between(mut self, shortest: f64, longest: f64) -> Self {
        self.pace.bounds = Bounds { shortest: shortest.abs(), longest: longest.abs() };
        self
    }

    /// Sets the longest step. A run may step over a force that acts for a shorter time than a step, such as a pulse. Choose `h` below the duration of
    /// the pulse.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn longest_step(mut self, h: f64) -> Self {
        self.pace.bounds.longest = h.abs();
        self
    }

    /// Sets the first step; a negative one goes back in time. Without this setting, the first step is estimated, and goes forwards.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn first_step(mut self, h: f64) -> Self {
        self.pace.controller.set(h);
        self
    }

    /// Sets tolerated absolute errors, which are added to the relative ones. Each coordinate has an error in its own unit, written in the form of a
    /// state. The default is zero.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn absolute(mut self, errors: StateOf<S, R>) -> Self {
        let (_, z, s) = errors.parts();
        self.pace.tolerance.absolute = PerCoordinate { z, s };
        self
    }

    /// Limits the number of steps in one [`advance_to`](Run::advance_to): more are the error [`TooManySteps`](crate::Failure::TooManySteps). The default is no
    /// limit. Iterators of steps, states within steps, and searches for events are not limited.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn steps_at_most(mut self, steps: u64) -> Self {
        self.most_steps = steps;
        self
    }

    /// Returns the length of the next step. A rejection, or the end of the integration, may shorten it.
    pub fn step_size(&self) -> f64 {
        self.pace.size()
    }

    /// Returns the number of rejected steps.
    pub fn rejections(&self) -> u64 {
        self.pace.rejections
    }
}

impl<S: PhaseSpace<R> + Rates<R>, M: Method<S, R>, R: Real> Pace for Controlled<S, M, R> {
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
        PerCoordinate::of(&self.x)
    }
    fn steps_backwards(&self) -> bool {
        self.size() < 0.0
    }
    fn is_fresh(&self) -> bool {
        self.taken == self.given
    }

    fn check_start(&self) -> Result<(), StepError> {
        self.check()
    }
    fn step(&mut self) -> Result<(), StepError> {
        self.check()?;
        self.take(f64::INFINITY)
    }
    fn step_towards(&mut self, t: R) -> Result<bool, StepError> {
        self.check()?;
        if self.now() == t {
            return Ok(false);
        }
        let left = self.clock.left(t);
        if left.is_nan() {
            return Err(StepError::of_step_size(signed(self.now()), left));
        }
        let backwards = left < 0.0;
        self.controller.turn(backwards);
        self.take(left.abs())?;
        loop {
            let rest = self.clock.left(t);
            if rest.is_finite() && rest.abs() <= R::epsilon() * (signed(t).abs() + self.size().abs()) {
                self.clock = Clock::new(t, zero());
                return Ok(true);
            }
            // Methods that scale their steps end near `t`, not at it. Before `t`, the next step leads there. Beyond `t`, a step back follows here.
            if (rest < 0.0) == backwards {
                return Ok(true);
            }
            self.controller.turn(!backwards);
            let outcome = self.take(rest.abs());
            self.controller.turn(backwards);
            outcome?;
        }
    }
    fn advance_to(&mut self, t: R, most_steps: u64) -> Result<(), StepError> {
        step_until(self, t, most_steps)
    }

    fn restart(&mut self, state: StateOf<S, R>) {
        self.restart_within(state);
        self.set = self.taken;
    }
    fn restart_within(&mut self, state: StateOf<S, R>) {
        let (t, z, s) = state.parts();
        self.continue_from(t, Point::with_action(z, s));
    }
    fn set_system(&mut self, system: S) {
        self.replace_system(system);
    }

    fn end_at(&mut self, t: R, most_steps: u64) -> Result<(), StepError> {
        step_until(self, t, most_steps)
    }
    fn before(&self) -> Option<Self> {
        let Past { clock, x } = self.past?;
        let mut run = self.clone();
        (run.clock, run.x, run.past) = (clock, x, None);
        run.memory = no_history::<S, M, R>(&run.x.z);
        run.taken -= 1;
        Some(run)
    }

    #[cfg(feature = "alloc")]
    fn name(&self) -> Name {
        self.method.name()
    }
    #[cfg(feature = "alloc")]
    fn record(&mut self, tape: &mut impl Tape<R>) {
        self.clock.record(tape);
        tape.steps(&mut self.taken);
        tape.steps(&mut self.given);
        tape.steps(&mut self.rejections);
        if M::HANDLING.keeps_invariants {
            tape.array(&mut self.origin);
        }
        self.x.record(tape);
        self.tolerance.record(tape);
        self.controller.record(tape);
        tape.number(&mut self.prepared.h);
        self.informative_steps.record(tape);
        self.memory.record(tape);
    }
    #[cfg(feature = "alloc")]
    fn complete(&mut self) -> bool {
        self.past = None;
        self.prepared = attempt::Prepared::new(&self.system, &self.method, self.prepared.h);
        // The state may come from elsewhere: if it is outside the domain, the next step must check it like a given state.
        if self.system.outside_domain(self.now(), &self.x.z, &self.x.s).is_some() {
            self.given = self.taken;
        }
        self.x.is_finite() && self.now().magnitude() < f64::INFINITY
    }
}

impl<S: PhaseSpace<R> + Rates<R>, M: Method<S, R>, R: Real> PartialSteps for Controlled<S, M, R> {
    fn order(&self) -> u32 {
        self.method.claims().order
    }
}

impl<S: PhaseSpace<R> + Debug, M: Method<S, R> + Debug, R: Real> Debug for Controlled<S, M, R> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Controlled { system, method, clock, x, taken, rejections, .. } = self;
        let mut run = f.debug_struct("Adaptive");
        run.field("system", system).field("method", method).field("clock", clock).field("x", x);
        run.field("steps", taken).field("rejections", rejections).finish_non_exhaustive()
    }
}

//! Integration with a fixed step size.

#[cfg(feature = "alloc")]
mod saved;
mod steps;

use crate::method::{Clock, Method};
use crate::running::error::StepError;
use crate::running::reported::Reported;
use crate::running::trajectory::{Samples, Trajectory, Until};
use crate::scalar::{Real, signed, zero};
use crate::space::Coordinates;
use crate::space::{Action, NEVER, Snapshot};
use crate::space::{Compensated, DoubleWord, Plain, Point, Summation, WithoutAction};
use crate::system::{Clear, Conformal, FirstIntegrals, Lagrangian, PhaseSpace, StateOf};
use core::fmt::{self, Debug, Formatter};
use steps::Steps;

/// Integrates a system with a method and a fixed step size. The value borrows nothing and allocates nothing.
///
/// The time is `t0 + n·h`, never a running sum. After an error, the last good state is still available. The next call may continue, for example with
/// a smaller step set by [`Integrator::set_step_size`].
#[doc(alias("simulation", "fixed step"))]
#[derive(Clone)]
pub struct Integrator<S: PhaseSpace<R>, M: Method<S, R>, R: Real = f64, C = Plain> {
    steps: Steps<S, M, R, C>,
    pub(in crate::running) reported: Reported<R>,
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real> Integrator<S, M, R> {
    /// Integrates a system with step size `h`, from `state` on. A negative `h` goes back in time.
    ///
    /// Nothing is checked yet: the first step reports an unusable `h` or state.
    pub fn new(system: S, method: M, h: R, state: StateOf<S, R>) -> Self {
        let (t0, z, s) = state.parts();
        Integrator {
            steps: Steps {
                system,
                method,
                prepared: method.prepare(&system, h),
                memory: M::memory(),
                clock: Clock::new(t0, h),
                taken: 0,
                given: 0,
                set: 0,
                origin: z,
                x: Point::with_action(z, s),
                inside: false,
                clear: Clear::unknown(),
            },
            reported: Reported::nothing(),
        }
    }
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> Integrator<S, M, R, C> {
    /// Takes one step.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then unchanged.
    #[inline]
    pub fn step(&mut self) -> Result<(), StepError> {
        self.steps.step()
    }

    /// Takes `n` steps. The result equals that of `n` single steps bit for bit. If the method allows it, the last flow of a step and the first flow
    /// of the next one are merged. Single steps merge them, too, if the method moves an inner point.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then the last good one.
    #[inline]
    pub fn advance(&mut self, n: u64) -> Result<(), StepError> {
        self.steps.advance(n)
    }

    /// Takes one step, unless it would end beyond the time `t` (before it, if h < 0). Otherwise returns `false` and changes nothing.
    ///
    /// If a step ends at `t` up to the rounding of time, [`time`](Integrator::time) is then exactly `t`.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then unchanged. A `t` that is not a number gives the error of an invalid step size.
    #[inline]
    pub fn step_towards(&mut self, t: R) -> Result<bool, StepError> {
        self.steps.check_start()?;
        let (now, next) = (self.time(), self.steps.clock.at(1));
        if t.magnitude().is_nan() {
            return Err(StepError::of_step_size(signed(now), signed(t - now)));
        }
        let stepped =
            (M::SCALES_STEPS || self.steps.clock.leads_to(t, [now, next])) && self.steps.step_within(Some(t))?;
        let end = if M::SCALES_STEPS { self.time() } else { next };
        if stepped && self.steps.clock.is_at(end, t) {
            self.steps.clock.name(t);
        }
        Ok(stepped)
    }

    /// Takes whole steps up to the last one that does not end beyond the time `t` (not before it, if h < 0). Less than a step is left.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then the last good one. A `t` that is not finite gives the error of an invalid step size.
    pub fn advance_to(&mut self, t: R) -> Result<(), StepError> {
        self.steps.check_start()?;
        let left = signed(t - self.time());
        if !left.is_finite() {
            return Err(StepError::of_step_size(signed(self.time()), left));
        }
        if !M::SCALES_STEPS {
            self.advance(self.steps.clock.steps_before(self.time(), t))?;
        }
        while self.step_towards(t)? {}
        Ok(())
    }

    /// Changes the step size. The time continues from the present value.
    pub fn set_step_size(&mut self, h: R) {
        self.steps.leave();
        let Steps { system, method, prepared, memory, clock, x, .. } = &mut self.steps;
        clock.set_step_size(h, x.ahead);
        x.ahead = DoubleWord::new(zero());
        *prepared = method.prepare(system, h);
        *memory = M::memory();
    }

    /// Replaces the system by one with other parameters. Time, state, settings and the number of steps remain.
    ///
    /// Example: a controller applies a torque for some time, and then another one:
    ///
    /// ```
    /// use geoint_runtime::prelude::*;
    ///
    /// #[hamiltonian(force = torque)]
    /// fn motor(q: f64, p: f64, m: f64, torque: f64) -> f64 {
    ///     p * p / (2.0 * m) - q.cos()
    /// }
    ///
    /// let mut sim = Motor { m: 2.0, torque: 0.0 }.integrator(DiscreteGradient, 0.01, State::new(2.0, 0.0));
    /// for k in 1..=100 {
    ///     let torque = -0.5 * sim.state().p;
    ///     sim.set_system(Motor { torque, ..*sim.system() });
    ///     sim.advance(10)?;
    /// }
    /// assert!(sim.energy() < -0.9);
    /// # Ok::<(), StepError>(())
    /// ```
    ///
    /// The next step checks the state again, except for the momenta of a system with constraints. They result from a step, and `DiscreteGradient`
    /// leaves them O(h²) off the constraints.
    pub fn set_system(&mut self, system: S) {
        self.steps.leave();
        let steps = &mut self.steps;
        steps.system = system;
        (steps.prepared, steps.memory) = (steps.method.prepare(&system, steps.clock.step_size()), M::memory());
        // Other parameters may have other domains, poles and values of invariants.
        (steps.given, steps.origin, steps.clear) = (steps.taken, steps.x.z, Clear::unknown());
    }

    /// Returns whether no step was taken since the state was set, by the user or at an event.
    pub(in crate::running) fn is_fresh(&self) -> bool {
        self.steps.taken == self.steps.set
    }

    /// Checks the state in the way of the next step.
    pub(in crate::running) fn check_start(&self) -> Result<(), StepError> {
        self.steps.check_start()
    }

    /// Continues from this state, with the same step size.
    pub(in crate::running) fn restart(&mut self, state: StateOf<S, R>) {
        let (t, z, s) = state.parts();
        let steps = &mut self.steps;
        // If the action is not computed, states contain NaN in its place.
        let s = if C::ACTION { s } else { steps.x.s };
        (steps.x, steps.inside, steps.memory) = (Point::with_action(z, s), false, M::memory());
        steps.clock = Clock::new(t, steps.clock.step_size());
        (steps.given, steps.set, steps.origin) = (steps.taken, steps.taken, z);
    }

    /// Continues from a state that results from a step of this run. The next step does not check it: its momenta may be off a constraint.
    pub(in crate::running) fn restart_within(&mut self, state: StateOf<S, R>) {
        self.restart(state);
        self.steps.given = NEVER;
    }

    /// Returns the step size.
    #[inline(always)]
    pub fn step_size(&self) -> R {
        self.steps.clock.step_size()
    }

    /// Returns the present time, `t0 + n·h`.
    #[inline(always)]
    pub fn time(&self) -> R {
        self.steps.time()
    }

    /// Returns the present state.
    #[inline(always)]
    pub fn state(&self) -> StateOf<S, R> {
        S::State::of(self.time(), self.steps.seen().z, self.action())
    }

    /// Returns the present energy.
    pub fn energy(&self) -> R {
        self.steps.system.hamiltonian(self.time(), &self.steps.seen().z, &self.action())
    }

    /// Returns the present first integrals: the named ones in their order, and then those that were found.
    pub fn integrals(&self) -> S::Values
    where
        S: FirstIntegrals<R>,
    {
        self.steps.system.integrals(self.time(), &self.steps.seen().z)
    }

    /// Returns the present velocities of a system that was written as a Lagrangian.
    pub fn velocity(&self) -> S::Coordinates
    where
        S: Lagrangian<R>,
    {
        let Steps { system, x, .. } = &self.steps;
        S::Coordinates::from_array(system.velocity(self.time(), &x.z, &self.action()))
    }

    /// Returns the present action; NaN if it is not computed.
    #[inline(always)]
    fn action(&self) -> S::Action {
        if C::ACTION { self.steps.x.s } else { S::Action::of(R::from_f64(f64::NAN)) }
    }

    /// Returns the number of steps taken.
    pub fn steps(&self) -> u64 {
        self.steps.taken
    }

    /// Returns the system with its parameters.
    pub fn system(&self) -> &S {
        &self.steps.system
    }

    /// Returns the method.
    pub fn method(&self) -> &M {
        &self.steps.method
    }

    /// Returns an iterator over the states after every step, up to the last one that is not after `t` (not before it, if h < 0).
    ///
    /// Output never changes the steps. The last state is at `t` only if `t` is a whole number of steps away, up to the rounding of time. An infinite
    /// `t` is never reached.
    pub fn until(&mut self, t: R) -> Until<'_, Self> {
        Until::new(self, t)
    }

    /// Returns an endless iterator over the states after every `k` steps. `k` = 0 counts as 1.
    pub fn sampled(&mut self, k: u64) -> Samples<'_, Self> {
        Samples::new(self, k)
    }

    fn with_sums<D: Summation<S::Phase>>(self) -> Integrator<S, M, R, D> {
        let Steps { system, method, prepared, memory, clock, taken, given, set, origin, x, inside, clear } = self.steps;
        let x = x.with_sums();
        Integrator {
            steps: Steps { system, method, prepared, memory, clock, taken, given, set, origin, x, inside, clear },
            reported: self.reported,
        }
    }
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real> Integrator<S, M, R> {
    /// Uses compensated sums: the rounding error of adding an increment to a coordinate is carried to the next step. Rounding errors then grow much
    /// more slowly with the number of steps. A step costs a few more additions for each coordinate.
    ///
    /// Some flows of contact systems do more than add. They compute their increments by separate formulas.
    #[must_use = "the settings are those of the run that is returned"]
    pub fn compensated(self) -> Integrator<S, M, R, Compensated<S::Phase>> {
        self.with_sums()
    }
}

impl<S: Conformal<R>, M: Method<S, R>, R: Real> Integrator<S, M, R> {
    /// Omits the action, which does not affect positions and momenta. Splittings then skip it, and all values that only it needs, such as the
    /// potential. States contain NaN in its place.
    pub fn without_action(self) -> Integrator<S, M, R, WithoutAction> {
        self.with_sums()
    }
}

impl<S: PhaseSpace<R> + Debug, M: Method<S, R> + Debug, R: Real, C: Summation<S::Phase> + Debug> Debug
    for Integrator<S, M, R, C>
{
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Steps { system, method, clock, taken, .. } = &self.steps;
        let mut run = f.debug_struct("Integrator");
        run.field("system", system).field("method", method).field("clock", clock);
        run.field("x", &self.steps.seen()).field("steps", taken).finish_non_exhaustive()
    }
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> Trajectory for Integrator<S, M, R, C> {
    type State = StateOf<S, R>;

    #[inline]
    fn step(&mut self) -> Result<(), StepError> {
        self.step()
    }
    #[inline]
    fn advance(&mut self, n: u64) -> Result<(), StepError> {
        self.advance(n)
    }
    #[inline]
    fn step_towards(&mut self, t: R) -> Result<bool, StepError> {
        self.step_towards(t)
    }
    fn advance_to(&mut self, t: R) -> Result<(), StepError> {
        self.advance_to(t)
    }
    #[inline]
    fn time(&self) -> R {
        self.time()
    }
    #[inline(always)]
    fn state(&self) -> StateOf<S, R> {
        self.state()
    }
    fn energy(&self) -> R {
        self.energy()
    }
    fn steps(&self) -> u64 {
        self.steps()
    }
}

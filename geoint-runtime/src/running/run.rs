//! Runs: one interface for steps of fixed length, adaptive steps, and steps by Taylor series.

use super::error::StepError;
use super::pace::Pace;
use super::reported::Reported;
use super::trajectory::{Samples, Trajectory, Until};
use crate::space::{Coordinates, PerCoordinate};
use crate::system::{FirstIntegrals, Lagrangian, PhaseSpace, StateOf};
use core::fmt::{self, Debug, Formatter};

/// A run: a system, its present state, and a pace that chooses and takes the steps. The value borrows nothing and allocates nothing.
///
/// Its aliases are [`Integrator`](crate::Integrator) with steps of a fixed length, [`Adaptive`](crate::Adaptive) with steps that adapt to a tolerance, and
/// [`TaylorIntegrator`](crate::TaylorIntegrator) with steps by Taylor series.
///
/// After an error, the last good state is still available. The next call may continue, for example with a smaller step.
#[doc(alias("simulation", "orbit"))]
#[derive(Clone)]
pub struct Run<P: Pace> {
    pub(in crate::running) pace: P,
    /// The functions that had an event when `until_event` last found one.
    pub(in crate::running) reported: Reported<P::Real>,
    /// Maximum number of steps in one `advance_to` or `end_at`. Fixed steps ignore it.
    pub(in crate::running) most_steps: u64,
}

impl<P: Pace> Run<P> {
    /// Returns a run without reported events and without a limit of steps.
    pub(in crate::running) fn of(pace: P) -> Self {
        Run { pace, reported: Reported::nothing(), most_steps: u64::MAX }
    }

    /// Takes one step. The length of an adaptive step follows from the tolerance. A run by Taylor series steps forwards, or in the direction of its last step.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then unchanged.
    #[inline]
    pub fn step(&mut self) -> Result<(), StepError> {
        self.pace.step()
    }

    /// Takes `n` steps. The result equals that of `n` single steps bit for bit. If the method allows it, the last flow of a step and the first flow
    /// of the next one are merged. Single steps merge them, too, if the method moves an inner point.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then the last good one.
    #[inline]
    pub fn advance(&mut self, n: u64) -> Result<(), StepError> {
        self.pace.advance(n)
    }

    /// Takes one step towards the time `t`, which may lie before or after the present time. Returns `false` if no step is left.
    ///
    /// A run with fixed steps changes nothing and returns `false` if the step would end beyond `t` (before it, if h < 0). If its step ends at `t` up to the
    /// rounding of time, [`time`](Run::time) is then exactly `t`. Other runs end at `t`.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then unchanged. A `t` that is not a number gives the error of an invalid step size.
    #[inline]
    pub fn step_towards(&mut self, t: P::Real) -> Result<bool, StepError> {
        self.pace.step_towards(t)
    }

    /// Takes all steps towards the time `t`. A run with fixed steps takes whole steps up to the last one that does not end beyond `t` (not before it, if
    /// h < 0); less than a step is left. The last step of other runs ends at `t`.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then the last good one. A `t` that is not finite gives the error of an invalid step size.
    pub fn advance_to(&mut self, t: P::Real) -> Result<(), StepError> {
        self.pace.advance_to(t, self.most_steps)
    }

    /// Returns an iterator over the states after every step towards the time `t`, which may be infinite.
    ///
    /// Output never changes the steps. The last state of a run with fixed steps is at `t` only if `t` is a whole number of steps away, up to the rounding of
    /// time.
    pub fn until(&mut self, t: P::Real) -> Until<'_, Self> {
        Until::new(self, t)
    }

    /// Returns an endless iterator over the states after every `k` steps. `k` = 0 counts as 1.
    pub fn sampled(&mut self, k: u64) -> Samples<'_, Self> {
        Samples::new(self, k)
    }

    /// Replaces the system by one with other parameters. Time, state, settings and the number of steps remain. An adaptive run estimates its next step anew.
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
    /// leaves them O(h²) off the constraints if T is not quadratic in p. If the new parameters change a constraint, first set a state that obeys it:
    /// `system.state_on_constraint(&state)`.
    pub fn set_system(&mut self, system: P::System) {
        self.pace.set_system(system);
    }

    /// Returns the present time. With fixed steps it is `t0 + n·h`, never a running sum.
    #[inline(always)]
    pub fn time(&self) -> P::Real {
        self.pace.time()
    }

    /// Returns the present state.
    #[inline(always)]
    pub fn state(&self) -> StateOf<P::System, P::Real> {
        self.pace.state()
    }

    /// Returns the present energy.
    pub fn energy(&self) -> P::Real {
        let PerCoordinate { z, s } = self.pace.point();
        self.system().hamiltonian(self.time(), &z, &s)
    }

    /// Returns the present first integrals: the named ones in their order, and then those that the attribute found.
    pub fn integrals(&self) -> <P::System as FirstIntegrals<P::Real>>::Values
    where
        P::System: FirstIntegrals<P::Real>,
    {
        self.system().integrals(self.time(), &self.pace.point().z)
    }

    /// Returns the present velocities of a system that was written as a Lagrangian.
    pub fn velocity(&self) -> <P::System as crate::Cotangent<P::Real>>::Coordinates
    where
        P::System: Lagrangian<P::Real>,
    {
        let PerCoordinate { z, s } = self.pace.point();
        Coordinates::from_array(self.system().velocity(self.time(), &z, &s))
    }

    /// Returns the number of steps taken. Two halves of an adaptive step count as one.
    pub fn steps(&self) -> u64 {
        self.pace.taken()
    }

    /// Returns the system with its parameters.
    pub fn system(&self) -> &P::System {
        self.pace.system()
    }

    /// Returns the method.
    pub fn method(&self) -> &P::Method {
        self.pace.method()
    }
}

impl<P: Pace + Debug> Debug for Run<P> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.pace.fmt(f)
    }
}

impl<P: Pace> Trajectory for Run<P> {
    type State = StateOf<P::System, P::Real>;

    #[inline]
    fn step(&mut self) -> Result<(), StepError> {
        self.step()
    }
    #[inline]
    fn advance(&mut self, n: u64) -> Result<(), StepError> {
        self.advance(n)
    }
    #[inline]
    fn step_towards(&mut self, t: P::Real) -> Result<bool, StepError> {
        self.step_towards(t)
    }
    fn advance_to(&mut self, t: P::Real) -> Result<(), StepError> {
        self.advance_to(t)
    }
    #[inline]
    fn time(&self) -> P::Real {
        self.time()
    }
    #[inline(always)]
    fn state(&self) -> Self::State {
        self.state()
    }
    fn energy(&self) -> P::Real {
        self.energy()
    }
    fn steps(&self) -> u64 {
        self.steps()
    }
}

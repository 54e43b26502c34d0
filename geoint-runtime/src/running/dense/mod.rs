//! Dense output: states between the ends of steps, and events. Output never changes the steps of a run.

mod crossing;
mod crossings;
mod interpolated;
mod noise;
mod quiet;
mod roots;
mod samples;
mod states;
mod taylor;

pub use crossing::{Crossing, Direction};
pub use crossings::Crossings;
pub use samples::{SampledAt, SampledEvery};
pub use states::StateFunctions;
pub use taylor::{SeriesFunctions, TaylorCrossings};

use super::StepError;
use super::pace::Pace;
use super::reported::Reported;
use super::run::Run;
use super::trajectory::{Scalar, Trajectory};
use crate::scalar::{Real, signed};
use crate::solving::Failure;
use crate::space::Array;

/// A run with dense output: it has states between the ends of its steps.
///
/// Runs by Taylor series evaluate the polynomial of a step. All other runs take a shorter step from the start of the step. Its result has the order
/// of the method, and a symplectic method remains symplectic. The run itself continues with whole steps.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// #[hamiltonian]
/// fn oscillator(q: f64, p: f64) -> f64 {
///     p * p / 2.0 + q * q / 2.0
/// }
///
/// let mut sim = Oscillator.integrator(BlanesMoan4, 0.1, State::new(1.0, 0.0));
/// for state in sim.sampled_every(0.25).take(5) {
///     let state = state?;
///     assert!((state.q - state.t.cos()).abs() < 1e-6);
/// }
/// // q falls through 0 at π/2 + 2πn.
/// let mut sim = Oscillator.integrator(BlanesMoan4, 0.1, State::new(1.0, 0.0));
/// let times: Result<Vec<f64>, StepError> =
///     sim.crossings(Direction::Down, |state| state.q).take(3).map(|crossing| Ok(crossing?.state.t)).collect();
/// for (n, t) in times?.into_iter().enumerate() {
///     assert!((t - std::f64::consts::PI * (0.5 + 2.0 * n as f64)).abs() < 1e-4);
/// }
/// # Ok::<(), StepError>(())
/// ```
#[doc(alias("dense output", "interpolation"))]
pub trait Dense: Trajectory + Clone {
    /// Continues from this state, for example after an impact or a kick. All settings remain.
    fn set_state(&mut self, state: Self::State);

    /// Continues from a state of this run, at an event.
    #[doc(hidden)]
    fn go_on_from(&mut self, state: Self::State);

    /// Returns whether no step was taken since the state was set, by the user or at an event.
    #[doc(hidden)]
    fn is_fresh(&self) -> bool;

    /// Returns the functions that had an event when [`until_event`](Dense::until_event) last found one.
    #[doc(hidden)]
    fn reported(&mut self) -> &mut Reported<Scalar<Self>>;

    /// Checks the state in the way of the next step.
    #[doc(hidden)]
    fn check_start(&self) -> Result<(), StepError>;

    /// Takes one step that ends at the time `t`, or several if one is not possible.
    ///
    /// # Errors
    /// See [`StepError`].
    fn end_at(&mut self, t: Scalar<Self>) -> Result<(), StepError>;

    /// Returns the state at a time within the last step. The run does not change.
    ///
    /// # Errors
    /// Other times are the error [`Failure::NotInLastStep`], which names the interval that is known. It is the present time alone before the first step,
    /// after the state, the system or the step size was set, after a shorter last step of a run with fixed steps, after a refused step of a Taylor series, and in
    /// a resumed run. A partial step may be refused, too; see [`StepError`].
    ///
    /// Fixed steps that were taken in one call may have to be repeated, up to 1023 of them in each call of this function.
    fn at(&self, t: Scalar<Self>) -> Result<Self::State, StepError>;

    /// Returns whether the next step goes back in time.
    fn steps_backwards(&self) -> bool;

    /// Returns the state at a time in the step from `before` to `after`.
    ///
    /// # Errors
    /// See [`StepError`].
    fn between(before: &Self, after: &Self, t: Scalar<Self>) -> Result<Self::State, StepError>;

    /// Returns an endless iterator over the states at the present time, and after `dt`, 2 `dt`, …. Goes back in time if `dt` < 0.
    fn sampled_every(&mut self, dt: Scalar<Self>) -> SampledEvery<'_, Self> {
        SampledEvery::new(self, dt)
    }

    /// Returns an iterator over the states at these times, which must follow each other in the direction of the run.
    ///
    /// A time before the last step is an error: [`Failure::TimePassed`](crate::Failure::TimePassed).
    fn sampled_at<I: IntoIterator<Item = Scalar<Self>>>(&mut self, times: I) -> SampledAt<'_, Self, I::IntoIter> {
        SampledAt::new(self, times.into_iter())
    }

    /// Returns an iterator over the changes of sign of `g`, in order of time. `g` returns a number or an array of numbers. The iterator has no end,
    /// unless [`Crossings::until`] sets one. The search goes forwards, or in the direction in which an integrator steps.
    ///
    /// If the signs at the ends of a step differ, the search finds one zero. If the signs agree, the search finds two zeros where the parabola
    /// through three values comes near zero between the ends. Other pairs of zeros within one step are missed. Example: the zeros of `sin(40 q)` are
    /// π/40 apart in q, and steps that change q by less find all of them. Interpolation of samples does not help. Runs by Taylor series have
    /// [`crossings`](crate::TaylorIntegrator::crossings), which find all zeros of the series of the function.
    ///
    /// A search that starts at the event of an earlier search does not find this event again. A function that is zero where the search ends has an
    /// event there. A function that returns to zero within a millionth of a step has no event. Hence a ball whose impacts accumulate finally falls
    /// through the floor, unless your program stops it. Poles are not events.
    ///
    /// Errors: a function is not a finite number at the end of a step, or is zero for more than a step.
    fn crossings<G: Array<Real = Scalar<Self>>, F: Fn(&Self::State) -> G>(
        &mut self,
        direction: Direction,
        g: F,
    ) -> Crossings<StateFunctions<'_, Self, F, G>> {
        Crossings::new(StateFunctions::new(self, g), direction)
    }

    /// Steps to the first change of sign of `g`, but not beyond the time `t`. The run is then at the event and continues from there.
    ///
    /// Returns `None` if there is no such change; the run is then at `t`. The last step is shorter if `t` is not a whole number of steps away. A game
    /// calls this function once for each frame.
    ///
    /// Simultaneous events of several functions are reported one by one. This includes a function that crosses zero only after
    /// [`set_state`](Dense::set_state) has changed its direction, as for bodies in contact that pass an impulse on. It holds for the first 64
    /// functions.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then the last good one. If `g` has no events ([`Failure::NoEvent`](crate::Failure::NoEvent)), the state is the one
    /// at the start of the search.
    fn until_event<G: Array<Real = Scalar<Self>>, F: Fn(&Self::State) -> G>(
        &mut self,
        t: Scalar<Self>,
        direction: Direction,
        g: F,
    ) -> Result<Option<Crossing<Self::State>>, StepError> {
        let start = self.clone();
        if t.magnitude().is_finite() && quiet::skip_quiet_steps(self, t, &g)? {
            return Ok(None);
        }
        self.crossings(direction, g).until(t).go_to_first(start)
    }
}

impl<P: Pace> Dense for Run<P> {
    fn set_state(&mut self, state: Self::State) {
        self.pace.restart(state);
    }

    fn go_on_from(&mut self, state: Self::State) {
        self.pace.restart_within(state);
    }

    fn is_fresh(&self) -> bool {
        self.pace.is_fresh()
    }

    fn reported(&mut self) -> &mut Reported<P::Real> {
        &mut self.reported
    }

    fn check_start(&self) -> Result<(), StepError> {
        self.pace.check_start()
    }

    fn end_at(&mut self, t: P::Real) -> Result<(), StepError> {
        self.pace.end_at(t, self.most_steps)
    }

    fn at(&self, t: P::Real) -> Result<Self::State, StepError> {
        let now = self.time();
        if t == now {
            return Ok(self.state());
        }
        let before = self.pace.before();
        let from = before.as_ref().map_or(now, Pace::time);
        let is_within = || {
            let backwards = (from - now).any_above(0.0);
            t.magnitude().is_finite() && has_reached(t, from, backwards) && has_reached(now, t, backwards)
        };
        match before {
            Some(before) if t == from => Ok(before.state()),
            Some(before) if is_within() => P::between(&before, &self.pace, t),
            _ => {
                Err(StepError::without_step(Failure::NotInLastStep { from: signed(from), to: signed(now) }, signed(t)))
            }
        }
    }

    fn steps_backwards(&self) -> bool {
        self.pace.steps_backwards()
    }

    fn between(before: &Self, after: &Self, t: P::Real) -> Result<Self::State, StepError> {
        P::between(&before.pace, &after.pace, t)
    }
}

/// Returns whether a run at the time `now` has reached `t`.
fn has_reached<R: Real>(now: R, t: R, backwards: bool) -> bool {
    if backwards { !(now - t).any_above(0.0) } else { !(now - t).any_below(0.0) }
}

/// Takes one step without a limit of time.
fn step<T: Dense>(run: &mut T, backwards: bool) -> Result<bool, StepError> {
    run.step_towards(Scalar::<T>::from_f64(if backwards { f64::NEG_INFINITY } else { f64::INFINITY }))
}

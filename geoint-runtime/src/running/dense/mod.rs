//! States between the ends of steps, and what happens there. Output never changes the steps of a run.

mod crossing;
mod crossings;
mod interpolated;
mod quiet;
mod roots;
mod samples;
mod taylor;

pub use crossing::{Crossing, Direction};
pub use crossings::Crossings;
pub use interpolated::{Curve, Exactly, Hermite, Interpolated, Within};
pub use samples::{SampledAt, SampledEvery};
pub use taylor::TaylorCrossings;

use super::reported::Reported;
use super::trajectory::{Scalar, Trajectory};
use super::{Adaptive, Integrator, StepError};
use crate::method::Method;
use crate::scalar::{Real, signed};
use crate::space::{Array, Summation};
use crate::system::{PhaseSpace, Rates, StateOf};

/// A run that knows its states between the ends of its steps.
///
/// Runs by Taylor series evaluate the polynomial of a step. All others take a step of part of the length from where the step begins: the
/// state has the order of the method, and a symplectic map leads to it. The run itself goes on with whole steps.
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
    /// Goes on from this state, with all settings as they are: after an impact, or a kick.
    fn set_state(&mut self, state: Self::State);

    /// The same from a state of its own: an event.
    #[doc(hidden)]
    fn go_on_from(&mut self, state: Self::State) {
        self.set_state(state);
    }

    /// Returns whether no step was taken since the state was set, by the user or at an event.
    #[doc(hidden)]
    fn is_fresh(&self) -> bool {
        false
    }

    /// The functions that had an event at the last time at which [`until_event`](Dense::until_event) found one.
    #[doc(hidden)]
    fn reported(&mut self) -> &mut Reported<Scalar<Self>>;

    /// What the next step says of the state before it does anything.
    #[doc(hidden)]
    fn check_start(&self) -> Result<(), StepError>;

    /// One step that ends at the time `t`, or more if it cannot be taken in one.
    ///
    /// # Errors
    /// See [`StepError`].
    fn end_at(&mut self, t: Scalar<Self>) -> Result<(), StepError>;

    /// The state at a time within the next step, the run left as it is; of runs by Taylor series within the last one. `None` elsewhere.
    fn at(&self, t: Scalar<Self>) -> Option<Self::State>;

    /// Whether the next step leads back in time.
    fn steps_backwards(&self) -> bool {
        false
    }

    /// The state at a time in the step that led from `before` to `after`.
    ///
    /// # Errors
    /// See [`StepError`].
    fn between(before: &Self, _after: &Self, t: Scalar<Self>) -> Result<Self::State, StepError> {
        let mut copy = before.clone();
        copy.end_at(t)?;
        Ok(copy.state())
    }

    /// The states at now, now + `dt`, now + 2 `dt`, …, without end; back in time if `dt` < 0.
    fn sampled_every(&mut self, dt: Scalar<Self>) -> SampledEvery<'_, Self> {
        SampledEvery::new(self, dt)
    }

    /// The states at these times, one after the other in the direction of the run.
    ///
    /// A time that lies before the last step is an error: [`StepError::TimePassed`].
    fn sampled_at<I: IntoIterator<Item = Scalar<Self>>>(&mut self, times: I) -> SampledAt<'_, Self, I::IntoIter> {
        SampledAt::new(self, times.into_iter())
    }

    /// Where `g` changes sign from one step to the next: a number, or an array of them, all in order of time. Without end, unless
    /// [`Crossings::until`] gives one. Forwards, or in the direction in which an integrator steps.
    ///
    /// If the signs at the ends of a step differ, the search finds one zero. If the signs agree, the search finds two zeros where the parabola through
    /// three values comes near zero between the ends. Other pairs of zeros within one step are missed. The zeros of `sin(40 q)` are π/40
    /// apart in q, and steps that change q by less find all of them. Interpolation of samples does not help. Runs by Taylor series have
    /// [`crossings`](crate::TaylorIntegrator::crossings), which find all zeros of the series of the function.
    ///
    /// A search that begins where another one has ended does not find that event again. A function that is zero where the search ends has an event
    /// there. A function that comes back to zero within a millionth of a step has no event: a ball whose impacts accumulate falls through in the end,
    /// unless you lay it down. Poles are no events.
    ///
    /// Errors: a function is not a finite number at the end of a step, or is zero for more than a step.
    fn crossings<G: Array<Real = Scalar<Self>>, F: Fn(&Self::State) -> G>(
        &mut self,
        direction: Direction,
        g: F,
    ) -> Crossings<'_, Self, F, G> {
        Crossings::new(self, direction, g)
    }

    /// Steps to where `g` changes sign first, but not beyond the time `t`: the run is then there, and goes on from there.
    ///
    /// `None` if that does not happen: the run is then at `t`. If `t` is no whole number of steps away, the last step is shorter. A game calls this once for
    /// each frame.
    ///
    /// Events of several functions at one time are reported one by one, also if a function crosses zero there only after
    /// [`set_state`](Dense::set_state) has changed its direction: bodies that touch pass a push on. This holds for the first 64 functions.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then the last good one, and where `g` is no function with events, that at which the search began.
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
        let found = Crossings::new(self, direction, g).until(t).first();
        let found = back_without_events(self, start, found)?;
        if let Some(found) = found {
            self.go_on_from(found.state);
            let t = self.time();
            self.reported().add(t, found.which);
        }
        Ok(found)
    }
}

/// What a search for an event has found. One whose function has none, as one that is zero all along, has led nowhere: the run is where it began.
pub(super) fn back_without_events<T, X>(run: &mut T, start: T, found: Result<X, StepError>) -> Result<X, StepError> {
    if let Err(StepError::NoEvent { .. }) = found {
        *run = start;
    }
    found
}

impl<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>> Dense for Integrator<S, M, R, C> {
    fn set_state(&mut self, state: StateOf<S, R>) {
        self.restart(state);
    }

    fn is_fresh(&self) -> bool {
        self.is_fresh()
    }

    fn reported(&mut self) -> &mut Reported<R> {
        &mut self.reported
    }

    fn check_start(&self) -> Result<(), StepError> {
        self.check_start()
    }

    fn go_on_from(&mut self, state: StateOf<S, R>) {
        self.restart_within(state);
    }

    fn at(&self, t: R) -> Option<StateOf<S, R>> {
        let (after, h) = (signed(t - self.time()), signed(self.step_size()));
        if M::ROUGH_IF_SHORT && after != 0.0 && after * h.signum() > 0.0 && after.abs() < 0.5 * h.abs() {
            let mut end = self.clone();
            return end.step().and_then(|()| Self::between(self, &end, t)).ok();
        }
        ahead(self, t, after * h.signum(), h.abs())
    }

    fn between(before: &Self, after: &Self, t: R) -> Result<StateOf<S, R>, StepError> {
        let nearer = signed(t - before.time()).abs() < signed(t - after.time()).abs();
        let mut copy = if M::ROUGH_IF_SHORT && nearer { after.clone() } else { before.clone() };
        shorten_to(&mut copy, t)?;
        Ok(copy.state())
    }

    fn steps_backwards(&self) -> bool {
        self.step_size().any_below(0.0)
    }

    fn end_at(&mut self, t: R) -> Result<(), StepError> {
        let h = self.step_size();
        let outcome = shorten_to(self, t);
        // After an error, too.
        self.set_step_size(h);
        outcome
    }
}

/// Takes a step of the length that leads to the time `t`. The run keeps this length, so that a copy prepares the method once only.
fn shorten_to<S: PhaseSpace<R>, M: Method<S, R>, R: Real, C: Summation<S::Phase>>(
    run: &mut Integrator<S, M, R, C>,
    t: R,
) -> Result<(), StepError> {
    // Methods that scale their steps end a little beside `t`. The next step leads from there to `t`.
    for _ in 0..4 {
        if run.time() == t {
            break;
        }
        run.set_step_size(t - run.time());
        if !run.step_towards(t)? {
            run.step()?;
        }
    }
    Ok(())
}

impl<S: PhaseSpace<R> + Rates<R>, M: Method<S, R>, R: Real> Dense for Adaptive<S, M, R> {
    fn set_state(&mut self, state: StateOf<S, R>) {
        self.restart(state);
    }

    fn is_fresh(&self) -> bool {
        self.is_fresh()
    }

    fn reported(&mut self) -> &mut Reported<R> {
        &mut self.reported
    }

    fn check_start(&self) -> Result<(), StepError> {
        self.check_start()
    }

    fn at(&self, t: R) -> Option<StateOf<S, R>> {
        let (after, h) = (signed(t - self.time()), self.step_size());
        ahead(self, t, after * h.signum(), h.abs())
    }

    fn steps_backwards(&self) -> bool {
        self.step_size() < 0.0
    }

    fn end_at(&mut self, t: R) -> Result<(), StepError> {
        self.advance_to(t)
    }
}

/// Returns the state at the time `t`, which is `after` from now, if it lies within a step of length `h`.
fn ahead<T: Dense>(run: &T, t: Scalar<T>, after: f64, h: f64) -> Option<T::State> {
    if after == 0.0 {
        return Some(run.state());
    }
    if after > 0.0 && after <= h { T::between(run, run, t).ok() } else { None }
}

/// Whether a run at the time `now` has come to `t`.
fn has_reached<R: Real>(now: R, t: R, backwards: bool) -> bool {
    if backwards { !(now - t).any_above(0.0) } else { !(now - t).any_below(0.0) }
}

/// A step without an end.
fn step<T: Dense>(run: &mut T, backwards: bool) -> Result<bool, StepError> {
    run.step_towards(Scalar::<T>::from_f64(if backwards { f64::NEG_INFINITY } else { f64::INFINITY }))
}

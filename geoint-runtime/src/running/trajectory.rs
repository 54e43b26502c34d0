//! What every run offers, whatever its system and method: steps, time, the state.

use super::StepError;
use super::output::{Samples, StatesAt, Until};
use crate::scalar::signed;
use crate::space::Snapshot;

/// A run: steps from a state on. `dyn Trajectory<State = State<f64>>` is a run whose method is chosen while the program runs.
///
/// Runs with fixed steps and runs whose steps adapt differ in where they can end. [`Integrator`](crate::Integrator) takes whole
/// steps: on the way to a time t it ends with the last step that is not beyond. [`Adaptive`](crate::Adaptive) ends at t.
///
/// ```
/// use geoint_runtime::prelude::*;
///
/// #[hamiltonian]
/// fn oscillator(q: f64, p: f64) -> f64 {
///     p * p / 2.0 + q * q / 2.0
/// }
///
/// let start = State::new(1.0, 0.0);
/// let runs: [Box<dyn Trajectory<State = State<f64>>>; 2] =
///     [Box::new(Oscillator.integrator(StormerVerlet, 0.1, start)), Box::new(Oscillator.adaptive(DOP853, 1e-9, start))];
/// for mut run in runs {
///     run.advance_to(3.0)?;
///     assert!((run.time() - 3.0).abs() < 1e-12 && (run.state().q - 3.0_f64.cos()).abs() < 1e-3);
/// }
/// # Ok::<(), StepError>(())
/// ```
#[doc(alias("orbit", "solution"))]
pub trait Trajectory {
    /// Points along the way: [`State`](crate::State) or [`ContactState`](crate::ContactState).
    type State: Snapshot;

    /// One step.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then unchanged.
    fn step(&mut self) -> Result<(), StepError>;

    /// `n` steps.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then the last good one.
    fn advance(&mut self, n: u64) -> Result<(), StepError>;

    /// One step on the way to the time `t`; `false` if none is left to take.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then unchanged. A `t` that is not a number is a step size that is none.
    fn step_towards(&mut self, t: Scalar<Self>) -> Result<bool, StepError>;

    /// All steps on the way to the time `t`.
    ///
    /// # Errors
    /// See [`StepError`]; the state is then the last good one. A `t` that is not finite is a step size that is none.
    fn advance_to(&mut self, t: Scalar<Self>) -> Result<(), StepError>;

    /// Time now.
    fn time(&self) -> Scalar<Self>;

    /// The state now.
    fn state(&self) -> Self::State;

    /// The energy now.
    fn energy(&self) -> Scalar<Self>;

    /// The number of steps taken.
    fn steps(&self) -> u64;

    /// The state after every step on the way to the time `t`, which may be infinite.
    fn until(&mut self, t: Scalar<Self>) -> Until<'_, Self>
    where
        Self: Sized,
    {
        Until::new(self, t)
    }

    /// The state after every `k` steps, without end. `k` = 0 counts as 1.
    fn sampled(&mut self, k: u64) -> Samples<'_, Self>
    where
        Self: Sized,
    {
        Samples::new(self, k)
    }

    /// The state at each of these times, one after the other, where [`advance_to`](Trajectory::advance_to) ends: with fixed steps
    /// that is up to a step before.
    fn states_at<I: IntoIterator<Item = Scalar<Self>>>(&mut self, times: I) -> StatesAt<'_, Self, I::IntoIter>
    where
        Self: Sized,
    {
        StatesAt::new(self, times.into_iter())
    }
}

/// The scalar of a run.
pub type Scalar<T> = <<T as Trajectory>::State as Snapshot>::Real;

/// A run behind a pointer is a run.
macro_rules! behind {
    ($($(#[$only:meta])* $pointer:ty;)*) => { $(
        $(#[$only])*
        impl<T: Trajectory + ?Sized> Trajectory for $pointer {
            type State = T::State;
            fn step(&mut self) -> Result<(), StepError> {
                (**self).step()
            }
            fn advance(&mut self, n: u64) -> Result<(), StepError> {
                (**self).advance(n)
            }
            fn step_towards(&mut self, t: Scalar<T>) -> Result<bool, StepError> {
                (**self).step_towards(t)
            }
            fn advance_to(&mut self, t: Scalar<T>) -> Result<(), StepError> {
                (**self).advance_to(t)
            }
            fn time(&self) -> Scalar<T> {
                (**self).time()
            }
            fn state(&self) -> T::State {
                (**self).state()
            }
            fn energy(&self) -> Scalar<T> {
                (**self).energy()
            }
            fn steps(&self) -> u64 {
                (**self).steps()
            }
        }
    )* };
}

behind! {
    &mut T;
    #[cfg(feature = "alloc")] alloc::boxed::Box<T>;
}

/// All steps of a run with adaptive steps on the way to the time `t`, at most so many; the last one ends there.
pub(super) fn adapt_to<T: Trajectory>(run: &mut T, t: Scalar<T>, most_steps: u64) -> Result<(), StepError> {
    let left = signed(t - run.time());
    if left.is_infinite() {
        return Err(StepError::InvalidStepSize { h: left });
    }
    let last = run.steps().saturating_add(most_steps);
    loop {
        if run.steps() >= last && run.time() != t {
            return Err(StepError::TooManySteps { t: signed(run.time()), steps: most_steps });
        }
        if !run.step_towards(t)? {
            return Ok(());
        }
    }
}

//! The common interface of all runs: steps, time, state.

use super::StepError;
use crate::space::Snapshot;

/// A run: steps from a given state. `dyn Trajectory<State = State<f64>>` is a run whose method is chosen at run time.
///
/// Runs differ in the times at which they can end. [`Integrator`](crate::Integrator) takes whole steps, so on the way to a time t it ends with the
/// last step that is not beyond t. [`Adaptive`](crate::Adaptive) ends at t.
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
    /// State type of the run: [`State`](crate::State) or [`ContactState`](crate::ContactState).
    type State: Snapshot;

    /// Takes one step.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then unchanged.
    fn step(&mut self) -> Result<(), StepError>;

    /// Takes `n` steps.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then the last good one.
    fn advance(&mut self, n: u64) -> Result<(), StepError>;

    /// Takes one step towards the time `t`. Returns `false` if no step is left.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then unchanged. A `t` that is not a number gives the error of an invalid step size.
    fn step_towards(&mut self, t: Scalar<Self>) -> Result<bool, StepError>;

    /// Takes all steps towards the time `t`.
    ///
    /// # Errors
    /// See [`StepError`]. The state is then the last good one. A `t` that is not finite gives the error of an invalid step size.
    fn advance_to(&mut self, t: Scalar<Self>) -> Result<(), StepError>;

    /// Returns the present time.
    fn time(&self) -> Scalar<Self>;

    /// Returns the present state.
    fn state(&self) -> Self::State;

    /// Returns the present energy.
    fn energy(&self) -> Scalar<Self>;

    /// Returns the number of steps taken.
    fn steps(&self) -> u64;

    /// Returns an iterator over the states after every step towards the time `t`, which may be infinite.
    fn until(&mut self, t: Scalar<Self>) -> Until<'_, Self>
    where
        Self: Sized,
    {
        Until::new(self, t)
    }

    /// Returns an endless iterator over the states after every `k` steps. `k` = 0 counts as 1.
    fn sampled(&mut self, k: u64) -> Samples<'_, Self>
    where
        Self: Sized,
    {
        Samples::new(self, k)
    }

    /// Returns an iterator over the states at these times, in this order. Each state is the one at which [`advance_to`](Trajectory::advance_to) ends.
    /// With fixed steps, it may be up to a step before the time.
    fn states_at<I: IntoIterator<Item = Scalar<Self>>>(&mut self, times: I) -> StatesAt<'_, Self, I::IntoIter>
    where
        Self: Sized,
    {
        StatesAt::new(self, times.into_iter())
    }
}

/// Iterator over the states after every step to a time. Ends there, or after the first error.
#[derive(Debug)]
pub struct Until<'a, T: Trajectory> {
    pub(super) run: &'a mut T,
    pub(super) t: Scalar<T>,
    pub(super) failed: bool,
}

impl<'a, T: Trajectory> Until<'a, T> {
    pub(super) fn new(run: &'a mut T, t: Scalar<T>) -> Self {
        Until { run, t, failed: false }
    }
}

/// Endless iterator over the states after a fixed number of steps each. Ends only after the first error.
#[derive(Debug)]
pub struct Samples<'a, T> {
    pub(super) run: &'a mut T,
    pub(super) stride: u64,
    pub(super) failed: bool,
}

impl<'a, T> Samples<'a, T> {
    pub(super) fn new(run: &'a mut T, stride: u64) -> Self {
        Samples { run, stride: stride.max(1), failed: false }
    }
}

/// Iterator over states at given times. Ends with the last time, or after the first error.
#[derive(Debug)]
pub struct StatesAt<'a, T, I> {
    pub(super) run: &'a mut T,
    pub(super) times: I,
    pub(super) failed: bool,
}

impl<'a, T, I> StatesAt<'a, T, I> {
    pub(super) fn new(run: &'a mut T, times: I) -> Self {
        StatesAt { run, times, failed: false }
    }
}

/// Scalar of a run.
pub type Scalar<T> = <<T as Trajectory>::State as Snapshot>::Real;

/// Implements the trait for a pointer to a run.
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

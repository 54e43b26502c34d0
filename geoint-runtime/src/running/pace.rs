//! The trait [`Pace`]: chooses and takes the steps of a run. [`Run`](super::Run) adds the public interface.

use super::error::StepError;
use crate::scalar::{Real, signed};
use crate::solving::Failure;
use crate::space::{PerCoordinate, Snapshot};
use crate::system::{PhaseSpace, StateOf};
#[cfg(feature = "alloc")]
use crate::{method::Name, space::Tape};

/// A system, its present state, and everything that determines the next step.
///
/// Implemented by [`Fixed`](super::Fixed), [`Controlled`](super::Controlled) and [`Series`](super::Series). Generic programs use the bound
/// [`Trajectory`](super::Trajectory), or [`Dense`](super::Dense) for states within steps and events.
pub trait Pace: Clone {
    /// The scalar.
    type Real: Real;
    /// The system.
    type System: PhaseSpace<Self::Real>;
    /// The method.
    type Method;

    /// Returns the system with its parameters.
    fn system(&self) -> &Self::System;
    /// Returns the method.
    fn method(&self) -> &Self::Method;
    /// Returns the number of steps taken.
    fn taken(&self) -> u64;
    /// Returns the present time.
    fn time(&self) -> Self::Real;
    /// Returns the point of the present state. An action that is not computed is NaN.
    fn point(&self) -> Coordinates<Self>;
    /// Returns whether the next step goes back in time.
    fn steps_backwards(&self) -> bool;
    /// Returns whether no step was taken since the state was set, by the user or at an event. Runs by Taylor series return `false`: their search for events does
    /// not use it.
    fn is_fresh(&self) -> bool;

    /// Checks settings and state before the next step.
    fn check_start(&self) -> Result<(), StepError>;
    /// Takes one step. After an error the state is unchanged.
    fn step(&mut self) -> Result<(), StepError>;
    /// Takes `n` steps. After an error the state is the last good one.
    fn advance(&mut self, n: u64) -> Result<(), StepError> {
        (0..n).try_for_each(|_| self.step())
    }
    /// Takes one step towards the time `t`, but not beyond it. Returns `false` if no step is left.
    fn step_towards(&mut self, t: Self::Real) -> Result<bool, StepError>;
    /// Takes all steps towards the time `t`. Fixed steps end with the last one that is not beyond `t`, other steps at `t`. The error is `TooManySteps` if `t` is
    /// not reached in `most_steps` steps, which fixed steps ignore.
    fn advance_to(&mut self, t: Self::Real, most_steps: u64) -> Result<(), StepError>;

    /// Continues from this state, which the user gives. All settings remain. An adaptive run estimates its next step anew, and keeps its direction.
    fn restart(&mut self, state: StateOf<Self::System, Self::Real>);
    /// Continues from a state that results from a step of this run, at an event. Unlike a given state, it needs no check.
    fn restart_within(&mut self, state: StateOf<Self::System, Self::Real>) {
        self.restart(state);
    }
    /// Replaces the system by one with other parameters. Time, state, settings and the number of steps remain.
    fn set_system(&mut self, system: Self::System);

    /// Takes one step that ends at the time `t`, or several if one is not possible. The limit is that of [`advance_to`](Self::advance_to).
    fn end_at(&mut self, t: Self::Real, most_steps: u64) -> Result<(), StepError>;
    /// Returns a copy at the start of the last step. Fixed steps may have to repeat up to 1023 steps for it. Returns `None` if no step was taken since the state, the system or the step size was set.
    fn before(&self) -> Option<Self>;
    /// Returns the state at a time in the step from `before` to `after`. By default, a copy of `before` takes a shorter step, or any
    /// number of them.
    fn between(before: &Self, _after: &Self, t: Self::Real) -> Result<StateOf<Self::System, Self::Real>, StepError> {
        let mut copy = before.clone();
        copy.end_at(t, u64::MAX)?;
        Ok(copy.state())
    }

    /// Returns the present state.
    #[inline(always)]
    fn state(&self) -> StateOf<Self::System, Self::Real> {
        let PerCoordinate { z, s } = self.point();
        StateOf::<Self::System, Self::Real>::of(self.time(), z, s)
    }

    /// Returns the name of the method in saved runs.
    #[cfg(feature = "alloc")]
    fn name(&self) -> Name;
    /// Passes all data that change from step to step to `tape`.
    #[cfg(feature = "alloc")]
    fn record(&mut self, tape: &mut impl Tape<Self::Real>);
    /// Recomputes all data that follow from the recorded ones. Returns whether the state and the time are finite.
    #[cfg(feature = "alloc")]
    fn complete(&mut self) -> bool;
}

/// A pace that computes states within a step by a shorter step of its method. Taylor series evaluate the polynomial of the step instead.
pub trait PartialSteps: Pace {
    /// Returns the order of the method.
    fn order(&self) -> u32;
}

/// The coordinates of the system of a pace.
pub(super) type Coordinates<P> = PerCoordinate<
    <<P as Pace>::System as PhaseSpace<<P as Pace>::Real>>::Phase,
    <<P as Pace>::System as PhaseSpace<<P as Pace>::Real>>::Action,
>;

/// Takes steps to the time `t`, at most `most_steps` of them, for paces that choose their lengths. The last step ends there.
pub(super) fn step_until<P: Pace>(pace: &mut P, t: P::Real, most_steps: u64) -> Result<(), StepError> {
    let left = signed(t - pace.time());
    if left.is_infinite() {
        return Err(StepError::of_step_size(signed(pace.time()), left));
    }
    let last = pace.taken().saturating_add(most_steps);
    loop {
        if pace.taken() >= last && pace.time() != t {
            return Err(StepError::without_step(Failure::TooManySteps { steps: most_steps }, signed(pace.time())));
        }
        if !pace.step_towards(t)? {
            return Ok(());
        }
    }
}

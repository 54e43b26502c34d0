//! Iterators over states along a trajectory, for every run. Output never changes the steps of a run with fixed steps.

use super::StepError;
use super::trajectory::{Scalar, Trajectory};

/// Iterator over the states after every step to a time. Ends there, or after the first error.
#[derive(Debug)]
pub struct Until<'a, T: Trajectory> {
    run: &'a mut T,
    t: Scalar<T>,
    failed: bool,
}

impl<'a, T: Trajectory> Until<'a, T> {
    pub(crate) fn new(run: &'a mut T, t: Scalar<T>) -> Self {
        Until { run, t, failed: false }
    }
}

impl<T: Trajectory> Iterator for Until<'_, T> {
    type Item = Result<T::State, StepError>;

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        if self.failed {
            return None;
        }
        match self.run.step_towards(self.t) {
            Ok(true) => Some(Ok(self.run.state())),
            Ok(false) => None,
            Err(error) => {
                self.failed = true;
                Some(Err(error))
            }
        }
    }
}

/// Endless iterator over the states after a fixed number of steps each. Ends only after the first error.
#[derive(Debug)]
pub struct Samples<'a, T> {
    run: &'a mut T,
    stride: u64,
    failed: bool,
}

impl<'a, T> Samples<'a, T> {
    pub(crate) fn new(run: &'a mut T, stride: u64) -> Self {
        Samples { run, stride: stride.max(1), failed: false }
    }
}

impl<T: Trajectory> Samples<'_, T> {
    /// Not inlined, so that only the code of a single step is in the loop of the caller.
    #[inline(never)]
    fn many(&mut self) -> Result<(), StepError> {
        self.run.advance(self.stride)
    }
}

impl<T: Trajectory> Iterator for Samples<'_, T> {
    type Item = Result<T::State, StepError>;

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        if self.failed {
            return None;
        }
        let outcome = if self.stride == 1 { self.run.step() } else { self.many() };
        match outcome {
            Ok(()) => Some(Ok(self.run.state())),
            Err(error) => {
                self.failed = true;
                Some(Err(error))
            }
        }
    }
}

/// Iterator over states at given times. Ends with the last time, or after the first error.
#[derive(Debug)]
pub struct StatesAt<'a, T, I> {
    run: &'a mut T,
    times: I,
    failed: bool,
}

impl<'a, T, I> StatesAt<'a, T, I> {
    pub(crate) fn new(run: &'a mut T, times: I) -> Self {
        StatesAt { run, times, failed: false }
    }
}

impl<T: Trajectory, I: Iterator<Item = Scalar<T>>> Iterator for StatesAt<'_, T, I> {
    type Item = Result<T::State, StepError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.failed {
            return None;
        }
        let outcome = self.run.advance_to(self.times.next()?);
        self.failed = outcome.is_err();
        Some(outcome.map(|()| self.run.state()))
    }
}

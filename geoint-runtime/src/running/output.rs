//! The iterators over states along a trajectory, for every run. Output never changes the steps of a run with fixed steps.

use super::StepError;
use super::trajectory::{Samples, Scalar, StatesAt, Trajectory, Until};

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

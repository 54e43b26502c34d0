//! Where a function of the state changes sign between the ends of steps.

use super::roots::illinois;
use super::{Dense, has_reached, step};
use crate::running::StepError;
use crate::running::trajectory::Scalar;
use crate::scalar::{Real, signed};
use crate::space::Array;

/// Which changes of sign count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From negative to positive, as time goes on in the run.
    Up,
    /// From positive to negative.
    Down,
    /// Both.
    Any,
}

impl Direction {
    /// Whether a change to this sign counts.
    pub(super) fn counts(self, to: f64) -> bool {
        match self {
            Direction::Up => to > 0.0,
            Direction::Down => to < 0.0,
            Direction::Any => true,
        }
    }
}

/// A change of sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<X> {
    /// Where and when: the function is zero there, to rounding.
    pub state: X,
    /// Which of several functions it is.
    pub which: usize,
    /// Whether the function rises.
    pub rises: bool,
}

/// So many points in a row at which a function is zero are no accident.
pub(super) const ZEROS: u32 = 1024;

/// A part of a step after which a function that starts with zero has its sign.
const LITTLE: f64 = 1.0 / 1024.0;

/// The crossings of a run, in order; ends after the first error, or at a time.
#[derive(Debug)]
pub struct Crossings<'a, T: Dense, F, G> {
    run: &'a mut T,
    before: T,
    g: F,
    direction: Direction,
    end: Option<Scalar<T>>,
    backwards: bool,
    /// Values at the start and at the end of the last step; at the start, of those that are zero, with the sign of before.
    values: Option<[G; 2]>,
    /// Signs before the last step; 0 where there was none yet.
    sides: G,
    zeros: u32,
    /// When the functions are zero in the last step, as a part of it; not a number where they are not, or have been given out.
    roots: G,
    done: bool,
}

impl<'a, T: Dense, F: Fn(&T::State) -> G, G: Array<Real = Scalar<T>>> Crossings<'a, T, F, G> {
    pub(super) fn new(run: &'a mut T, direction: Direction, g: F) -> Self {
        let (before, backwards) = (run.clone(), run.steps_backwards());
        let (sides, mut roots) = (G::zero(), G::zero());
        roots.as_mut_slice().fill(Scalar::<T>::from_f64(f64::NAN));
        let (end, values) = (None, None);
        Crossings { run, before, g, direction, end, backwards, values, sides, zeros: 0, roots, done: false }
    }

    /// The same up to a time, before or after now. Runs with fixed steps end up to a step before it.
    pub fn until(mut self, t: Scalar<T>) -> Self {
        self.backwards = (t - self.run.time()).any_below(0.0);
        self.end = Some(t);
        self
    }

    /// The values at the present, or the error that one of them is no number.
    fn values(&self) -> Result<G, StepError> {
        let values = (self.g)(&self.run.state());
        let t = signed(self.run.time());
        if values.as_slice().iter().any(|g| g.magnitude().is_nan()) {
            Err(StepError::NoEvent { t })
        } else {
            Ok(values)
        }
    }

    /// The next step, and which functions are zero in it; `false` if there is none.
    fn step(&mut self) -> Result<bool, StepError> {
        let before = match self.values {
            Some([_, now]) => now,
            None => self.values()?,
        };
        self.before = self.run.clone();
        let stepped = match self.end {
            Some(t) if has_reached(self.run.time(), t, self.backwards) => false,
            Some(t) => self.run.step_towards(t)?,
            None => step(self.run, self.backwards)?,
        };
        if !stepped {
            return Ok(false);
        }
        let after = self.values()?;
        self.values = Some([before, after]);
        let mut all_zero = G::LEN > 0;
        for i in 0..G::LEN {
            let [first, last] = [&before, &after].map(|g| signed(g.as_slice()[i]));
            all_zero &= first == 0.0 && last == 0.0;
            // Where the function has a side, and its value there.
            let (from, value) = match signed(self.sides.as_slice()[i]) {
                // It starts on a zero, after an impact: on which side it leaves is seen a little later.
                0.0 if first == 0.0 => (LITTLE, self.value(i, LITTLE)?),
                side if first == 0.0 => (0.0, side),
                _ => (0.0, first),
            };
            if value * last < 0.0 && self.direction.counts(last) {
                let root = match first {
                    0.0 if from == 0.0 => 0.0,
                    _ => illinois([(from, value), (1.0, last)], |part| self.value(i, part))?,
                };
                self.roots.as_mut_slice()[i] = Scalar::<T>::from_f64(root);
            }
            let side = if value == 0.0 { 0.0 } else { value.signum() };
            self.sides.as_mut_slice()[i] = Scalar::<T>::from_f64(if last != 0.0 { last.signum() } else { side });
        }
        self.zeros = if all_zero { self.zeros + 1 } else { 0 };
        if self.zeros >= ZEROS {
            return Err(StepError::NoEvent { t: signed(self.run.time()) });
        }
        Ok(true)
    }

    /// The time at a part of the last step.
    fn time(&self, part: f64) -> Scalar<T> {
        let (start, end) = (self.before.time(), self.run.time());
        start + Scalar::<T>::from_f64(part) * (end - start)
    }

    /// A function at a part of the last step.
    fn value(&self, i: usize, part: f64) -> Result<f64, StepError> {
        let state = T::between(&self.before, self.run, self.time(part))?;
        Ok(signed((self.g)(&state).as_slice()[i]))
    }

    /// The first of the zeros in the last step that has not been given out.
    fn earliest(&mut self) -> Option<Result<Crossing<T::State>, StepError>> {
        let roots = self.roots.as_slice().iter().map(|root| signed(*root)).enumerate();
        let (which, root) = roots.filter(|(_, root)| !root.is_nan()).min_by(|(_, a), (_, b)| a.total_cmp(b))?;
        self.roots.as_mut_slice()[which] = Scalar::<T>::from_f64(f64::NAN);
        let state = match root {
            0.0 => Ok(self.before.state()),
            1.0 => Ok(self.run.state()),
            part => T::between(&self.before, self.run, self.time(part)),
        };
        let rises = signed(self.sides.as_slice()[which]) > 0.0;
        Some(state.map(|state| Crossing { state, which, rises }))
    }
}

impl<T: Dense, F: Fn(&T::State) -> G, G: Array<Real = Scalar<T>>> Iterator for Crossings<'_, T, F, G> {
    type Item = Result<Crossing<T::State>, StepError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.done {
            return None;
        }
        let found = next(self, Self::earliest, Self::step);
        self.done = !matches!(found, Some(Ok(_)));
        found
    }
}

/// The first zero that a step has, in as many steps as that takes; `None` where no step is left.
pub(super) fn next<S, X>(
    search: &mut S,
    mut earliest: impl FnMut(&mut S) -> Option<Result<X, StepError>>,
    mut step: impl FnMut(&mut S) -> Result<bool, StepError>,
) -> Option<Result<X, StepError>> {
    loop {
        if let Some(found) = earliest(search) {
            return Some(found);
        }
        match step(search) {
            Ok(true) => {}
            Ok(false) => return None,
            Err(error) => return Some(Err(error)),
        }
    }
}

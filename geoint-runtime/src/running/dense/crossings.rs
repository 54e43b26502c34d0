//! Finds the changes of sign of functions along a run, in order of time. Each kind of function has its own way to find them within a step.

use super::crossing::{Crossing, Direction};
use super::{Dense, has_reached, step};
use crate::running::StepError;
use crate::running::trajectory::{Scalar, Trajectory};
use crate::scalar::{Real, signed};
use crate::solving::Failure;
use crate::space::Array;
use crate::taylor::Roots;
use core::fmt::{self, Debug, Formatter};

/// After this many parts in a row in which all functions are zero, the functions count as identically zero, and the search fails.
const MOST_ZERO_PARTS: u32 = 1024;

/// A function with a zero beyond this part of a step has no other zero at the end of the search.
const NEAR_END: f64 = 1.0 - 1.0 / (1_u64 << 40) as f64;

/// Position of a zero at the end of the search, behind all zeros within the last step.
const AT_END: f64 = 2.0;

/// The functions of a search, and the run along which they are evaluated. The search proceeds by steps, or by parts of steps. Positions go from 0 to 1
/// along the last step.
pub trait Functions {
    /// The run.
    type Run: Dense;
    /// The values of all functions.
    type Values: Array;
    /// Room for the changes of sign of a function in a part.
    type Places: Array<Real = f64>;

    /// Returns the run.
    fn run(&mut self) -> &mut Self::Run;

    /// Continues with the next part of the last step. If there is none, takes a step by `take`. Returns `false` if no step is left, as `take` does.
    fn advance(&mut self, take: impl FnOnce(&mut Self::Run) -> Result<bool, StepError>) -> Result<bool, StepError>;

    /// Returns whether all functions are zero throughout the part.
    fn are_zero(&self) -> bool;

    /// Returns the changes of sign of function `i` in the part. `side` is its sign before; 0 if it had none yet. A function without a sign that starts
    /// at zero changes its sign at 0, if it leaves zero. A change at a pole has the position NaN.
    fn changes(&self, i: usize, side: f64) -> Result<Roots<Self::Places>, StepError>;

    /// Returns the state at a change of sign of function `i`. Returns `None` at a pole.
    fn state(&self, i: usize, at: f64) -> Result<Option<StateAlong<Self>>, StepError>;

    /// Returns whether function `i` is zero at the end of the last step, up to rounding.
    fn is_zero_at_end(&self, i: usize) -> bool;
}

/// The states of the run of a search.
type StateAlong<W> = <<W as Functions>::Run as Trajectory>::State;

/// Changes of sign of all functions of a search.
type AllChanges<W> = <<W as Functions>::Values as Array>::Map<Roots<<W as Functions>::Places>>;

/// Iterator over the crossings of a run, in order of time. Ends after the first error, or at a time.
#[doc(alias("Poincaré section", "Poincare section", "surface of section", "event detection", "zero crossing"))]
pub struct Crossings<W: Functions> {
    functions: W,
    direction: Direction,
    end: Option<Scalar<W::Run>>,
    backwards: bool,
    /// Whether to take a shorter last step to the end.
    all_the_way: bool,
    /// Changes of sign in the present part.
    changes: AllChanges<W>,
    /// Last change considered in this part: its position, and the index of the function.
    given: (f64, usize),
    /// Whether the search has not begun, and the run is at an event of an earlier search.
    at_event: bool,
    /// Number of parts in a row in which all functions are zero.
    zeros: u32,
    done: bool,
}

impl<W: Functions> Crossings<W> {
    pub(super) fn new(mut functions: W, direction: Direction) -> Self {
        let run = functions.run();
        let (now, backwards) = (run.time(), run.steps_backwards());
        Crossings {
            at_event: run.reported().is_at(now),
            functions,
            direction,
            end: None,
            backwards,
            all_the_way: false,
            changes: W::Values::fill(Roots::none(0.0)),
            given: (-1.0, 0),
            zeros: 0,
            done: false,
        }
    }

    /// Limits the search to a time, before or after the present time. Runs with fixed steps end up to a step before it, and find no zeros after their end. A zero
    /// up to rounding at the end of the last step counts.
    #[must_use = "the end is that of the iterator that is returned"]
    pub fn until(mut self, t: Scalar<W::Run>) -> Self {
        self.backwards = (t - self.functions.run().time()).any_below(0.0);
        self.end = Some(t);
        self
    }

    /// Moves the run to the first crossing and returns it. If there is none, the run is at the end of the search; the last step may be shorter. If the
    /// functions have no events, for example because they are identically zero, the run returns to `start`. After another error it is where the search stopped.
    pub(super) fn go_to_first(mut self, start: W::Run) -> Result<Option<Crossing<StateAlong<W>>>, StepError> {
        self.all_the_way = true;
        let found = self.search();
        let run = self.functions.run();
        match found {
            Err(StepError { failure: Failure::NoEvent, .. }) => *run = start,
            Ok(Some(Crossing { state, which, .. })) => {
                run.go_on_from(state);
                let t = run.time();
                run.reported().add(t, which);
            }
            _ => {}
        }
        found
    }

    /// Returns the next crossing. Takes steps until one contains a crossing. Returns `None` if no step is left.
    fn search(&mut self) -> Result<Option<Crossing<StateAlong<W>>>, StepError> {
        loop {
            let found = self.next_in_part()?;
            if found.is_some() || !self.advance()? {
                return Ok(found);
            }
        }
    }

    /// Returns the next crossing in the present part.
    fn next_in_part(&mut self) -> Result<Option<Crossing<StateAlong<W>>>, StepError> {
        loop {
            let all = W::Values::entries_of(&self.changes).iter().enumerate();
            let all = all.flat_map(|(i, changes)| changes.changes().map(move |(at, sign)| (at, i, sign)));
            let left = all.filter(|(at, i, sign)| (*at, *i) > self.given && self.direction.counts(*sign));
            let Some((at, which, sign)) = left.min_by(|a, b| a.0.total_cmp(&b.0)) else { return Ok(None) };
            self.given = (at, which);
            let state =
                if at == AT_END { Some(self.functions.run().state()) } else { self.functions.state(which, at)? };
            if let Some(state) = state {
                return Ok(Some(Crossing { state, which, rises: sign > 0.0 }));
            }
        }
    }

    /// Continues with the next part and finds the changes of sign in it. Returns `false` if nothing is left.
    fn advance(&mut self) -> Result<bool, StepError> {
        let now = self.functions.run().time();
        if let Some(t) = self.end.filter(|t| t.magnitude().is_nan()) {
            return Err(StepError::of_step_size(signed(now), signed(t - now)));
        }
        let take = |run: &mut W::Run| match self.end {
            None => step(run, self.backwards),
            Some(t) if has_reached(run.time(), t, self.backwards) => Ok(false),
            Some(t) => {
                let stepped = run.step_towards(t)?;
                let is_last = !stepped && self.all_the_way && t.magnitude().is_finite();
                if is_last && self.backwards == run.steps_backwards() {
                    return run.end_at(t).map(|()| true);
                }
                Ok(stepped)
            }
        };
        if !self.functions.advance(take)? {
            return self.find_zeros_at_end();
        }
        for (i, changes) in W::Values::entries(&mut self.changes).iter_mut().enumerate() {
            // The sign at the end of the part before.
            let side = changes.end();
            *changes = self.functions.changes(i, side)?;
            if side == 0.0 && changes.as_slice().first() == Some(&0.0) {
                // The function starts at zero. It has an event there only if the run stands at an event of an earlier search that did not report this function.
                let counts = self.direction.counts(-changes.sign);
                if !(self.at_event && self.functions.run().reported().takes(i, counts)) {
                    *changes = changes.without_first();
                }
            }
        }
        (self.at_event, self.given) = (false, (-1.0, 0));
        self.zeros = if W::Values::LEN > 0 && self.functions.are_zero() { self.zeros + 1 } else { 0 };
        if self.zeros >= MOST_ZERO_PARTS { Err(self.no_event()) } else { Ok(true) }
    }

    /// Called when no step is left. Finds the functions that are zero up to rounding at the end of the last step, and had no zero just before. Returns
    /// whether there are any.
    ///
    /// Fails if the end lies in the opposite direction, or if all functions were zero throughout.
    fn find_zeros_at_end(&mut self) -> Result<bool, StepError> {
        let run = self.functions.run();
        if let Some(t) = self.end
            && !has_reached(run.time(), t, self.backwards)
            && self.backwards != run.steps_backwards()
        {
            return Err(StepError::without_step(Failure::TimePassed, signed(t)));
        }
        let all = W::Values::entries(&mut self.changes);
        if self.zeros > 0 && all.iter().all(|changes| changes.end() == 0.0) {
            return Err(self.no_event());
        }
        let mut found = false;
        for (i, changes) in all.iter_mut().enumerate() {
            let side = changes.end();
            let is_near = changes.as_slice().iter().any(|at| *at > NEAR_END);
            if side != 0.0 && !is_near && self.direction.counts(-side) && self.functions.is_zero_at_end(i) {
                changes.push(AT_END);
                found = true;
            }
        }
        Ok(found)
    }

    fn no_event(&mut self) -> StepError {
        StepError::without_step(Failure::NoEvent, signed(self.functions.run().time()))
    }
}

impl<W: Functions> Iterator for Crossings<W> {
    type Item = Result<Crossing<StateAlong<W>>, StepError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.done {
            return None;
        }
        let found = self.search().transpose();
        self.done = !matches!(found, Some(Ok(_)));
        found
    }
}

impl<W: Functions> Debug for Crossings<W> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut crossings = f.debug_struct("Crossings");
        crossings.field("direction", &self.direction).field("end", &self.end).finish_non_exhaustive()
    }
}

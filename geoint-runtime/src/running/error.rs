//! Errors of runs: a failure, the time and the length of its step. One table has the texts of all failures.

use super::number::Number;
use crate::scalar::{Real, signed};
use crate::solving::Failure;
use crate::space::Array;
use crate::system::PhaseSpace;
use core::fmt;

/// Error of a run. The run still holds the last good state, and may continue, for instance with a smaller step.
#[doc(alias = "error")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct StepError {
    /// Time of the last good state, or the time that the failure is about: that of a given state, of a request, or of an event.
    pub t: f64,
    /// Length of the step that was refused, negative if it goes back in time. If no step was tried, this is the step size of a run with fixed steps, or the
    /// length that an adaptive run would try, or an invalid step size. It is zero if no length is known, and for failures of requests and events.
    pub h: f64,
    /// Why there is no result.
    pub failure: Failure,
    attempt: Attempt,
}

/// How the length of a refused step was chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Attempt {
    /// It is a setting, or no step was tried.
    Given,
    /// Longer steps were refused before.
    Shortest,
}

impl StepError {
    /// Returns the error of a step of length `h` from time `t`, for runs of your own.
    #[inline]
    pub const fn new(failure: Failure, t: f64, h: f64) -> StepError {
        StepError { t, h, failure, attempt: Attempt::Given }
    }

    /// Returns the error of a run whose shortest step was refused.
    pub(super) const fn of_shortest(failure: Failure, t: f64, h: f64) -> StepError {
        StepError { t, h, failure, attempt: Attempt::Shortest }
    }

    /// Returns the error of a request, an event or a state, which concerns no step.
    pub(super) const fn without_step(failure: Failure, t: f64) -> StepError {
        StepError::new(failure, t, 0.0)
    }

    /// Returns the error of a step size that is no length, in a run at time `t`.
    pub(super) const fn of_step_size(t: f64, h: f64) -> StepError {
        StepError::new(Failure::InvalidStepSize { h }, t, h)
    }

    /// Returns whether even the shortest step was refused, in a run that adapts its steps. Its length `h` is the allowed minimum, or the resolution of time.
    pub const fn is_shortest(&self) -> bool {
        matches!(self.attempt, Attempt::Shortest)
    }

    /// Returns the time [`t`](Self::t). Returns `None` for errors of settings: step sizes, tolerances, orders, parameters.
    pub const fn time(&self) -> Option<f64> {
        match self.failure {
            Failure::InvalidStepSize { .. }
            | Failure::InvalidParameter { .. }
            | Failure::InvalidTolerance { .. }
            | Failure::InvalidBounds { .. }
            | Failure::InvalidOrder { .. } => None,
            _ => Some(self.t),
        }
    }
}

/// Returns an error if a parameter of a system is not a number.
pub(super) fn check_parameters<S: PhaseSpace<R>, R: Real>(system: &S) -> Result<(), Failure> {
    system.invalid_parameter().map_or(Ok(()), |name| Err(Failure::InvalidParameter { name }))
}

/// Returns the failure of a state with an entry that is not finite.
pub(super) fn not_finite<S: PhaseSpace<R>, R: Real>(t: R, z: &S::Phase) -> Failure {
    let [positions, momenta] = z.as_slice().split_at(S::Phase::LEN / 2).into();
    let finite = |entries: &[R]| entries.iter().all(|x| x.magnitude() < f64::INFINITY);
    let of_momenta = S::OF_VELOCITIES && signed(t).is_finite() && finite(positions) && !finite(momenta);
    if of_momenta { Failure::NoMomentum } else { Failure::NonFiniteState }
}

impl fmt::Display for StepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.attempt {
            Attempt::Given => describe(self.failure, f, Some(self)),
            Attempt::Shortest => no_step(self.failure, f, self),
        }
    }
}

impl core::error::Error for StepError {}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        describe(*self, f, None)
    }
}

/// Writes that no step is possible, and the clause of the failure.
fn no_step(failure: Failure, f: &mut fmt::Formatter<'_>, error: &StepError) -> fmt::Result {
    let (t, h) = (Number(error.t), error.h);
    let none = if error.is_shortest() { "not even a" } else { "no" };
    write!(f, "from t = {t} {none} step of {h:.1e} can be taken: {failure}")
}

/// Writes the sentence of a failure for an error, or its clause if there is no error. Sentences without a text of their own are those of [`no_step`].
fn describe(failure: Failure, f: &mut fmt::Formatter<'_>, error: Option<&StepError>) -> fmt::Result {
    macro_rules! say {
        // A failure of settings: the clause is the sentence.
        ($text:literal) => {
            write!(f, $text)
        };
        (clause $clause:literal) => {
            match error {
                None => write!(f, $clause),
                Some(error) => no_step(failure, f, error),
            }
        };
        (clause $clause:literal, at $t:ident $sentence:literal) => {
            match error.map(|error| Number(error.t)) {
                None => write!(f, $clause),
                Some($t) => write!(f, $sentence),
            }
        };
    }
    match failure {
        Failure::InvalidStepSize { h } => {
            let h = Number(h);
            say!("the step size {h} is not a finite number other than zero")
        }
        Failure::InvalidParameter { name } => say!("the parameter `{name}` is not a number"),
        Failure::InvalidTolerance { tolerance } => {
            let (is_large, tolerance) = ((1.0..f64::INFINITY).contains(&tolerance), Number(tolerance));
            match is_large {
                true => say!("the tolerance {tolerance} allows errors as large as the state is; take one below 1"),
                false => say!("the tolerance {tolerance} is not a finite positive number"),
            }
        }
        Failure::InvalidBounds { shortest, longest } => {
            let (are_exchanged, [shortest, longest]) = (longest < shortest, [shortest, longest].map(Number));
            match are_exchanged {
                true => say!(
                    "no step is longer than {shortest} and shorter than {longest}; give the shorter length first: `steps_between({longest}, {shortest})`"
                ),
                false => say!(
                    "no step has a length between {shortest} and {longest}; give a shortest one that is finite, 0 for none, and a longest one above \
                     0, `f64::INFINITY` for none"
                ),
            }
        }
        Failure::InvalidOrder { order } => {
            say!("a Taylor series of order {order} has no estimate of its error; take 2 or more")
        }
        Failure::NonFiniteState => say!(
            clause "its state at the start has an entry that is not finite",
            at t "the state at t = {t} has an entry that is not finite"
        ),
        Failure::NoMomentum => say!(
            clause "the velocities at its start have no finite momenta ∂L/∂v of their own",
            at t "the velocities of the state at t = {t} have no finite momenta ∂L/∂v of their own: the Lagrangian is not defined for them, \
                  or another velocity has the same momenta"
        ),
        Failure::NotNormalised { length } => {
            let length = Number(length);
            say!(
                clause "a quaternion at its start has the length {length} instead of 1",
                at t "the state at t = {t} has a quaternion of length {length}; an attitude is one of length 1: `r.renormalize()`"
            )
        }
        Failure::OffConstraint { what } => say!(
            clause "its start is off a constraint: {what} is not 0",
            at t "the state at t = {t} is off a constraint: {what} is not 0; `state_on_constraint` gives one that is on it"
        ),
        Failure::NonFinite => say!(
            clause "it leads to a state that is not finite",
            at t "the step from t = {t} leads to a state that is not finite; try a smaller step"
        ),
        Failure::OutsideDomain { what } => say!(
            clause "it looks at the energy where it is not defined: {what}",
            at t "the step from t = {t} looks at the energy where it is not defined: {what}"
        ),
        Failure::Singular => say!(
            clause "its equation has no solution, or several",
            at t "the step from t = {t} has no solution, or several, at this step size; try a smaller one"
        ),
        Failure::SingularDirection => say!(
            clause "it moves at right angles to the gradient that it divides by",
            at t "the step from t = {t} moves at right angles to the gradient along which it is to change the energy; \
                  try another step size, or `Gonzalez` or `DiscreteGradient`"
        ),
        Failure::DependentConstraints { what } => say!(
            clause "constraints depend on each other on its way: {what}",
            at t "from t = {t} more than one way leads on: this constraint depends on others there: {what}"
        ),
        Failure::Turned { what } => say!(
            clause "an angle moves by more than half a turn in it, or passes the point where it is not defined: {what}",
            at t "in the step from t = {t} an angle moves by more than half a turn, or passes the point where it is not defined: {what}; \
                  try a smaller step"
        ),
        Failure::Rounded => say!(
            clause "rounding in it changes what it keeps by more than its last digits",
            at t "rounding in the step from t = {t} changes what it keeps by more than its last digits: a coordinate in which that is steep \
                  becomes smaller or larger by orders of magnitude, gradients are nearly parallel, or a force jumps; try a smaller step, or \
                  units in which coordinates are of one size"
        ),
        Failure::LedAstray => say!(
            clause "it ended so far from its invariants that they lead back more than half of it",
            at t "the step from t = {t} ends so far from the invariants of its start that a projection would lead back more than half of it; \
                  try a smaller step, or a method of higher order"
        ),
        Failure::OutOfRange => say!(
            clause "the energy, or another invariant, is too small or too large for the scalar",
            at t "the energy, or another invariant that the method keeps, is too small or too large for the scalar at t = {t}: products of \
                  coordinates and forces underflow or overflow; take units in which they do not"
        ),
        Failure::Pole { piece } => say!(
            clause "the flow of the piece {piece} ends before it does",
            at t "the flow of the piece {piece} ends within the step from t = {t}; try a smaller step"
        ),
        Failure::Unsolved { plane } => say!(
            clause "its equation in the plane of {plane} was not solved",
            at t "the step from t = {t} was not solved in the plane of {plane}; try a smaller step"
        ),
        Failure::NotConverged { iterations, correction } => {
            let plural = if iterations == 1 { "" } else { "s" };
            match iterations {
                0 => say!(
                    clause "its equation was not solved",
                    at t "the equation of the step from t = {t} has no value where its solution is looked for; try a smaller step"
                ),
                _ => say!(
                    clause "its equation was not solved",
                    at t "the step from t = {t} was not solved in {iterations} iteration{plural} (last correction {correction:.1e}); try a smaller step"
                ),
            }
        }
        Failure::Inaccurate { error } => say!(clause "its error is about {error:.1e} times what is tolerated"),
        Failure::Diverges => say!(clause "the series of the solution does not converge in it"),
        Failure::NoRates => say!(clause "the rates of the state there are not finite; are all parameters?"),
        Failure::Sliding => say!(
            clause "a condition of the energy changes sides again and again: the solution does not leave the place where it does"
        ),
        Failure::TimePassed => say!(
            clause "its time is before the last step",
            at t "the time {t} is before the last step: states are known within it, and beyond"
        ),
        Failure::NotInLastStep { from, to } => {
            let [from, to] = [from, to].map(Number);
            say!(
                clause "its time is not within the last step, from {from} to {to}",
                at t "the state at t = {t} is not known: the last step leads from {from} to {to}; take steps to this time, or use `sampled_at`"
            )
        }
        Failure::NoEvent => say!(
            clause "the function whose changes of sign are events is zero all along, or not a number",
            at t "the function whose changes of sign are events is zero all along, or not a number, at t = {t}"
        ),
        Failure::TooManySteps { steps } => say!(
            clause "{steps} steps have not led to the end",
            at t "{steps} steps have led no further than t = {t}; allow more, or a larger tolerance"
        ),
    }
}

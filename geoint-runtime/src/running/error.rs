//! Errors of steps, and reasons for refused steps of adaptive runs.

use super::number::Number;
use crate::method::Refusal;
use crate::scalar::{Real, signed};
use crate::space::Array;
use crate::system::PhaseSpace;
use core::fmt;

/// Error of a step. The integrator still holds the last good state, and may continue, for instance with a smaller step.
#[doc(alias = "error")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum StepError {
    /// The step size is zero, infinite or not a number.
    InvalidStepSize {
        /// Step size as given.
        h: f64,
    },
    /// A parameter of the system is not a number.
    InvalidParameter {
        /// Name of the parameter.
        name: &'static str,
    },
    /// The state given to the integrator is not finite.
    NonFiniteState {
        /// Time of the state.
        t: f64,
    },
    /// The velocities of the state given to the integrator have no unique finite momentum ∂L/∂v. Either the Lagrangian is not defined for them, as
    /// for velocities above that of light. Or another velocity has the same momentum, and is the velocity of the state.
    NoMomentum {
        /// Time of the state.
        t: f64,
    },
    /// A quaternion of the state given to the integrator has a length other than one, so it is not an attitude.
    NotNormalised {
        /// Time of the state.
        t: f64,
        /// Length of the quaternion.
        length: f64,
    },
    /// A step led from a finite state to one that is not finite.
    NonFinite {
        /// Time of the last good state.
        t: f64,
    },
    /// The step meets a point where the energy is not defined. The cases are:
    ///
    /// - A stage of the step left the domain of a function in the energy, or reached its edge, where a derivative is not a number.
    /// - A pole may lie on the straight line between the ends of an implicit step.
    /// - The energy jumps at the end of a step that conserves it, or within a step of a Taylor series.
    OutsideDomain {
        /// Time of the last good state.
        t: f64,
        /// Function and term, as in "`ln` of a number that is not positive: 1 - q".
        what: &'static str,
    },
    /// The implicit equation of the step has no solution that is continuous in h from h = 0 on: its matrix is singular, or an unstable direction is
    /// reversed.
    Singular {
        /// Time of the last good state.
        t: f64,
    },
    /// The state given to the integrator is off a constraint.
    OffConstraint {
        /// Time of the state.
        t: f64,
        /// The expression that is not zero: the constraint or its rate.
        what: &'static str,
    },
    /// The gradients of constraints are linearly dependent at the state given to the integrator, or within a step. The motion is then not unique.
    DependentConstraints {
        /// Time of the last good state.
        t: f64,
        /// A constraint that depends on others.
        what: &'static str,
    },
    /// The increment is orthogonal to the direction along which [`CoordinateIncrement`] changes the energy, so the method has no step.
    ///
    /// [`CoordinateIncrement`]: crate::CoordinateIncrement
    SingularDirection {
        /// Time of the last good state.
        t: f64,
    },
    /// An angle `atan2(y, x)` moves by more than half a turn in the step, or passes the point at which it is undefined. Divided differences of a
    /// function of the angle are then wrong.
    Turned {
        /// Time of the last good state.
        t: f64,
        /// Formula of the angle.
        what: &'static str,
    },
    /// Rounding in the step changes conserved quantities by more than their last digits. Possible causes: a coordinate on which they depend steeply
    /// changes by orders of magnitude, gradients are nearly parallel, or a force jumps.
    Rounded {
        /// Time of the last good state.
        t: f64,
    },
    /// A projection would have to undo more than half of the step, because the step ended far from the invariants of its start. The projected state
    /// could be any other state with the same invariants.
    LedAstray {
        /// Time of the last good state.
        t: f64,
    },
    /// The energy, or another invariant of the method, is too small or too large for the scalar: products of coordinates and forces underflow or
    /// overflow.
    OutOfRange {
        /// Time of the last good state.
        t: f64,
    },
    /// The exact flow of a part of the energy ends within the step: it has a pole there, or its coefficient is singular. Or it makes so many turns
    /// that no digit of the result is known.
    Pole {
        /// Time of the last good state.
        t: f64,
        /// The part of the energy.
        piece: &'static str,
    },
    /// No step of this size was found in a plane; there may be none.
    Unsolved {
        /// Time of the last good state.
        t: f64,
        /// The two coordinates of the plane.
        plane: &'static str,
    },
    /// The implicit equation of the step was not solved to rounding.
    NotConverged {
        /// Time of the last good state.
        t: f64,
        /// Number of iterations.
        iterations: u32,
        /// Last correction, relative to the corrected value.
        correction: f64,
    },
    /// The relative tolerance is not between 0 and 1, or an absolute one is negative or not finite.
    InvalidTolerance {
        /// Tolerance as given.
        tolerance: f64,
    },
    /// The bounds admit no step. Both are absolute values of the given lengths.
    InvalidBounds {
        /// Shortest length.
        shortest: f64,
        /// Longest length.
        longest: f64,
    },
    /// A Taylor series of this low order has no estimate of its error.
    InvalidOrder {
        /// Order as given.
        order: usize,
    },
    /// The requested time lies before the last step.
    TimePassed {
        /// Time as given.
        t: f64,
    },
    /// An event function is not a number, or is identically zero.
    NoEvent {
        /// Time of the state where this was found.
        t: f64,
    },
    /// The end time was not reached within the allowed number of steps. The state is the one after them.
    TooManySteps {
        /// Time of the last good state.
        t: f64,
        /// Number of steps.
        steps: u64,
    },
    /// Even the shortest step was refused. Its length is the allowed minimum, or the resolution of time.
    StepTooSmall {
        /// Time of the last good state.
        t: f64,
        /// Length of the step that was refused last.
        h: f64,
        /// Reason for the refusal.
        reason: Reason,
    },
}

impl StepError {
    /// Returns the time of the last good state, or the time that the error names. Returns `None` for errors of settings: step sizes, tolerances,
    /// orders, parameters.
    pub const fn time(&self) -> Option<f64> {
        match self {
            StepError::NonFiniteState { t, .. }
            | StepError::NoMomentum { t, .. }
            | StepError::NotNormalised { t, .. }
            | StepError::NonFinite { t, .. }
            | StepError::OutsideDomain { t, .. }
            | StepError::Singular { t, .. }
            | StepError::OffConstraint { t, .. }
            | StepError::DependentConstraints { t, .. }
            | StepError::SingularDirection { t, .. }
            | StepError::Turned { t, .. }
            | StepError::Rounded { t, .. }
            | StepError::LedAstray { t, .. }
            | StepError::OutOfRange { t, .. }
            | StepError::Pole { t, .. }
            | StepError::Unsolved { t, .. }
            | StepError::NotConverged { t, .. }
            | StepError::TimePassed { t, .. }
            | StepError::NoEvent { t, .. }
            | StepError::TooManySteps { t, .. }
            | StepError::StepTooSmall { t, .. } => Some(*t),
            StepError::InvalidStepSize { .. }
            | StepError::InvalidParameter { .. }
            | StepError::InvalidTolerance { .. }
            | StepError::InvalidBounds { .. }
            | StepError::InvalidOrder { .. } => None,
        }
    }

    /// Returns an error if a parameter of a system is not a number.
    pub(super) fn of_parameters<S: PhaseSpace<R>, R: Real>(system: &S) -> Result<(), StepError> {
        system.invalid_parameter().map_or(Ok(()), |name| Err(StepError::InvalidParameter { name }))
    }

    /// Returns the error of a state with an entry that is not finite.
    pub(super) fn not_finite<S: PhaseSpace<R>, R: Real>(t: R, z: &S::Phase) -> StepError {
        let (t, [positions, momenta]) = (signed(t), z.as_slice().split_at(S::Phase::LEN / 2).into());
        let finite = |entries: &[R]| entries.iter().all(|x| x.magnitude() < f64::INFINITY);
        if S::OF_VELOCITIES && t.is_finite() && finite(positions) && !finite(momenta) {
            StepError::NoMomentum { t }
        } else {
            StepError::NonFiniteState { t }
        }
    }

    /// Returns the error of a step from time `t` that has no result.
    pub(super) fn refused(refusal: Refusal, t: f64) -> StepError {
        match refusal {
            Refusal::Singular => StepError::Singular { t },
            Refusal::SingularDirection => StepError::SingularDirection { t },
            Refusal::Rounded => StepError::Rounded { t },
            Refusal::Turned { what } => StepError::Turned { t, what },
            Refusal::LedAstray => StepError::LedAstray { t },
            Refusal::OutOfRange => StepError::OutOfRange { t },
            Refusal::DependentConstraints { what } => StepError::DependentConstraints { t, what },
            Refusal::NotConverged { iterations, correction } => StepError::NotConverged { t, iterations, correction },
            Refusal::OutsideDomain { what } => StepError::OutsideDomain { t, what },
        }
    }
}

/// Reason for refusing a step of an adaptive run.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// The estimated error is beyond the tolerance.
    Inaccurate {
        /// Estimated error in units of the tolerance.
        error: f64,
    },
    /// The step evaluates the energy outside of its domain, or the energy may have a pole or a jump within the step.
    OutsideDomain {
        /// Function and term.
        what: &'static str,
    },
    /// The step leads to a state that is not finite.
    NonFinite,
    /// The implicit equation of the step has no solution that is continuous in h from h = 0 on.
    Singular,
    /// The increment is orthogonal to the gradient along which the step changes the energy.
    SingularDirection,
    /// Rounding in the step changes conserved quantities by more than their last digits.
    Rounded,
    /// An angle moves by more than half a turn in the step, or passes the point at which it is undefined.
    Turned {
        /// Formula of the angle.
        what: &'static str,
    },
    /// A projection would have to undo more than half of the step.
    LedAstray,
    /// A conserved quantity is too small or too large for the scalar.
    OutOfRange,
    /// Constraints depend on each other within the step.
    DependentConstraints {
        /// A constraint that depends on others.
        what: &'static str,
    },
    /// The exact flow of a part of the energy ends within the step.
    Pole {
        /// The part of the energy.
        piece: &'static str,
    },
    /// No step of this size was found in a plane; there may be none.
    Unsolved {
        /// The two coordinates of the plane.
        plane: &'static str,
    },
    /// The implicit equation of the step was not solved to rounding.
    NotConverged,
    /// The Taylor series of the solution does not converge within the step: the solution has a pole or a collision there.
    Diverges,
    /// The rates of the state at the start are not finite. A parameter may not be finite either.
    NoRates,
    /// A condition of the energy changes at the ends of many steps in a row, within a negligible time, and both sides lead back to it. The solution
    /// cannot leave this surface.
    Sliding,
}

impl From<Refusal> for Reason {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Singular => Reason::Singular,
            Refusal::SingularDirection => Reason::SingularDirection,
            Refusal::Rounded => Reason::Rounded,
            Refusal::Turned { what } => Reason::Turned { what },
            Refusal::LedAstray => Reason::LedAstray,
            Refusal::OutOfRange => Reason::OutOfRange,
            Refusal::DependentConstraints { what } => Reason::DependentConstraints { what },
            Refusal::NotConverged { .. } => Reason::NotConverged,
            Refusal::OutsideDomain { what } => Reason::OutsideDomain { what },
        }
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Reason::Inaccurate { error } => write!(f, "its error is about {error:.1e} times what is tolerated"),
            Reason::OutsideDomain { what } => write!(f, "it looks at the energy where it is not defined: {what}"),
            Reason::NonFinite => write!(f, "it leads to a state that is not finite"),
            Reason::Singular => write!(f, "its equation has no solution, or several"),
            Reason::SingularDirection => write!(f, "it moves at right angles to the gradient that it divides by"),
            Reason::Rounded => write!(f, "rounding in it changes what it keeps by more than its last digits"),
            Reason::LedAstray => {
                write!(f, "it ended so far from its invariants that they lead back more than half of it")
            }
            Reason::OutOfRange => {
                write!(f, "the energy, or another invariant, is too small or too large for the scalar")
            }
            Reason::Turned { what } => {
                write!(
                    f,
                    "an angle moves by more than half a turn in it, or passes the point where it is not defined: {what}"
                )
            }
            Reason::DependentConstraints { what } => write!(f, "constraints depend on each other on its way: {what}"),
            Reason::Pole { piece } => write!(f, "the flow of the piece {piece} ends before it does"),
            Reason::Unsolved { plane } => write!(f, "its equation in the plane of {plane} was not solved"),
            Reason::NotConverged => write!(f, "its equation was not solved"),
            Reason::Diverges => write!(f, "the series of the solution does not converge in it"),
            Reason::NoRates => write!(f, "the rates of the state there are not finite; are all parameters?"),
            Reason::Sliding => write!(
                f,
                "a condition of the energy changes sides again and again: the solution does not leave the place where it does"
            ),
        }
    }
}

impl fmt::Display for StepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            StepError::InvalidStepSize { h } => {
                write!(f, "the step size {h} is not a finite number other than zero", h = Number(h))
            }
            StepError::InvalidParameter { name } => write!(f, "the parameter `{name}` is not a number"),
            StepError::NonFiniteState { t } => {
                write!(f, "the state at t = {t} has an entry that is not finite", t = Number(t))
            }
            StepError::NoMomentum { t } => {
                write!(
                    f,
                    "the velocities of the state at t = {t} have no finite momenta ∂L/∂v of their own: the Lagrangian is not defined for them, \
                     or another velocity has the same momenta",
                    t = Number(t)
                )
            }
            StepError::NotNormalised { t, length } => {
                write!(
                    f,
                    "the state at t = {t} has a quaternion of length {length}; an attitude is one of length 1: `r.renormalize()`",
                    t = Number(t),
                    length = Number(length)
                )
            }
            StepError::NonFinite { t } => {
                write!(
                    f,
                    "the step from t = {t} leads to a state that is not finite; try a smaller step",
                    t = Number(t)
                )
            }
            StepError::OutsideDomain { t, what } => {
                write!(f, "the step from t = {t} looks at the energy where it is not defined: {what}", t = Number(t))
            }
            StepError::Singular { t } => {
                write!(
                    f,
                    "the step from t = {t} has no solution, or several, at this step size; try a smaller one",
                    t = Number(t)
                )
            }
            StepError::OffConstraint { t, what } => write!(
                f,
                "the state at t = {t} is off a constraint: {what} is not 0; `state_on_constraint` gives one that is on it",
                t = Number(t)
            ),
            StepError::DependentConstraints { t, what } => {
                write!(
                    f,
                    "from t = {t} more than one way leads on: this constraint depends on others there: {what}",
                    t = Number(t)
                )
            }
            StepError::SingularDirection { t } => {
                write!(
                    f,
                    "the step from t = {t} moves at right angles to the gradient along which it is to change the energy; \
                     try another step size, or `Gonzalez` or `DiscreteGradient`",
                    t = Number(t)
                )
            }
            StepError::Rounded { t } => {
                write!(
                    f,
                    "rounding in the step from t = {t} changes what it keeps by more than its last digits: a coordinate in which that is steep \
                     becomes smaller or larger by orders of magnitude, gradients are nearly parallel, or a force jumps; try a smaller step, or units in which coordinates are of one size",
                    t = Number(t)
                )
            }
            StepError::LedAstray { t } => {
                write!(
                    f,
                    "the step from t = {t} ends so far from the invariants of its start that a projection would lead back more than half of it; \
                     try a smaller step, or a method of higher order",
                    t = Number(t)
                )
            }
            StepError::OutOfRange { t } => {
                write!(
                    f,
                    "the energy, or another invariant that the method keeps, is too small or too large for the scalar at t = {t}: products of \
                     coordinates and forces underflow or overflow; take units in which they do not"
                )
            }
            StepError::Turned { t, what } => {
                write!(
                    f,
                    "in the step from t = {t} an angle moves by more than half a turn, or passes the point where it is not defined: {what}; \
                     try a smaller step",
                    t = Number(t)
                )
            }
            StepError::Pole { t, piece } => {
                write!(
                    f,
                    "the flow of the piece {piece} ends within the step from t = {t}; try a smaller step",
                    t = Number(t)
                )
            }
            StepError::Unsolved { t, plane } => {
                write!(
                    f,
                    "the step from t = {t} was not solved in the plane of {plane}; try a smaller step",
                    t = Number(t)
                )
            }
            StepError::NotConverged { t, iterations: 0, .. } => {
                write!(
                    f,
                    "the equation of the step from t = {t} has no value where its solution is looked for; try a smaller step",
                    t = Number(t)
                )
            }
            StepError::NotConverged { t, iterations, correction } => write!(
                f,
                "the step from t = {t} was not solved in {iterations} iteration{} \
                 (last correction {correction:.1e}); try a smaller step",
                if iterations == 1 { "" } else { "s" },
                t = Number(t)
            ),
            StepError::InvalidTolerance { tolerance } if (1.0..f64::INFINITY).contains(&tolerance) => {
                write!(
                    f,
                    "the tolerance {tolerance} allows errors as large as the state is; take one below 1",
                    tolerance = Number(tolerance)
                )
            }
            StepError::InvalidTolerance { tolerance } => {
                write!(f, "the tolerance {tolerance} is not a finite positive number", tolerance = Number(tolerance))
            }
            StepError::InvalidBounds { shortest, longest } if longest < shortest => write!(
                f,
                "no step is longer than {shortest} and shorter than {longest}; give the shorter length first: `steps_between({longest}, {shortest})`",
                shortest = Number(shortest),
                longest = Number(longest)
            ),
            StepError::InvalidBounds { shortest, longest } => write!(
                f,
                "no step has a length between {shortest} and {longest}; give a shortest one that is finite, 0 for none, and a longest one above \
                 0, `f64::INFINITY` for none",
                shortest = Number(shortest),
                longest = Number(longest)
            ),
            StepError::InvalidOrder { order } => {
                write!(f, "a Taylor series of order {order} has no estimate of its error; take 2 or more")
            }
            StepError::TimePassed { t } => {
                write!(f, "the time {t} is before the last step: states are known within it, and beyond", t = Number(t))
            }
            StepError::NoEvent { t } => {
                write!(
                    f,
                    "the function whose changes of sign are events is zero all along, or not a number, at t = {t}",
                    t = Number(t)
                )
            }
            StepError::TooManySteps { t, steps } => {
                write!(
                    f,
                    "{steps} steps have led no further than t = {t}; allow more, or a larger tolerance",
                    t = Number(t)
                )
            }
            StepError::StepTooSmall { t, h, reason } => {
                write!(f, "from t = {t} not even a step of {h:.1e} can be taken: {reason}", t = Number(t))
            }
        }
    }
}

impl core::error::Error for StepError {}

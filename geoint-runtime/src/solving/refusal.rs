//! Reasons why a step has no result. A run adds the time of the last good state, and reports them as [`StepError`](crate::StepError).

use core::fmt;

/// The reason why a step has no result. Most reasons vanish if the step size h is smaller. Displayed texts continue a sentence about the step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Refusal {
    /// The iteration ended without a solution.
    NotConverged {
        /// The number of corrections.
        iterations: u32,
        /// The last correction, relative to the quantity that it corrects. It is infinite if there was none, or if the iteration ended because corrections
        /// stopped shrinking.
        correction: f64,
    },
    /// No solution is shown to be continuous in h from h = 0 on. The matrix of the equation, or another matrix of the method, is singular, or its determinant
    /// is negative. Otherwise the solution failed the test of continuity, or a fast attempt did not test it.
    Singular,
    /// An increment is orthogonal to the direction along which it must change the energy. [`CoordinateIncrement`](crate::CoordinateIncrement) divides by their
    /// scalar product.
    SingularDirection,
    /// The constraints depend on each other at an end of the step, or on the way.
    DependentConstraints {
        /// The formula of a constraint that depends on others.
        what: &'static str,
    },
    /// An angle `atan2(y, x)` moves by more than half a turn, or passes the point at which it is not defined.
    Turned {
        /// The formula of the angle.
        what: &'static str,
    },
    /// Rounding on the way changes an invariant of the step by more than its last digits. Causes are coordinates that change by orders of magnitude, nearly
    /// parallel gradients, or a force that jumps.
    Rounded,
    /// The projection to the invariants would have to undo more than half of the step. It might lead to an unrelated state with the same invariants.
    LedAstray,
    /// An invariant of the step underflows or overflows.
    OutOfRange,
    /// The energy is not defined at a point of the step, a pole on its way is not excluded, or the energy jumps at its end.
    OutsideDomain {
        /// The function and the term that cause the refusal.
        what: &'static str,
    },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::NotConverged { iterations, correction } => {
                write!(f, "its equation was not solved in {iterations} iterations (last correction {correction:.1e})")
            }
            Refusal::Singular => write!(f, "its equation has no solution, or several"),
            Refusal::SingularDirection => write!(f, "it moves at right angles to the gradient that it divides by"),
            Refusal::DependentConstraints { what } => {
                write!(f, "its constraints depend on each other on the way: {what}")
            }
            Refusal::Turned { what } => write!(f, "an angle moves by more than half a turn in it: {what}"),
            Refusal::Rounded => write!(f, "rounding in it changes what it keeps by more than its last digits"),
            Refusal::LedAstray => {
                write!(f, "it ended so far from its invariants that they lead back more than half of it")
            }
            Refusal::OutOfRange => {
                write!(f, "the energy, or another invariant, is too small or too large for the scalar")
            }
            Refusal::OutsideDomain { what } => write!(f, "it evaluates the energy where that is not defined: {what}"),
        }
    }
}

impl core::error::Error for Refusal {}

impl Refusal {
    /// Returns the error [`Refusal::OutsideDomain`] if a term was `found` that is not defined, has a pole or jumps. Returns `Ok` otherwise.
    #[inline(always)]
    pub(crate) fn outside(found: Option<&'static str>) -> Result<(), Refusal> {
        found.map_or(Ok(()), |what| Err(Refusal::OutsideDomain { what }))
    }
}

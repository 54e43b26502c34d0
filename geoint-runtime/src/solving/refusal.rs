//! Why a step has no result.

use core::fmt;

/// Why a step has no result.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Refusal {
    /// The iteration gave up.
    NotConverged {
        /// Iterations spent.
        iterations: u32,
        /// The last correction relative to what it corrects.
        correction: f64,
    },
    /// The equation of the step has no solution that is continuous in h from h = 0 on: its matrix is singular, or changed its
    /// orientation on the way.
    Singular,
    /// An increment is orthogonal to the direction along which it is to change the energy.
    SingularDirection,
    /// Constraints depend on each other at an end of the step, or on the way.
    DependentConstraints {
        /// The formula of one that depends on others.
        what: &'static str,
    },
    /// An angle `atan2(y, x)` moves by more than half a turn, or passes the point at which it is not defined.
    Turned {
        /// The formula of the angle.
        what: &'static str,
    },
    /// Rounding on the way changes what the step keeps by more than its last digits.
    Rounded,
    /// A projection would have to lead back more than half of the step.
    LedAstray,
    /// What the step keeps underflows or overflows.
    OutOfRange,
    /// The energy is not defined, or has a pole, on the way.
    OutsideDomain {
        /// The function and the term.
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
    /// Nothing wrong if nothing was found.
    #[inline(always)]
    pub(crate) fn outside(found: Option<&'static str>) -> Result<(), Refusal> {
        found.map_or(Ok(()), |what| Err(Refusal::OutsideDomain { what }))
    }
}

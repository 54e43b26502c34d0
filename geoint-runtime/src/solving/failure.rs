//! Reasons why a step has no result. A run adds the time and the length of the step, and reports both as [`StepError`](crate::StepError).

/// Why a step has no result, or a run cannot go on.
///
/// Methods and solvers return it. A run returns a [`StepError`](crate::StepError), with the time and the length of the step. Most failures of steps vanish
/// if the step is shorter. Displayed texts continue a sentence about the step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Failure {
    /// The step size is zero, infinite or not a number. Or a requested time is not a number, or an infinite time for `advance_to`.
    InvalidStepSize {
        /// Step size as given.
        h: f64,
    },
    /// A parameter of the system is not a number.
    InvalidParameter {
        /// Name of the parameter.
        name: &'static str,
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
    /// The state given to the run is not finite.
    NonFiniteState,
    /// The velocities of the state given to the run have no unique finite momentum ∂L/∂v. Either the Lagrangian is not defined for them, as for
    /// velocities above that of light. Or two velocities have the same momentum, and the momentum leads back to the other one.
    NoMomentum,
    /// A quaternion of the state given to the run has a length other than one, so it is not an attitude.
    NotNormalised {
        /// Length of the quaternion.
        length: f64,
    },
    /// The state given to the run is off a constraint.
    OffConstraint {
        /// The expression that is not zero: the constraint or its rate.
        what: &'static str,
    },
    /// The step leads from a finite state to one that is not finite.
    NonFinite,
    /// The step meets a point where the energy is not defined. The cases are:
    ///
    /// - A stage of the step left the domain of a function in the energy, or reached its edge, where a derivative is not a number.
    /// - A pole may lie on the straight line between the ends of an implicit step.
    /// - The energy jumps at the end of a step that conserves it, or within a step of a Taylor series.
    OutsideDomain {
        /// Function and term, as in "`ln` of a number that is not positive: 1 - q".
        what: &'static str,
    },
    /// No solution is shown to be continuous in h from h = 0 on. The matrix of the equation, or another matrix of the method, is singular, or its determinant
    /// is negative. Otherwise the solution failed the test of continuity, or a fast attempt did not test it.
    Singular,
    /// The increment is orthogonal to the direction along which the step changes the energy. [`CoordinateIncrement`](crate::CoordinateIncrement) divides by
    /// their scalar product.
    SingularDirection,
    /// The gradients of constraints are linearly dependent at the state given to the run, or within a step. The motion is then not unique.
    DependentConstraints {
        /// The formula of a constraint that depends on others.
        what: &'static str,
    },
    /// An angle `atan2(y, x)` moves by more than half a turn in the step, or passes the point at which it is undefined. Divided differences of a function of
    /// the angle are then wrong.
    Turned {
        /// The formula of the angle.
        what: &'static str,
    },
    /// Rounding in the step changes conserved quantities by more than their last digits. Possible causes: a coordinate on which they depend steeply changes by
    /// orders of magnitude, gradients are nearly parallel, or a force jumps.
    Rounded,
    /// A projection would have to undo more than half of the step, because the step ended far from the invariants of its start. The projected state could be
    /// any other state with the same invariants.
    LedAstray,
    /// The energy, or another invariant of the method, is too small or too large for the scalar: products of coordinates and forces underflow or overflow.
    OutOfRange,
    /// The exact flow of a part of the energy ends within the step: it has a pole there, or its coefficient is singular. Or it makes so many turns that no digit
    /// of the result is known.
    Pole {
        /// The part of the energy.
        piece: &'static str,
    },
    /// No step of this size was found in a plane; there may be none.
    Unsolved {
        /// The two coordinates of the plane.
        plane: &'static str,
    },
    /// The implicit equation of the step was not solved to rounding. A step that an adaptive run marks for another check counts as not solved, after 0
    /// iterations.
    NotConverged {
        /// The number of corrections.
        iterations: u32,
        /// The last correction, relative to the quantity that it corrects. It is infinite if there was none, or if the iteration ended because corrections
        /// stopped shrinking.
        correction: f64,
    },
    /// The estimated error is beyond the tolerance.
    Inaccurate {
        /// Estimated error in units of the tolerance.
        error: f64,
    },
    /// The Taylor series of the solution does not converge within the step: the solution has a pole or a collision there.
    Diverges,
    /// The rates of the state at the start are not finite. A parameter may not be finite either.
    NoRates,
    /// A condition of the energy changes at the ends of many steps in a row, within a negligible time, and both sides lead back to it. The solution cannot
    /// leave this surface.
    Sliding,
    /// The requested time lies before the last step.
    TimePassed,
    /// The state at the requested time is not known: the time does not lie within the last step.
    NotInLastStep {
        /// Time at which the last step started. The present time if there was no step since a setting changed.
        from: f64,
        /// Present time.
        to: f64,
    },
    /// An event function is not a number, or is identically zero.
    NoEvent,
    /// The end time was not reached within the allowed number of steps. The state is the one after them.
    TooManySteps {
        /// Number of steps.
        steps: u64,
    },
}

impl core::error::Error for Failure {}

impl Failure {
    /// Returns the error [`Failure::OutsideDomain`] if a term was `found` that is not defined, has a pole or jumps. Returns `Ok` otherwise.
    #[inline(always)]
    pub(crate) fn outside(found: Option<&'static str>) -> Result<(), Failure> {
        found.map_or(Ok(()), |what| Err(Failure::OutsideDomain { what }))
    }
}

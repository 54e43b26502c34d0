//! How a run handles the steps of a method.

/// How a run handles the steps of a method. Most methods are [`Handling::PLAIN`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Handling {
    /// Steps may be longer or shorter than h. A step adds the difference to `x.ahead`.
    pub scales_steps: bool,
    /// The momenta after a step have the rounding error of the positions divided by h. A state within a step is then computed from the farther end of the
    /// step, because a very short step would amplify the error.
    pub is_rough_if_short: bool,
    /// [`step`](crate::Method::step) is faster than [`advance`](crate::Method::advance) for a single step.
    pub is_faster_singly: bool,
    /// The method moves an inner point in place of the point of the state: a point in other coordinates, or the image under a processor.
    /// [`enter`](crate::Method::enter) and [`leave`](crate::Method::leave) map one to the other.
    pub moves_inner_point: bool,
    /// Steps keep invariants to rounding. [`way_back`](crate::Method::way_back) removes their drift.
    pub keeps_invariants: bool,
}

impl Handling {
    /// Steps of the length h that move the point of the state, and keep no invariants to rounding.
    pub const PLAIN: Self = Handling {
        scales_steps: false,
        is_rough_if_short: false,
        is_faster_singly: false,
        moves_inner_point: false,
        keeps_invariants: false,
    };

    /// Steps that are faster than [`advance`](crate::Method::advance) for a single step.
    pub const FASTER_SINGLY: Self = Handling { is_faster_singly: true, ..Handling::PLAIN };
}

//! The leaves of the graph other than numbers.

/// A leaf of the graph. Coordinates are numbered in the order of storage. The order of the variants decides the order of operations in emitted code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Symbol {
    /// A position q, or a coordinate x of a field.
    Position(u32),
    Momentum(u32),
    Velocity(u32),
    Action,
    /// The time at which an energy or a field is evaluated.
    Time,
    /// One number of a parameter, or a constant whose value the macro cannot read.
    Parameter(u32),
    /// The length of a step or flow.
    StepLength,
    /// The time at the start of a step, in formulas that read it beside [`Symbol::Time`].
    StepStart,
    /// The time at the end of a step, where the next step starts.
    StepEnd,
    /// The weight of the force gradient in a kick.
    GradientWeight,
    /// The increment of a position over a step.
    PositionIncrement(u32),
    /// The increment of a momentum over a step.
    MomentumIncrement(u32),
    /// The increment of the action over a step.
    ActionIncrement,
    /// The increment of a velocity over a step.
    VelocityIncrement(u32),
    /// The multiplier of a constraint.
    Multiplier(u32),
}

impl Symbol {
    /// Returns whether this is a position, a momentum, a velocity or the action.
    pub(crate) fn is_coordinate(self) -> bool {
        matches!(self, Symbol::Position(_) | Symbol::Momentum(_) | Symbol::Velocity(_) | Symbol::Action)
    }

    /// Returns whether this is a position or a momentum.
    pub(crate) fn is_canonical(self) -> bool {
        matches!(self, Symbol::Position(_) | Symbol::Momentum(_))
    }
}

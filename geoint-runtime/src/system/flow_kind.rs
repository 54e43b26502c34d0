//! The kind of a flow: properties that let a method skip work.

use crate::scalar::Real;
use crate::space::Array;

/// The kind of a flow. A method reads it to skip work that the flow does not need, and to choose the time of the flow: a wrong value gives wrong results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FlowKind {
    /// How the flow changes coordinates.
    pub change: Change,
    /// How the flow depends on time.
    pub time: TimeDependence,
    /// Whether the flow makes momenta non-finite at a point where the energy is not defined.
    pub shows_domain: bool,
    /// The parts of the flow that may cease to exist within a step.
    pub parts: &'static [FlowPart],
}

/// How a flow changes coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// A kick that only adds to momenta, or a drift that only adds to positions. The increment does not depend on the coordinates that it is added to.
    Adds,
    /// Any other change.
    Moves,
}

/// How a flow depends on time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimeDependence {
    /// Not at all.
    None,
    /// The flow is that of the energy at the time that the flows of the other kind have reached.
    Frozen,
    /// The flow is exact in time. It starts at the time that the flows of its own kind have reached.
    Exact,
}

impl FlowKind {
    /// A flow that adds an increment, at frozen time.
    pub const ADDS: Self =
        FlowKind { change: Change::Adds, time: TimeDependence::Frozen, shows_domain: false, parts: &[] };
    /// Any other flow, at frozen time.
    pub const MOVES: Self = FlowKind { change: Change::Moves, ..Self::ADDS };

    /// Returns whether the flow only adds an increment.
    pub const fn adds(&self) -> bool {
        matches!(self.change, Change::Adds)
    }

    /// Returns whether the flow adds the same increment whenever its coordinates are the same.
    pub const fn repeats(&self) -> bool {
        self.adds() && matches!(self.time, TimeDependence::None)
    }

    /// Returns whether the flow is exact in time.
    pub const fn is_exact_in_time(&self) -> bool {
        matches!(self.time, TimeDependence::Exact)
    }

    /// States that the flow does not depend on time.
    pub const fn without_time(mut self) -> Self {
        self.time = TimeDependence::None;
        self
    }

    /// States that the flow is exact in time.
    pub const fn exact_in_time(mut self) -> Self {
        self.time = TimeDependence::Exact;
        self
    }

    /// States that the flow makes momenta non-finite at a point where the energy is not defined.
    pub const fn showing_domain(mut self) -> Self {
        self.shows_domain = true;
        self
    }

    /// Adds the parts that may cease to exist within a step.
    pub const fn with_parts(mut self, parts: &'static [FlowPart]) -> Self {
        self.parts = parts;
        self
    }
}

/// A part of a flow that may cease to exist within a step, with its name and the positions that it moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FlowPart {
    /// The name in messages.
    pub name: &'static str,
    /// The index of the first position, in the order of storage.
    pub first: usize,
    /// The number of positions.
    pub count: usize,
}

impl FlowPart {
    /// Returns whether the positions are finite.
    pub(crate) fn is_finite<R: Real, Z: Array<Real = R>>(&self, z: &Z) -> bool {
        let positions = &z.as_slice()[self.first..self.first + self.count];
        positions.iter().all(|x| x.magnitude() < f64::INFINITY)
    }
}

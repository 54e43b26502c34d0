//! The momenta that neither damping nor other forces change.

use super::{Damping, Forces, Momentum};
use crate::ir::{Graph, Symbol};

/// The damping and the forces that change momenta.
#[derive(Clone, Copy)]
pub(crate) struct Spared<'a> {
    pub(crate) damping: Option<&'a Damping>,
    pub(crate) forces: Option<&'a Forces>,
}

impl Spared<'_> {
    /// Returns whether the momentum of coordinate `i` is unchanged.
    pub(crate) fn coordinate(self, graph: &Graph, i: u32) -> bool {
        self.damping.is_none_or(|damping| damping.spares(graph, i))
            && self.forces.is_none_or(|forces| forces.spare(graph, i))
    }

    /// Returns whether all momenta in a sum of momenta are unchanged.
    pub(crate) fn momentum(self, graph: &Graph, momentum: &Momentum) -> bool {
        let changed = |symbol| matches!(symbol, Symbol::Momentum(i) if !self.coordinate(graph, i));
        !graph.reads_any(momentum.value, changed)
    }
}

//! Momenta that friction and other forces leave constant. Reports and proofs of conserved momenta ask for them.

use super::{Damping, Forces, Momentum};
use crate::ir::{Graph, Symbol};

/// Friction and forces beside an energy. Either may be absent.
#[derive(Clone, Copy)]
pub(crate) struct Spared<'a> {
    pub(crate) damping: Option<&'a Damping>,
    pub(crate) forces: Option<&'a Forces>,
}

impl Spared<'_> {
    /// Returns whether neither friction nor a force acts on the momentum of coordinate `i`.
    pub(crate) fn coordinate(self, graph: &Graph, i: u32) -> bool {
        self.damping.is_none_or(|damping| damping.spares(graph, i))
            && self.forces.is_none_or(|forces| forces.spare(graph, i))
    }

    /// Returns whether neither acts on any momentum that a conserved function reads. Forces that cancel in a sum count as acting.
    pub(crate) fn momentum(self, graph: &Graph, momentum: &Momentum) -> bool {
        let changed = |symbol| matches!(symbol, Symbol::Momentum(i) if !self.coordinate(graph, i));
        !graph.reads_any(momentum.value, changed)
    }
}

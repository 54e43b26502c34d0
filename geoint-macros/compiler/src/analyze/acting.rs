//! Which momenta do friction and forces change? The report and the proofs of conserved momenta use the answer.
//!
//! Friction by the action s of contact systems is a part of their energy, and not a subject of this file.

use super::{Conserved, Damping, Forces};
use crate::ir::{Graph, Symbol};

/// Friction and forces beside an energy. Either may be absent.
#[derive(Clone, Copy)]
pub(crate) struct Acting<'a> {
    pub(crate) damping: Option<&'a Damping>,
    pub(crate) forces: Option<&'a Forces>,
}

impl Acting<'_> {
    /// Returns whether friction or a force changes momentum pᵢ.
    pub(crate) fn on_momentum(self, graph: &Graph, i: u32) -> bool {
        self.damping.is_some_and(|damping| damping.acts_on(graph, i))
            || self.forces.is_some_and(|forces| forces.act_on(graph, i))
    }

    /// Returns whether friction or a force may change a conserved function. It acts on p' only, so the positions in the function do not matter. Forces that
    /// cancel in a sum count as acting.
    pub(crate) fn on(self, graph: &Graph, conserved: &Conserved) -> bool {
        graph.reads_any(conserved.value, |symbol| matches!(symbol, Symbol::Momentum(i) if self.on_momentum(graph, i)))
    }
}

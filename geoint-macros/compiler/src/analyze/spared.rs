//! Which momenta damping and other forces leave alone.

use super::{Damping, Forces, Momentum};
use crate::ir::{Graph, Symbol};

/// What takes momenta away, or adds to them.
#[derive(Clone, Copy)]
pub(crate) struct Spared<'a> {
    pub(crate) damping: Option<&'a Damping>,
    pub(crate) forces: Option<&'a Forces>,
}

impl Spared<'_> {
    /// Whether nothing changes the momentum of coordinate `i`.
    pub(crate) fn coordinate(self, graph: &Graph, i: u32) -> bool {
        let row = |damping: &Damping| damping.matrix[i as usize].iter().all(|entry| graph.is_zero(*entry));
        let force = |forces: &Forces| forces.all().all(|forces| graph.is_zero(forces[i as usize]));
        self.damping.is_none_or(row) && self.forces.is_none_or(force)
    }

    /// Whether nothing changes any of the momenta that it reads.
    pub(crate) fn momentum(self, graph: &Graph, momentum: &Momentum) -> bool {
        let symbols = graph.symbols(momentum.value);
        symbols.iter().all(|symbol| !matches!(symbol, Symbol::Momentum(i) if !self.coordinate(graph, *i)))
    }
}

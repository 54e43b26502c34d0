//! Which coordinates a node reads.

use crate::ir::{Graph, Id, Node, Symbol};
use std::collections::BTreeSet;

/// Whether positions and momenta do not move without s, which decay at the rate ∂H/∂s and move by these derivatives else: by a condition a
/// derivative reads s, too, where nothing is differentiated by it.
pub(crate) fn acts_back(graph: &Graph, decay: Id, slopes: impl IntoIterator<Item = Id>) -> bool {
    graph.reads(decay).state() || slopes.into_iter().any(|slope| graph.reads(slope).s)
}

/// All symbols that a node reads.
pub(crate) fn symbols(graph: &Graph, root: Id) -> BTreeSet<Symbol> {
    let symbol = |id: Id| match graph.node(id) {
        Node::Symbol(symbol) => Some(*symbol),
        _ => None,
    };
    graph.reachable(&[root]).into_iter().filter_map(symbol).collect()
}

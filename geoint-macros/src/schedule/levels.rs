//! When a node can be computed, and how many numbers a level hands on.

use crate::ir::{Function, Graph, Id, Node, Symbol, Table};

/// The level of every node; constants have none.
pub(super) struct KnownLevels<F> {
    of_symbol: F,
    known: Table<Option<usize>>,
}

impl<F: Fn(Symbol) -> usize> KnownLevels<F> {
    pub(super) fn new(of_symbol: F) -> Self {
        KnownLevels { of_symbol, known: Table::default() }
    }

    pub(super) fn of(&mut self, graph: &Graph, id: Id) -> Option<usize> {
        if let Some(level) = self.known.get(id) {
            return level;
        }
        for id in graph.unknown(id, &self.known) {
            let level = match graph.node(id) {
                Node::Symbol(symbol) => Some((self.of_symbol)(*symbol)),
                Node::Number(_) | Node::Truth(_) => None,
                // What is made of constants but is not one, like 1/0, is known first.
                node => Some(node.children().iter().filter_map(|child| self.known[*child]).max().unwrap_or(0)),
            };
            self.known.insert(id, level);
        }
        self.known[id]
    }
}

/// How many numbers nodes are together: a matrix is more than one.
pub(super) fn width_of_slots(graph: &Graph, slots: &[Id]) -> usize {
    let width = |id: &Id| match graph.node(*id) {
        Node::Call(Function::FlowMatrix, args) => whole(graph, args[0]).pow(2),
        _ => 1,
    };
    slots.iter().map(width).sum()
}

/// A number that counts something.
pub(super) fn whole(graph: &Graph, id: Id) -> usize {
    graph.as_number(id).map_or(0, |number| number.to_f64() as usize)
}

//! The levels of nodes, and the numbers that a level stores for later levels.

use crate::ir::{Function, Graph, Id, Node, Symbol, Table};

/// The levels of nodes. Constants have none. Cached, filled on demand.
pub(super) struct KnownLevels<F> {
    of_symbol: F,
    known: Table<Option<usize>>,
}

impl<F: Fn(Symbol) -> usize> KnownLevels<F> {
    /// Returns the levels of nodes from the levels of symbols.
    pub(super) fn new(of_symbol: F) -> Self {
        KnownLevels { of_symbol, known: Table::default() }
    }

    /// Returns the level of a node: the latest level of its symbols.
    pub(super) fn of(&mut self, graph: &Graph, id: Id) -> Option<usize> {
        if let Some(level) = self.known.get(id) {
            return level;
        }
        for id in graph.unknown(id, &self.known) {
            let level = match graph.node(id) {
                Node::Symbol(symbol) => Some((self.of_symbol)(*symbol)),
                Node::Number(_) | Node::Truth(_) => None,
                // A node of constants may be left as it is, like 1/0. Its level is the first.
                node => {
                    let mut last = 0;
                    node.for_each_child(|child| last = self.known[child].map_or(last, |level| level.max(last)));
                    Some(last)
                }
            };
            self.known.insert(id, level);
        }
        self.known[id]
    }
}

/// The values of a level for later levels.
#[derive(Clone, Default)]
pub(super) struct Slots {
    pub(super) nodes: Vec<Id>,
    /// The first slot of each node.
    begins: Table<usize>,
    /// The number of slots. A matrix has several.
    pub(super) width: usize,
}

impl Slots {
    /// Returns the first slot of a node. Adds slots for a new node.
    pub(super) fn slot(&mut self, graph: &Graph, id: Id) -> usize {
        if let Some(begin) = self.begins.get(id) {
            return begin;
        }
        let begin = self.width;
        self.begins.insert(id, begin);
        self.nodes.push(id);
        self.width += match graph.node(id) {
            Node::Call(Function::FlowMatrix, args) => whole(graph, args[0]).pow(2),
            _ => 1,
        };
        begin
    }
}

/// Returns a constant node as a count.
pub(super) fn whole(graph: &Graph, id: Id) -> usize {
    graph.as_number(id).map_or(0, |number| number.to_f64() as usize)
}

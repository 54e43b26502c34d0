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

/// What a level stores for later ones.
#[derive(Clone, Default)]
pub(super) struct Slots {
    pub(super) nodes: Vec<Id>,
    /// Where each of them begins.
    begins: Table<usize>,
    /// How many numbers they are together: a matrix is more than one.
    pub(super) width: usize,
}

impl Slots {
    /// Where a node is, which gets a slot if it has none.
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

/// A number that counts something.
pub(super) fn whole(graph: &Graph, id: Id) -> usize {
    graph.as_number(id).map_or(0, |number| number.to_f64() as usize)
}

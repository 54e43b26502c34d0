//! The forward derivative with respect to one symbol: columns of Hessians and of Newton's matrices.

use super::rules::{Rule, rule};
use crate::ir::{Graph, Id, Node, Symbol, Table};

/// ∂/∂symbol, shared between all nodes it is applied to.
pub(crate) struct Forward {
    symbol: Symbol,
    done: Table<Id>,
}

impl Forward {
    pub(crate) fn new(symbol: Symbol) -> Self {
        Forward { symbol, done: Table::default() }
    }

    /// The derivative of `root`.
    pub(crate) fn of(&mut self, graph: &mut Graph, root: Id) -> Id {
        let zero = graph.zero();
        for id in graph.unknown(root, &self.done) {
            let derivative = match graph.node(id) {
                Node::Symbol(symbol) if *symbol == self.symbol => graph.integer(1),
                node if node.children().iter().all(|child| self.done[*child] == zero) => zero,
                _ => match rule(graph, id) {
                    Rule::Chain(partials) => {
                        let parts: Vec<Id> = partials
                            .into_iter()
                            .filter(|(operand, _)| self.done[*operand] != zero)
                            .map(|(operand, partial)| graph.mul(partial, self.done[operand]))
                            .collect();
                        graph.sum(&parts)
                    }
                    Rule::Branch(condition, first, second) => {
                        graph.select(condition, self.done[first], self.done[second])
                    }
                },
            };
            self.done.insert(id, derivative);
        }
        self.done[root]
    }
}

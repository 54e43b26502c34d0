//! Replaces symbols by expressions.

use super::graph::Graph;
use super::id::Id;
use super::node::Node;
use super::symbol::Symbol;
use super::table::Table;

/// A replacement of symbols with a cache of rebuilt nodes.
pub(crate) struct Substitution<F> {
    replace: F,
    done: Table<Id>,
}

impl<F: Fn(&mut Graph, Symbol) -> Option<Id>> Substitution<F> {
    /// Creates a substitution. `replace` returns the expression for a symbol, or `None` to keep it.
    pub(crate) fn new(replace: F) -> Self {
        Substitution { replace, done: Table::default() }
    }

    /// Returns the nodes below `root` that are not rebuilt yet, operands first.
    pub(crate) fn unknown(&self, graph: &Graph, root: Id) -> Vec<Id> {
        graph.unknown(root, &self.done)
    }

    /// Sets the replacement of a whole node.
    pub(crate) fn insert(&mut self, id: Id, replacement: Id) {
        self.done.insert(id, replacement);
    }

    /// Rebuilds `root` with all replacements.
    pub(crate) fn apply(&mut self, graph: &mut Graph, root: Id) -> Id {
        for id in graph.unknown(root, &self.done) {
            let new = |id: &Id| self.done[*id];
            let mut same = !matches!(graph.node(id), Node::Symbol(_));
            graph.node(id).for_each_child(|child| same &= new(&child) == child);
            if same {
                self.done.insert(id, id);
                continue;
            }
            let node = graph.node(id).clone();
            let rebuilt = match &node {
                Node::Symbol(symbol) => (self.replace)(graph, *symbol).unwrap_or(id),
                Node::Number(_) | Node::Truth(_) => id,
                Node::Linear(constant, terms) => {
                    let mut sum = graph.number(*constant);
                    for (c, term) in terms {
                        let term = graph.scale(*c, new(term));
                        sum = graph.add(sum, term);
                    }
                    sum
                }
                Node::Product(ids) => graph.product(&ids.iter().map(new).collect::<Vec<_>>()),
                Node::Power(base, exponent) => graph.pow(new(base), *exponent),
                Node::Call(function, args) => graph.call(*function, &args.iter().map(new).collect::<Vec<_>>()),
                Node::Select(c, a, b) => graph.select(new(c), new(a), new(b)),
                Node::Compare(relation, a, b) => graph.compare(*relation, new(a), new(b)),
                Node::And(a, b) => graph.and(new(a), new(b)),
                Node::Or(a, b) => graph.or(new(a), new(b)),
                Node::Not(a) => graph.not(new(a)),
            };
            self.done.insert(id, rebuilt);
        }
        self.done[root]
    }
}

/// Returns a node with one symbol replaced.
pub(crate) fn replaced(graph: &mut Graph, id: Id, symbol: Symbol, value: Id) -> Id {
    Substitution::new(|_: &mut Graph, other| (other == symbol).then_some(value)).apply(graph, id)
}

/// Returns a node with zero in place of the symbols that `vanishes` selects.
pub(crate) fn at_zero(graph: &mut Graph, id: Id, vanishes: impl Fn(Symbol) -> bool) -> Id {
    Substitution::new(|graph: &mut Graph, symbol| vanishes(symbol).then(|| graph.zero())).apply(graph, id)
}

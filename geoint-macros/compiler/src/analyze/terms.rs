//! Splits a sum into its terms.

use crate::ir::{Graph, Id, Node, Number, Reads};

/// scale · Π factors. All factors but the last are free of q and p.
#[derive(Clone, Debug)]
pub(super) struct Term {
    pub(super) scale: Number,
    pub(super) factors: Vec<Id>,
}

impl Term {
    /// Builds the node of the term.
    pub(super) fn build(&self, graph: &mut Graph) -> Id {
        let product = graph.product(&self.factors);
        graph.scale(self.scale, product)
    }

    /// Returns the factor that reads q or p. `None` for a constant.
    pub(super) fn moving_factor(&self, graph: &Graph) -> Option<Id> {
        self.factors.last().copied().filter(|last| graph.reads(*last).state())
    }
}

/// Splits sums with a limited number of splits.
pub(super) struct Sums<'a> {
    graph: &'a Graph,
    /// The number of sums that may still be split. Nested sums with shared operands have exponentially many terms, so the rest stays whole.
    left: usize,
}

impl<'a> Sums<'a> {
    /// Creates a splitter for the sums of a graph.
    pub(super) fn new(graph: &'a Graph) -> Self {
        Sums { graph, left: graph.len() }
    }

    /// Returns the terms of `root` and of nested sums, constants included. A sum with factors that are free of q and p is split as well, if `splits`
    /// accepts the kinds of coordinates that the sum reads.
    pub(super) fn terms(&mut self, root: Id, splits: impl Fn(Reads) -> bool) -> Vec<Term> {
        let mut terms = vec![];
        let mut open = vec![(Number::ONE, vec![], root)];
        while let Some((scale, mut factors, id)) = open.pop() {
            match self.graph.node(id) {
                Node::Number(value) => terms.push(Term { scale: scale.mul(*value), factors }),
                Node::Linear(constant, inner) if self.left > 0 => {
                    self.left -= 1;
                    if !constant.is_zero() {
                        terms.push(Term { scale: scale.mul(*constant), factors: factors.clone() });
                    }
                    open.extend(inner.iter().rev().map(|(c, id)| (scale.mul(*c), factors.clone(), *id)));
                }
                node => {
                    let (state, free): (Vec<Id>, Vec<Id>) = match node {
                        Node::Product(ids) => ids.iter().partition(|id| self.graph.reads(**id).state()),
                        _ => (vec![], vec![]),
                    };
                    match state[..] {
                        [sum] if splits(self.graph.reads(sum)) => open.push((scale, [factors, free].concat(), sum)),
                        _ => {
                            factors.push(id);
                            terms.push(Term { scale, factors });
                        }
                    }
                }
            }
        }
        terms
    }
}

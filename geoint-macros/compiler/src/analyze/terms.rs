//! A sum as its terms.

use crate::ir::{Graph, Id, Node, Number, Reads};

/// scale · Π factors; all but the last are free of q and p.
#[derive(Clone, Debug)]
pub(super) struct Term {
    pub(super) scale: Number,
    pub(super) factors: Vec<Id>,
}

impl Term {
    pub(super) fn build(&self, graph: &mut Graph) -> Id {
        let product = graph.product(&self.factors);
        graph.scale(self.scale, product)
    }
}

/// Takes sums apart.
pub(super) struct Sums<'a> {
    graph: &'a Graph,
    /// Sums of sums that share sums would have terms without end: when so many were taken apart the rest stays whole.
    left: usize,
}

impl<'a> Sums<'a> {
    pub(super) fn new(graph: &'a Graph) -> Self {
        Sums { graph, left: graph.len() }
    }

    /// The terms of `root`, those of nested sums included, constants too. A sum with factors that are free of q and p is
    /// taken apart as well if it reads what `apart` asks for.
    pub(super) fn terms(&mut self, root: Id, apart: impl Fn(Reads) -> bool) -> Vec<Term> {
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
                    let (state, free) = self.factors(node);
                    match state[..] {
                        [sum] if apart(self.graph.reads(sum)) => open.push((scale, [factors, free].concat(), sum)),
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

    /// The factors of a product that read q or p, and the others.
    fn factors(&self, node: &Node) -> (Vec<Id>, Vec<Id>) {
        match node {
            Node::Product(ids) => ids.iter().partition(|id| self.graph.reads(**id).state()),
            _ => (vec![], vec![]),
        }
    }
}

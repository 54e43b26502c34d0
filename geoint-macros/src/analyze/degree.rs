//! The degree of nodes as polynomials in some of their symbols.

use crate::ir::{Graph, Id, Node, Symbol};

/// The degree of every node of a graph.
pub(crate) struct Degrees(Vec<Option<u32>>);

impl Degrees {
    /// The degrees in the symbols that `counts` picks.
    pub(crate) fn of(graph: &Graph, counts: impl Fn(Symbol) -> bool) -> Degrees {
        let mut degrees: Vec<Option<u32>> = Vec::with_capacity(graph.len());
        for id in graph.ids() {
            let of = |id: &Id| degrees[id.index()];
            let degree = match graph.node(id) {
                Node::Symbol(symbol) => Some(u32::from(counts(*symbol))),
                Node::Linear(_, terms) => terms.iter().try_fold(0, |max, (_, id)| Some(of(id)?.max(max))),
                Node::Product(ids) => ids.iter().try_fold(0_u32, |sum, id| sum.checked_add(of(id)?)),
                Node::Power(base, exponent) => match of(base) {
                    Some(0) => Some(0),
                    Some(n) if exponent.is_integer() => {
                        u32::try_from(exponent.numerator).ok().and_then(|exponent| n.checked_mul(exponent))
                    }
                    _ => None,
                },
                // Anything else is of degree 0 if it does not read the symbols at all.
                node => {
                    let mut free = true;
                    node.for_each_child(|child| free &= of(&child) == Some(0));
                    free.then_some(0)
                }
            };
            degrees.push(degree);
        }
        Degrees(degrees)
    }

    /// The degree; `None` if the node is not a polynomial.
    pub(crate) fn get(&self, id: Id) -> Option<u32> {
        self.0[id.index()]
    }
}

//! The degrees of nodes as polynomials in selected symbols.

use crate::ir::{Graph, Id, Node, Symbol, Table};

/// The degrees of some nodes and of all their operands.
pub(crate) struct Degrees(Table<Option<u32>>);

impl Degrees {
    /// Computes the degrees in the symbols that `counts` selects.
    pub(crate) fn of(graph: &Graph, roots: &[Id], counts: impl Fn(Symbol) -> bool) -> Degrees {
        let mut degrees = Degrees(Table::default());
        for id in graph.reachable(roots) {
            let degree = match graph.node(id) {
                Node::Symbol(symbol) => Some(u32::from(counts(*symbol))),
                Node::Linear(_, terms) => terms.iter().try_fold(0, |max, (_, id)| Some(degrees.get(*id)?.max(max))),
                Node::Product(ids) => ids.iter().try_fold(0_u32, |sum, id| sum.checked_add(degrees.get(*id)?)),
                Node::Power(base, exponent) => match degrees.get(*base) {
                    Some(0) => Some(0),
                    Some(n) if exponent.is_integer() => {
                        u32::try_from(exponent.numerator).ok().and_then(|exponent| n.checked_mul(exponent))
                    }
                    _ => None,
                },
                // Any other node has degree 0 if it reads none of the symbols.
                node => {
                    let mut free = true;
                    node.for_each_child(|child| free &= degrees.get(child) == Some(0));
                    free.then_some(0)
                }
            };
            degrees.0.insert(id, degree);
        }
        degrees
    }

    /// Returns the degree of a node. `None` if the node is not a polynomial.
    pub(crate) fn get(&self, id: Id) -> Option<u32> {
        self.0[id]
    }

    /// Returns whether a node is a polynomial of a degree up to `most`.
    pub(crate) fn at_most(&self, id: Id, most: u32) -> bool {
        self.get(id).is_some_and(|degree| degree <= most)
    }
}

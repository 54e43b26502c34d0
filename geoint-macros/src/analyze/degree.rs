//! The degree of a node as a polynomial in some of its symbols.

use crate::ir::{Graph, Id, Node, Symbol};

/// The degree in the symbols that `counts` picks; `None` if the node is not a polynomial in them.
pub(super) fn degree(graph: &Graph, root: Id, counts: impl Fn(Symbol) -> bool) -> Option<u32> {
    let mut degrees: Vec<Option<u32>> = vec![None; graph.len()];
    for id in graph.reachable(&[root]) {
        let of = |id: &Id| degrees[id.index()];
        degrees[id.index()] = match graph.node(id) {
            Node::Symbol(symbol) => Some(u32::from(counts(*symbol))),
            Node::Linear(_, terms) => terms.iter().try_fold(0, |max, (_, id)| Some(of(id)?.max(max))),
            Node::Product(ids) => ids.iter().try_fold(0, |sum, id| Some(of(id)? + sum)),
            Node::Power(base, exponent) => match of(base) {
                Some(0) => Some(0),
                Some(n) if exponent.is_integer() && exponent.numerator > 0 => Some(n * exponent.numerator as u32),
                _ => None,
            },
            // Anything else is of degree 0 if it does not read the symbols at all.
            node => node.children().iter().all(|id| of(id) == Some(0)).then_some(0),
        };
    }
    degrees[root.index()]
}

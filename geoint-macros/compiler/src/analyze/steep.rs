//! Are functions steep in a coordinate that has become small?

use super::terms::Sums;
use crate::ir::{Graph, Id, Node, Symbol};

/// Whether functions may change by more than they are rounded where a coordinate is rounded as large as it is at the other end of a step. A sum of powers of
/// single coordinates does not: xᵢ ∂f/∂xᵢ is a multiple of its term, and largest where xᵢ is.
///
/// `gradients` are those of the functions, one after the other, with respect to the coordinates `x`.
pub(crate) fn is_steep(graph: &Graph, gradients: &[Id], x: &[Symbol]) -> bool {
    let mut slopes = gradients.chunks(x.len()).flat_map(|gradient| gradient.iter().zip(x));
    !slopes.all(|(slope, x)| is_power(graph, *slope, *x))
}

/// Whether a node is c or c xⁿ, with n > 0 and c free of coordinates.
fn is_power(graph: &Graph, id: Id, x: Symbol) -> bool {
    let reads_state = |id: &Id| graph.reads(*id).state();
    let terms: Vec<Vec<Id>> = Sums::new(graph).terms(id, |_| true).into_iter().map(|term| term.factors).collect();
    let [factors] = &terms[..] else { return !terms.iter().flatten().any(reads_state) };
    let single = |id: &Id| match graph.node(*id) {
        Node::Product(ids) => ids.to_vec(),
        _ => vec![*id],
    };
    let moving: Vec<Id> = factors.iter().flat_map(single).filter(reads_state).collect();
    match moving[..] {
        [] => true,
        [factor] => match graph.node(factor) {
            Node::Symbol(symbol) => *symbol == x,
            Node::Power(base, n) => *graph.node(*base) == Node::Symbol(x) && n.is_integer() && n.numerator > 0,
            _ => false,
        },
        _ => false,
    }
}

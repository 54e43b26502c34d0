//! Detects functions that are steep in a coordinate that becomes small during a step.

use super::terms::Sums;
use crate::ir::{Graph, Id, Node, Symbol};

/// Returns whether a function may change by more than its rounding error within the rounding error of a coordinate at the other end of a step. Sums
/// of powers of single coordinates are not steep: xᵢ ∂f/∂xᵢ is a multiple of its term, and largest where xᵢ is largest.
///
/// `gradients` lists the derivatives of each function in the order of the coordinates `x`, one function after the other.
pub(crate) fn is_steep(graph: &Graph, gradients: &[Id], x: &[Symbol]) -> bool {
    !gradients.iter().zip(x.iter().cycle()).all(|(slope, x)| is_power(graph, *slope, *x))
}

/// Returns whether a node is c or c xⁿ, with n > 0 and c free of coordinates.
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

//! Is a Lagrangian a sum of squares of velocities? Then its mass matrix has no negative direction, wherever it is.

use super::degree::Degrees;
use super::dependence::{Reads, symbols};
use crate::ir::{Graph, Id, Node, Ratio, Symbol};

/// The parameters, and functions of them, that must not be negative for ∂²L/∂v² to be positive semidefinite at every state; `None` if L is
/// not seen to be a sum of squares of what is affine in v, and of what is affine in v itself.
pub(crate) fn weights_of_squares(graph: &Graph, lagrangian: Id) -> Option<Vec<Id>> {
    let degrees = Degrees::of(graph, |symbol| matches!(symbol, Symbol::V(_)));
    let mut weights = vec![];
    is_sum(graph, &degrees, lagrangian, &mut weights).then_some(weights)
}

fn is_sum(graph: &Graph, degrees: &Degrees, id: Id, weights: &mut Vec<Id>) -> bool {
    let affine = |id: Id| degrees.get(id).is_some_and(|degree| degree <= 1);
    if affine(id) {
        return true;
    }
    match graph.node(id).clone() {
        Node::Linear(_, terms) => terms
            .into_iter()
            .all(|(c, term)| affine(term) || (!c.is_negative() && is_sum(graph, degrees, term, weights))),
        Node::Product(factors) => {
            let (still, moving): (Vec<Id>, Vec<Id>) =
                factors.into_iter().partition(|factor| degrees.get(*factor) == Some(0));
            still.into_iter().all(|factor| is_weight(graph, factor, weights))
                && moving.len() == 1
                && is_sum(graph, degrees, moving[0], weights)
        }
        Node::Power(base, exponent) => exponent == Ratio::integer(2) && affine(base),
        _ => false,
    }
}

/// Whether a factor without velocities is never negative, or is a function of parameters whose sign can be looked at.
fn is_weight(graph: &Graph, factor: Id, weights: &mut Vec<Id>) -> bool {
    if let Node::Power(_, exponent) = graph.node(factor)
        && exponent.is_integer()
        && exponent.numerator % 2 == 0
    {
        return true;
    }
    let reads = symbols(graph, factor).into_iter().fold(Reads::default(), |all, symbol| all.or(Reads::of(symbol)));
    let still = !reads.state() && !reads.t;
    if still && !weights.contains(&factor) {
        weights.push(factor);
    }
    still
}

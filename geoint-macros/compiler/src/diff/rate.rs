//! The derivative of a function along the solutions of a field.

use super::forward::jacobian;
use crate::ir::{Graph, Id, Symbol};

/// The terms of f·∇I + ∂I/∂t − b·∇I.
pub(crate) fn derivative_along(
    graph: &mut Graph,
    x: &[Symbol],
    field: &[Id],
    integral: Id,
    but: Option<&[Id]>,
) -> Vec<Id> {
    let all: Vec<Symbol> = x.iter().copied().chain([Symbol::Time]).collect();
    let gradient = jacobian(graph, &[integral], &all).remove(0);
    let mut terms: Vec<Id> = field.iter().zip(&gradient).map(|(f, slope)| graph.mul(*f, *slope)).collect();
    terms.extend(gradient.last());
    for (b, slope) in but.into_iter().flatten().zip(&gradient) {
        let product = graph.mul(*b, *slope);
        terms.push(graph.neg(product));
    }
    terms
}

//! H = T(p, t) + V(q, t)? The parts, or the term that couples.

use super::degree;
use super::dependence::Dependence;
use crate::ir::{Graph, Id, Node, Symbol};

/// The kinetic and the potential part, or a term that reads both q and p.
pub(super) fn split(graph: &mut Graph, energy: Id) -> Result<(Id, Id), Id> {
    let mut terms = vec![];
    additive_terms(graph, energy, &mut terms);
    let dependence = Dependence::of(graph);
    if let Some(coupled) = terms.iter().find(|id| dependence.reads(**id).q && dependence.reads(**id).p) {
        return Err(*coupled);
    }
    let (kinetic, potential): (Vec<Id>, Vec<Id>) = terms.into_iter().partition(|id| dependence.reads(*id).p);
    Ok((graph.sum(&kinetic), graph.sum(&potential)))
}

/// The terms of a sum, nested sums and sums with a common factor free of q and p included.
fn additive_terms(graph: &mut Graph, id: Id, terms: &mut Vec<Id>) {
    match graph.node(id).clone() {
        Node::Linear(constant, inner) => {
            if !constant.is_zero() {
                terms.push(graph.number(constant));
            }
            for (c, term) in inner {
                let mut parts = vec![];
                additive_terms(graph, term, &mut parts);
                terms.extend(parts.into_iter().map(|part| graph.scale(c, part)));
            }
        }
        Node::Product(factors) => {
            let dependence = Dependence::of(graph);
            let (state, free): (Vec<Id>, Vec<Id>) =
                factors.into_iter().partition(|factor| dependence.reads(*factor).state());
            match state[..] {
                [sum] if dependence.reads(sum).q && dependence.reads(sum).p => {
                    let factor = graph.product(&free);
                    let mut parts = vec![];
                    additive_terms(graph, sum, &mut parts);
                    terms.extend(parts.into_iter().map(|part| graph.mul(factor, part)));
                }
                _ => terms.push(id),
            }
        }
        _ => terms.push(id),
    }
}

/// A term of the kinetic part that is not a polynomial of degree 2 at most in p with constant coefficients.
pub(super) fn not_quadratic(graph: &mut Graph, kinetic: Id) -> Option<Id> {
    let mut terms = vec![];
    additive_terms(graph, kinetic, &mut terms);
    let dependence = Dependence::of(graph);
    terms.into_iter().find(|term| {
        let degree = degree::degree(graph, *term, |symbol| matches!(symbol, Symbol::P(_)));
        dependence.reads(*term).t || degree.is_none_or(|degree| degree > 2)
    })
}

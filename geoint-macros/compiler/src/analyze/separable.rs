//! H = T(p, t) + V(q, t)? The parts, or the term that couples.

use super::degree::Degrees;
use super::terms::Sums;
use crate::ir::{Graph, Id, Reads, Symbol};

/// The kinetic and the potential part, or a term that reads both q and p.
pub(super) fn split(graph: &mut Graph, energy: Id) -> Result<(Id, Id), Id> {
    let terms = terms(graph, energy);
    if let Some(coupled) = terms.iter().find(|id| couples(graph.reads(**id))) {
        return Err(*coupled);
    }
    let (kinetic, potential): (Vec<Id>, Vec<Id>) = terms.into_iter().partition(|id| graph.reads(*id).p);
    Ok((graph.sum(&kinetic), graph.sum(&potential)))
}

fn couples(reads: Reads) -> bool {
    reads.q && reads.p
}

/// The terms of a sum; one with a common factor is taken apart only where it couples.
fn terms(graph: &mut Graph, root: Id) -> Vec<Id> {
    let terms = Sums::new(graph).terms(root, couples);
    terms.into_iter().map(|term| term.build(graph)).collect()
}

/// A term that is not a polynomial of degree 1 at most in p.
pub(crate) fn not_affine(graph: &mut Graph, energy: Id) -> Option<Id> {
    let terms = terms(graph, energy);
    let degrees = Degrees::of(graph, &terms, |symbol| matches!(symbol, Symbol::Momentum(_)));
    terms.into_iter().find(|term| degrees.get(*term).is_none_or(|degree| degree > 1))
}

/// A term of the kinetic part that is not a polynomial of degree 2 at most in p with constant coefficients.
pub(crate) fn not_quadratic(graph: &mut Graph, kinetic: Id) -> Option<Id> {
    let terms = terms(graph, kinetic);
    let degrees = Degrees::of(graph, &terms, |symbol| matches!(symbol, Symbol::Momentum(_)));
    terms.into_iter().find(|term| graph.reads(*term).t || degrees.get(*term).is_none_or(|degree| degree > 2))
}

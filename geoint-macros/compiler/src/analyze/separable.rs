//! Splits H = T(p, t) + V(q, t), or finds the term that couples q and p.

use super::degree::Degrees;
use super::terms_where;
use crate::ir::{Graph, Id, Symbol};

/// The two parts of a separable energy.
pub(super) struct Separated {
    pub(super) kinetic: Id,
    pub(super) potential: Id,
}

/// Returns the kinetic and the potential part. Errors: a term that reads both q and p.
pub(super) fn split(graph: &mut Graph, energy: Id) -> Result<Separated, Id> {
    let terms = terms(graph, energy);
    let couples = |id: &&Id| graph.reads(**id).q && graph.reads(**id).p;
    if let Some(coupled) = terms.iter().find(couples) {
        return Err(*coupled);
    }
    let (kinetic, potential): (Vec<Id>, Vec<Id>) = terms.into_iter().partition(|id| graph.reads(*id).p);
    Ok(Separated { kinetic: graph.sum(&kinetic), potential: graph.sum(&potential) })
}

/// Returns the terms of a sum. A sum with a factor is split only if it couples q and p.
fn terms(graph: &mut Graph, root: Id) -> Vec<Id> {
    terms_where(graph, root, |reads| reads.q && reads.p)
}

/// Returns a term that is not a polynomial in p of degree at most 1.
pub(crate) fn not_affine(graph: &mut Graph, energy: Id) -> Option<Id> {
    let terms = terms(graph, energy);
    let degrees = Degrees::of(graph, &terms, is_momentum);
    terms.into_iter().find(|term| !degrees.at_most(*term, 1))
}

/// Returns a term of the kinetic part that is not a polynomial in p of degree at most 2 with constant coefficients.
pub(crate) fn not_quadratic(graph: &mut Graph, kinetic: Id) -> Option<Id> {
    let terms = terms(graph, kinetic);
    let degrees = Degrees::of(graph, &terms, is_momentum);
    terms.into_iter().find(|term| graph.reads(*term).t || !degrees.at_most(*term, 2))
}

/// Returns whether a symbol is a momentum.
pub(super) fn is_momentum(symbol: Symbol) -> bool {
    matches!(symbol, Symbol::Momentum(_))
}

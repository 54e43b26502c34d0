//! The quadratic terms of an energy. Their motion is linear, so as one piece they have no splitting error, however fast the motion is.

use super::families::piece;
use super::flow::Space;
use super::polynomial::{Polynomial, degree, is_whole, times_powers};
use crate::analyze;
use crate::ir::{Graph, Id, Ratio, Symbol};

/// Quadratic terms with a known flow.
pub(super) struct LinearMotion {
    pub(super) terms: Vec<Id>,
    pub(super) energy: Id,
}

/// Returns the quadratic terms if some of them couple positions and momenta. If their flow is not known, tries the terms that read momenta.
pub(super) fn linear_motion(graph: &mut Graph, terms: &[Id], space: Space) -> Option<LinearMotion> {
    let mut taken: Vec<Id> = terms.iter().copied().filter(|term| is_of_degree(graph, *term, 2)).collect();
    if !taken.iter().any(|term| graph.reads(*term).kinds() > 1) {
        return None;
    }
    for _ in 0..2 {
        let energy = graph.sum(&taken);
        if piece(graph, energy, space).is_some() {
            return Some(LinearMotion { terms: taken, energy });
        }
        taken.retain(|term| graph.reads(*term).p);
    }
    None
}

/// Returns linear motion and the rest of the energy, if expanding a power of a coupling sum exposes quadratic terms, as in (p − bx − cx²)².
/// Linear terms join the linear motion if its flow is known with them.
pub(super) fn hidden_linear_motion(graph: &mut Graph, energy: Id, space: Space) -> Option<[Id; 2]> {
    let (mut hidden, mut terms) = (false, vec![]);
    for term in analyze::terms(graph, energy) {
        let coupling = graph.reads(term).kinds() > 1 && !is_of_degree(graph, term, 2);
        match coupling.then(|| monomials(graph, term)).flatten() {
            Some(parts) if parts.iter().any(|part| is_of_degree(graph, *part, 2)) => {
                hidden = true;
                terms.extend(parts);
            }
            _ => terms.push(term),
        }
    }
    // Constant terms move nothing and belong to no piece.
    terms.retain(|term| graph.reads(*term).state());
    let quadratic = linear_motion(graph, &terms, space).filter(|_| hidden)?;
    terms.retain(|term| !quadratic.terms.contains(term));
    let (linear, bent): (Vec<Id>, Vec<Id>) = terms.iter().partition(|term| is_of_degree(graph, **term, 1));
    let with_linear = graph.sum(&[&[quadratic.energy], &linear[..]].concat());
    let [motion, rest] = if piece(graph, with_linear, space).is_some() {
        [with_linear, graph.sum(&bent)]
    } else {
        [quadratic.energy, graph.sum(&terms)]
    };
    (!graph.is_zero(rest)).then_some([motion, rest])
}

/// Returns whether a term is a homogeneous polynomial of degree n in the coordinates.
pub(super) fn is_of_degree(graph: &mut Graph, term: Id, n: i128) -> bool {
    let Some(powers) = Polynomial::of(graph, term, &Symbol::is_coordinate) else { return false };
    powers.has_only(|monomial| is_whole(monomial) && degree(monomial) == Some(Ratio::integer(n)))
}

/// Expands a polynomial in the coordinates. Returns `None` if it has only one term, or exponents other than positive integers.
pub(super) fn monomials(graph: &mut Graph, term: Id) -> Option<Vec<Id>> {
    let powers = Polynomial::of(graph, term, &Symbol::is_coordinate)?;
    if powers.single().is_some() || !powers.has_only(is_whole) {
        return None;
    }
    Some(powers.into_terms().map(|(monomial, coefficient)| times_powers(graph, coefficient, &monomial)).collect())
}

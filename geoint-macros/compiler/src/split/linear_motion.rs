//! The quadratic terms of an energy: their motion is linear, and without an error if they stay together, however fast it is.

use super::families::piece;
use super::flow::Space;
use super::polynomial::{Monomial, Polynomial, degree, times_powers};
use crate::analyze;
use crate::ir::{Graph, Id, Ratio, Symbol};

/// The quadratic terms if some of them couple, and their sum; those of positions alone are left out where only without them its flow is
/// known.
pub(super) fn linear_motion(graph: &mut Graph, terms: &[Id], space: Space) -> Option<(Vec<Id>, Id)> {
    let mut taken: Vec<Id> = terms.iter().copied().filter(|term| is_quadratic(graph, *term)).collect();
    if !taken.iter().any(|term| graph.reads(*term).kinds() > 1) {
        return None;
    }
    for _ in 0..2 {
        let together = graph.sum(&taken);
        if piece(graph, together, space).is_some() {
            return Some((taken, together));
        }
        taken.retain(|term| graph.reads(*term).p);
    }
    None
}

/// Linear motion and the rest, if some of the former is within powers of sums that couple, as in (p − bx − cx²)²; with the linear terms where
/// its flow is known with these.
pub(super) fn hidden_linear_motion(graph: &mut Graph, energy: Id, space: Space) -> Option<[Id; 2]> {
    let (mut hidden, mut terms) = (false, vec![]);
    for term in analyze::terms(graph, energy) {
        let coupling = graph.reads(term).kinds() > 1 && !is_quadratic(graph, term);
        match coupling.then(|| monomials(graph, term)).flatten() {
            Some(parts) if parts.iter().any(|part| is_quadratic(graph, *part)) => {
                hidden = true;
                terms.extend(parts);
            }
            _ => terms.push(term),
        }
    }
    // What moves nothing is in no piece.
    terms.retain(|term| graph.reads(*term).state());
    let (taken, together) = linear_motion(graph, &terms, space).filter(|_| hidden)?;
    terms.retain(|term| !taken.contains(term));
    let (linear, bent): (Vec<Id>, Vec<Id>) = terms.iter().partition(|term| is_of_degree(graph, **term, 1));
    let pushed = graph.sum(&[&[together], &linear[..]].concat());
    let [all, rest] =
        if piece(graph, pushed, space).is_some() { [pushed, graph.sum(&bent)] } else { [together, graph.sum(&terms)] };
    (!graph.is_zero(rest)).then_some([all, rest])
}

/// Whether a term is of degree 2 in the coordinates.
pub(super) fn is_quadratic(graph: &mut Graph, term: Id) -> bool {
    is_of_degree(graph, term, 2)
}

fn is_of_degree(graph: &mut Graph, term: Id, n: i128) -> bool {
    let Some(powers) = Polynomial::of(graph, term, &Symbol::is_coordinate) else { return false };
    powers.has_only(|monomial| is_whole(monomial) && degree(monomial.values().copied()) == Some(Ratio::integer(n)))
}

/// Whether no exponent is negative or a fraction.
pub(super) fn is_whole(monomial: &Monomial) -> bool {
    monomial.values().all(|power| power.is_integer() && power.numerator > 0)
}

/// The terms of a product of sums of powers.
pub(super) fn monomials(graph: &mut Graph, term: Id) -> Option<Vec<Id>> {
    let powers = Polynomial::of(graph, term, &Symbol::is_coordinate)?;
    if powers.single().is_some() || !powers.has_only(is_whole) {
        return None;
    }
    Some(powers.into_terms().map(|(monomial, coefficient)| times_powers(graph, coefficient, &monomial)).collect())
}

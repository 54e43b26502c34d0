//! Is a field that of an energy, and of which one?
//!
//! q' = ∂H/∂p, p' = −∂H/∂q has a solution H on a simply connected domain if and only if the matrix of second derivatives that it asks
//! for is symmetric. In the plane that is div f = 0 (J. Liouville); with more degrees of freedom it is more. H is put together from
//! antiderivatives of terms, and what is put together is checked. Time and parameters are constants here.

mod primitives;

use super::multiplied::Sums;
use super::{Identity, Proof, identity, sum_is_zero};
use crate::diff;
use crate::ir::{Graph, Id, Symbol};
pub(crate) use primitives::Logarithm;
use primitives::{By, antiderivative_of_term};

/// Why there is no energy.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NoEnergy {
    /// ∂²H/∂x∂y would not be ∂²H/∂y∂x: what is known of the difference.
    NotCanonical([Symbol; 2], Identity),
    /// The field is proven to have an energy, but this term has no antiderivative that is known here; or the field is too long.
    NotElementary(Option<Id>, Proof),
    /// The field is proven to have this energy, of which some terms stay integrals.
    Integrals(Open),
}

/// An energy some terms of which have no antiderivative that is known here.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Open {
    /// The other terms, if there are any.
    pub(crate) elementary: Option<Id>,
    /// Of what is to be integrated over which variable: it reads no other one, so that the energy is the sum.
    pub(crate) integrals: Vec<(Id, Symbol)>,
    pub(crate) proof: Proof,
}

/// So many products of two terms for multiplying out what is integrated.
const PRODUCTS: usize = 2_000;

/// H with q' = ∂H/∂p and p' = −∂H/∂q, where `field` has q' and then p', and how that was proven; without a constant.
pub(crate) fn energy(
    graph: &mut Graph,
    (q, p): (&[Symbol], &[Symbol]),
    field: &[Id],
    logarithm: Logarithm,
) -> Result<(Id, Proof), NoEnergy> {
    // In the order in which is integrated: p first.
    let variables = [p, q].concat();
    let (by_p, by_q) = field.split_at(q.len());
    let mut slopes = by_p.to_vec();
    for component in by_q {
        slopes.push(graph.neg(*component));
    }
    antiderivative(graph, (&variables, &slopes), logarithm)
}

/// F with ∂F/∂x = `slopes` for all variables x, and how that was proven; without a constant.
pub(crate) fn antiderivative(
    graph: &mut Graph,
    (variables, slopes): (&[Symbol], &[Id]),
    logarithm: Logarithm,
) -> Result<(Id, Proof), NoEnergy> {
    let second = diff::jacobian(graph, slopes, variables);
    let mut proof = Proof::Multiplied;
    for i in 0..variables.len() {
        for j in 0..i {
            let back = graph.neg(second[j][i]);
            match sum_is_zero(graph, &[second[i][j], back]) {
                Identity::Zero(how) => proof = proof.weaker(how),
                verdict => return Err(NoEnergy::NotCanonical([variables[j], variables[i]], verdict)),
            }
        }
    }
    let (mut energy, mut integrals) = (graph.zero(), vec![]);
    for (i, (variable, slope)) in variables.iter().zip(slopes).enumerate() {
        let known = diff::jacobian(graph, &[energy], &[*variable])[0][0];
        let rest = graph.sub(*slope, known);
        if identity(graph, rest).is_zero() {
            continue;
        }
        // As it is written, or multiplied out. What is left reads no variable of before: where terms still do they cancel, and their
        // antiderivatives, of which each has a constant of its own, need not.
        let mut written = crate::analyze::terms(graph, rest);
        if written.iter().any(|term| variables[..i].iter().any(|before| graph.symbols(*term).contains(before)))
            && let Some(sums) = Sums::of(graph, &[rest], PRODUCTS)
        {
            written = sums.terms(graph, 0);
        }
        let (mut integral, mut open) = sum_of_antiderivatives(graph, &written, (*variable, logarithm));
        if let Some(term) = open.first() {
            let unknown = |term| NoEnergy::NotElementary(Some(term), proof);
            let sums = Sums::of(graph, &[rest], PRODUCTS).ok_or(unknown(*term))?;
            let terms = sums.terms(graph, 0);
            (integral, open) = sum_of_antiderivatives(graph, &terms, (*variable, logarithm));
            let others =
                |term: Id| variables.iter().any(|other| other != variable && graph.symbols(term).contains(other));
            if let Some(term) = open.iter().find(|term| others(**term)) {
                return Err(unknown(*term));
            }
        }
        energy = graph.add(energy, integral);
        integrals.extend(open.into_iter().map(|term| (term, *variable)));
    }
    let found = diff::jacobian(graph, &[energy], variables).remove(0);
    let mut exact = Proof::Multiplied;
    for ((found, slope), variable) in found.iter().zip(slopes).zip(variables) {
        let back = graph.neg(*slope);
        let open = integrals.iter().filter(|(_, over)| over == variable).map(|(term, _)| *term);
        let sum: Vec<Id> = [*found, back].into_iter().chain(open).collect();
        match sum_is_zero(graph, &sum) {
            Identity::Zero(how) => exact = exact.weaker(how),
            _ => return Err(NoEnergy::NotElementary(None, proof)),
        }
    }
    if integrals.is_empty() {
        return Ok((energy, exact));
    }
    let elementary = (energy != graph.zero()).then_some(energy);
    Err(NoEnergy::Integrals(Open { elementary, integrals, proof: exact }))
}

/// ∫ Σ terms dx of the terms that have an antiderivative here, and the others.
fn sum_of_antiderivatives(graph: &mut Graph, terms: &[Id], by: By) -> (Id, Vec<Id>) {
    let (mut known, mut open) = (vec![], vec![]);
    for term in terms {
        match antiderivative_of_term(graph, *term, by) {
            Some(integral) => known.push(integral),
            None => open.push(*term),
        }
    }
    (graph.sum(&known), open)
}

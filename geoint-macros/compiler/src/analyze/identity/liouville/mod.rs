//! Recovers the energy of a field, if it has one.
//!
//! On a simply connected domain, q' = ∂H/∂p, p' = −∂H/∂q has a solution H if and only if the matrix of the required second derivatives is
//! symmetric. In the plane this condition is div f = 0 (J. Liouville). With more degrees of freedom it is stronger. H is a sum of
//! antiderivatives of terms, and its derivatives are checked against the field. Time and parameters are constants here.

mod primitives;

use super::multiplied::Sums;
use super::{Identity, Proof, derivative, identity, sum_is_zero};
use crate::diff;
use crate::ir::{Graph, Id, Symbol};
pub(crate) use primitives::Logarithm;
use primitives::{Integration, antiderivative_of_term};

/// The reason why no energy is returned.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NoEnergy {
    /// ∂²H/∂x∂y = ∂²H/∂y∂x was not proven for these two variables. The identity is the verdict on the difference.
    NotCanonical([Symbol; 2], Identity),
    /// The field is proven to have an energy, but it was not found: this term has no antiderivative here, or the field is too long.
    NotElementary(Option<Id>, Proof),
    /// The field is proven to have an energy. Some terms of the energy stay integrals.
    Integrals(Open),
}

/// An energy with terms that have no antiderivative here.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Open {
    /// The sum of the other terms, if there are any.
    pub(crate) elementary: Option<Id>,
    /// Integrands, each with the variable of its integral. An integrand reads no other variable, so the energy is the sum of the integrals.
    pub(crate) integrals: Vec<(Id, Symbol)>,
    pub(crate) proof: Proof,
}

/// The largest number of products of two terms that are formed to multiply out an integrand.
const PRODUCTS: usize = 2_000;

/// Returns H with q' = ∂H/∂p and p' = −∂H/∂q, and its proof. `field` is (q', p'). H has no constant term.
pub(crate) fn energy(
    graph: &mut Graph,
    q: &[Symbol],
    p: &[Symbol],
    field: &[Id],
    logarithm: Logarithm,
) -> Result<(Id, Proof), NoEnergy> {
    let (velocities, forces) = field.split_at(q.len());
    let mut slopes = velocities.to_vec();
    slopes.extend(forces.iter().map(|force| graph.neg(*force)));
    antiderivative(graph, &[p, q].concat(), &slopes, logarithm)
}

/// Returns F with ∂F/∂x = slope for all variables x, and its proof. F has no constant term.
pub(crate) fn antiderivative(
    graph: &mut Graph,
    variables: &[Symbol],
    slopes: &[Id],
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
        let known = derivative(graph, energy, *variable);
        let rest = graph.sub(*slope, known);
        if identity(graph, rest).is_zero() {
            continue;
        }
        // The sum does not depend on earlier variables, but its terms may. The antiderivatives of terms that cancel need not cancel, because each
        // has its own constant. Multiplying out removes these terms.
        let mut terms = crate::analyze::terms(graph, rest);
        if terms.iter().any(|term| variables[..i].iter().any(|earlier| graph.symbols(*term).contains(earlier)))
            && let Some(sums) = Sums::of(graph, &[rest], PRODUCTS)
        {
            terms = sums.terms(graph, rest);
        }
        let integration = Integration { variable: *variable, logarithm };
        let mut found = sum_of_antiderivatives(graph, &terms, integration);
        if let Some(term) = found.open.first() {
            let unknown = |term| NoEnergy::NotElementary(Some(term), proof);
            let sums = Sums::of(graph, &[rest], PRODUCTS).ok_or(unknown(*term))?;
            let terms = sums.terms(graph, rest);
            found = sum_of_antiderivatives(graph, &terms, integration);
            let reads_others =
                |term: &&Id| variables.iter().any(|other| other != variable && graph.symbols(**term).contains(other));
            if let Some(term) = found.open.iter().find(reads_others) {
                return Err(unknown(*term));
            }
        }
        energy = graph.add(energy, found.sum);
        integrals.extend(found.open.into_iter().map(|term| (term, *variable)));
    }
    let gradient = diff::jacobian(graph, &[energy], variables).remove(0);
    let mut exact = Proof::Multiplied;
    for ((found, slope), variable) in gradient.iter().zip(slopes).zip(variables) {
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

/// The integral of a sum, term by term.
struct TermByTerm {
    /// The sum of the antiderivatives that were found.
    sum: Id,
    /// The other terms.
    open: Vec<Id>,
}

fn sum_of_antiderivatives(graph: &mut Graph, terms: &[Id], integration: Integration) -> TermByTerm {
    let (mut known, mut open) = (vec![], vec![]);
    for term in terms {
        match antiderivative_of_term(graph, *term, integration) {
            Some(integral) => known.push(integral),
            None => open.push(*term),
        }
    }
    TermByTerm { sum: graph.sum(&known), open }
}

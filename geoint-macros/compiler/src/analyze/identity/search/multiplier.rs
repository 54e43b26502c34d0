//! Jacobi's last multiplier as a product of powers: μ = Πxᵢ^aᵢ with div(μf) = 0, which is linear in a.
//!
//! In the plane μf = (∂H/∂y, −∂H/∂x) for some H, which is a first integral. C. G. J. Jacobi, J. reine angew. Math. 27 (1844) 199.

use super::super::multiplied::{Atom, Sums};
use super::{PRODUCTS, Vanishing};
use crate::diff;
use crate::ir::{Graph, Id, Ratio, Symbol};

/// The exponents a, if there are numbers with Σ (∂fᵢ/∂xᵢ + aᵢ fᵢ/xᵢ) = 0 for all parameters.
pub(crate) fn multiplier(graph: &mut Graph, x: &[Symbol], field: &[Id]) -> Option<Vec<Ratio>> {
    let slopes = diff::jacobian(graph, field, x);
    let terms: Vec<Id> = (0..x.len()).map(|i| slopes[i][i]).collect();
    let divergence = graph.sum(&terms);
    let coordinates: Vec<Id> = x.iter().map(|symbol| graph.symbol(*symbol)).collect();
    let mut sums = Sums::of(graph, &[&[divergence], field].concat(), PRODUCTS)?;
    let atoms: Vec<Atom> = coordinates.iter().map(|id| sums.atom_of_symbol(*id)).collect();
    // The unknown 0 is the factor of the divergence. The others are the exponents.
    let mut equations = Vanishing::default();
    equations.add(0, 0, sums.normal(divergence))?;
    for (i, (f, atom)) in field.iter().zip(atoms).enumerate() {
        equations.add(0, i + 1, &sums.normal(*f).times(&vec![(atom, Ratio::integer(-1))])?)?;
    }
    // If the factor of the divergence is free, it is the first entry of a solution, and 1.
    let solution = equations.solutions(x.len() + 1)?.into_iter().find(|solution| solution.contains_key(&0))?;
    Some((1..=x.len()).map(|i| solution.get(&i).copied().unwrap_or(Ratio::ZERO)).collect())
}

//! Jacobi's last multiplier as a product of powers: μ = Πxᵢ^aᵢ with div(μf) = 0, which is linear in a.
//!
//! In the plane μf = (∂H/∂y, −∂H/∂x) with some H, which is a first integral. C. G. J. Jacobi, J. reine angew. Math. 27 (1844) 199.

use super::super::multiplied::{Atom, Powers, Sums};
use super::{PRODUCTS, times};
use crate::analyze::equations::{Equations, Row};
use crate::diff;
use crate::ir::{Graph, Id, Ratio, Symbol};
use std::collections::BTreeMap;

/// The exponents a, if there are numbers that do: Σ (∂fᵢ/∂xᵢ + aᵢ fᵢ/xᵢ) = 0 for all parameters.
pub(crate) fn multiplier(graph: &mut Graph, x: &[Symbol], field: &[Id]) -> Option<Vec<Ratio>> {
    let slopes = diff::jacobian(graph, field, x);
    let terms: Vec<Id> = (0..x.len()).map(|i| slopes[i][i]).collect();
    let divergence = graph.sum(&terms);
    let coordinates: Vec<Id> = x.iter().map(|symbol| graph.symbol(*symbol)).collect();
    let mut sums = Sums::of(graph, &[&[divergence], field].concat(), PRODUCTS)?;
    let atoms: Vec<Atom> = coordinates.iter().map(|id| sums.symbol(*id)).collect();
    // The unknown 0 is the factor of the divergence.
    let mut rows: BTreeMap<Powers, Row> = BTreeMap::new();
    for (i, sum) in sums.sums.iter().enumerate() {
        let sum = if i == 0 { sum.clone() } else { times(sum, atoms[i - 1], -1)? };
        for (powers, coefficient) in sum.terms() {
            rows.entry(powers.clone()).or_default().insert(i, coefficient);
        }
    }
    let mut equations = Equations::new(x.len() + 1);
    for row in rows.into_values() {
        equations.add(row)?;
    }
    // If the factor of the divergence is free, it is the first entry of a solution, and 1.
    let solution = equations.solutions()?.into_iter().find(|solution| solution.contains_key(&0))?;
    Some((1..=x.len()).map(|i| solution.get(&i).copied().unwrap_or(Ratio::ZERO)).collect())
}

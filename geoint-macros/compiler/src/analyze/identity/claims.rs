//! Properties of a field, its integrals and its structure matrix, each stated as an identity.

use super::residues::{self, Dependent};
use super::surface::sum_is_zero_along;
use super::{Identity, sum_is_zero};
use crate::diff;
use crate::ir::{Graph, Id, Node, Number, Symbol};

/// Decides f·∇I + ∂I/∂t − b·∇I = 0 for the field f, the integral I, and the part b = `but` of the field that may change I.
pub(crate) fn is_kept(graph: &mut Graph, x: &[Symbol], field: &[Id], integral: Id, but: Option<&[Id]>) -> Identity {
    let terms = diff::derivative_along(graph, x, field, integral, but);
    let verdict = sum_is_zero_along(graph, &terms, x, field);
    let (unit, function) = in_units(graph, integral);
    if verdict.is_zero() || unit.is_one() {
        return verdict;
    }
    let terms = diff::derivative_along(graph, x, field, function, but);
    let mut of_function = sum_is_zero_along(graph, &terms, x, field);
    of_function.scale(graph, unit);
    // The division rounds the other coefficients once more. A single coefficient becomes 1.
    let is_single_term = graph.coefficient(integral).1 != integral;
    if of_function.is_zero() || is_single_term { of_function } else { verdict }
}

/// Returns the first coefficient of a function as its unit, and the function divided by it. The unit is 1 unless the coefficient is not exact, as
/// 10²⁰⁰. Numbers that are not exact would be unknowns when the function is multiplied out.
pub(crate) fn in_units(graph: &mut Graph, function: Id) -> (Number, Id) {
    let first = match graph.node(function) {
        Node::Linear(_, terms) => terms.first().map(|(coefficient, _)| *coefficient),
        _ => None,
    };
    match first {
        Some(unit @ Number::Float(_)) if unit.to_f64().recip().is_normal() => {
            (unit, graph.scale(Number::float(unit.to_f64().recip()), function))
        }
        _ => (Number::ONE, function),
    }
}

/// Decides S + Sᵀ = 0 along a field. Error: the first indices i ≤ j that fail, with the verdict on S_ij + S_ji.
pub(crate) fn is_skew(
    graph: &mut Graph,
    x: &[Symbol],
    matrix: &[Vec<Id>],
    field: &[Id],
) -> Result<(), ([usize; 2], Identity)> {
    let n = matrix.len();
    let pairs = (0..n).flat_map(|i| (i..n).map(move |j| [i, j]));
    first(pairs, |[i, j]| sum_is_zero_along(graph, &[matrix[i][j], matrix[j][i]], x, field))
}

/// Decides S∇I − f = 0. Error: the first component that fails.
pub(crate) fn is_gradient_form(
    graph: &mut Graph,
    x: &[Symbol],
    matrix: &[Vec<Id>],
    integral: Id,
    field: &[Id],
) -> Result<(), (usize, Identity)> {
    let gradient = diff::jacobian(graph, &[integral], x).remove(0);
    first(0..x.len(), |i| {
        let mut terms = product_terms(graph, &matrix[i], &gradient);
        terms.push(graph.neg(field[i]));
        sum_is_zero_along(graph, &terms, x, field)
    })
}

/// Decides S∇C = 0. Error: the first component that fails.
pub(crate) fn is_casimir(
    graph: &mut Graph,
    x: &[Symbol],
    matrix: &[Vec<Id>],
    casimir: Id,
) -> Result<(), (usize, Identity)> {
    let gradient = diff::jacobian(graph, &[casimir], x).remove(0);
    first(0..x.len(), |i| {
        let terms = product_terms(graph, &matrix[i], &gradient);
        sum_is_zero(graph, &terms)
    })
}

/// Decides Jacobi's identity Σ S_il ∂_l S_jk + cyclic = 0 of a skew matrix along a field. Error: the first indices i < j < k that fail.
pub(crate) fn is_poisson(
    graph: &mut Graph,
    x: &[Symbol],
    matrix: &[Vec<Id>],
    field: &[Id],
) -> Result<(), ([usize; 3], Identity)> {
    let n = x.len();
    let entries: Vec<Id> = matrix.concat();
    // The gradient of S_ij is row i·n + j.
    let gradients = diff::jacobian(graph, &entries, x);
    let triples = (0..n).flat_map(|i| (i + 1..n).flat_map(move |j| (j + 1..n).map(move |k| [i, j, k])));
    first(triples, |[i, j, k]| {
        let cycle = [[i, j, k], [j, k, i], [k, i, j]];
        let terms: Vec<Id> =
            cycle.iter().flat_map(|[i, j, k]| product_terms(graph, &matrix[*i], &gradients[j * n + k])).collect();
        sum_is_zero_along(graph, &terms, x, field)
    })
}

/// The divergence Σ ∂f_i/∂x_i, and whether it is zero along the field.
pub(crate) fn divergence(graph: &mut Graph, x: &[Symbol], field: &[Id]) -> (Id, Identity) {
    let slopes = diff::jacobian(graph, field, x);
    let terms: Vec<Id> = (0..x.len()).map(|i| slopes[i][i]).collect();
    (graph.sum(&terms), sum_is_zero_along(graph, &terms, x, field))
}

/// Decides div(ρf)/ρ = div f + f·∇ρ/ρ = 0 for the field f and the density ρ, which is not zero everywhere.
pub(crate) fn is_density(graph: &mut Graph, x: &[Symbol], field: &[Id], density: Id) -> Identity {
    let slopes = diff::jacobian(graph, field, x);
    let mut terms: Vec<Id> = (0..x.len()).map(|i| slopes[i][i]).collect();
    for change in diff::derivative_along(graph, x, field, density, None) {
        terms.push(graph.div(change, density));
    }
    sum_is_zero_along(graph, &terms, x, field)
}

/// Returns the integrals that are functions of earlier ones, by their gradients. `None` if this cannot be decided.
pub(crate) fn dependent(graph: &mut Graph, x: &[Symbol], integrals: &[Id]) -> Option<Dependent> {
    let gradients = diff::jacobian(graph, integrals, x);
    residues::dependent(graph, &gradients)
}

/// The products a_i·b_i.
fn product_terms(graph: &mut Graph, a: &[Id], b: &[Id]) -> Vec<Id> {
    a.iter().zip(b).map(|(a, b)| graph.mul(*a, *b)).collect()
}

/// Decides identities by index, up to the first one that is not proven.
fn first<I: Copy>(
    indices: impl Iterator<Item = I>,
    mut identity: impl FnMut(I) -> Identity,
) -> Result<(), (I, Identity)> {
    for index in indices {
        let verdict = identity(index);
        if !verdict.is_zero() {
            return Err((index, verdict));
        }
    }
    Ok(())
}

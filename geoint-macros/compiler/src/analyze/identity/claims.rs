//! What is asked of a field, of its integrals and of its structure matrix, each as an identity.

use super::residues::{self};
use super::surface::sum_is_zero_along;
use super::{Bound, Identity, sum_is_zero};
use crate::diff;
use crate::ir::{Graph, Id, Node, Number, Symbol};

/// f·∇I + ∂I/∂t − b·∇I = 0: whether `integral` is constant along `field`, but for what `but` adds to its derivative.
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
    // In a sum with other coefficients these are rounded once more.
    let alone = graph.coefficient(integral).1 != integral;
    if of_function.is_zero() || alone { of_function } else { verdict }
}

/// A function over its first coefficient, and that, if it is no ratio of integers, as 10²⁰⁰ is none: such numbers are unknowns when a sum is
/// multiplied out.
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

/// S + Sᵀ = 0 along a field: the first entry (i, j), i ≤ j, that fails, with the verdict on S_ij + S_ji.
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

/// S∇I − f = 0: the first component that fails.
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

/// S∇C = 0: the first component that fails.
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

/// Jacobi's identity Σ S_il ∂_l S_jk + cyclic = 0 of a skew matrix along a field: the first indices i < j < k that fail.
pub(crate) fn is_poisson(
    graph: &mut Graph,
    x: &[Symbol],
    matrix: &[Vec<Id>],
    field: &[Id],
) -> Result<(), ([usize; 3], Identity)> {
    let n = x.len();
    let entries: Vec<Id> = matrix.concat();
    // ∂_l S_ij is in row i·n + j, column l.
    let slopes = diff::jacobian(graph, &entries, x);
    let triples = (0..n).flat_map(|i| (i + 1..n).flat_map(move |j| (j + 1..n).map(move |k| [i, j, k])));
    first(triples, |[i, j, k]| {
        let cycle = [[i, j, k], [j, k, i], [k, i, j]];
        let terms: Vec<Id> =
            cycle.iter().flat_map(|[i, j, k]| product_terms(graph, &matrix[*i], &slopes[j * n + k])).collect();
        sum_is_zero_along(graph, &terms, x, field)
    })
}

/// Σ ∂f_i/∂x_i, and whether it is zero.
pub(crate) fn divergence(graph: &mut Graph, x: &[Symbol], field: &[Id]) -> (Id, Identity) {
    let slopes = diff::jacobian(graph, field, x);
    let terms: Vec<Id> = (0..x.len()).map(|i| slopes[i][i]).collect();
    (graph.sum(&terms), sum_is_zero_along(graph, &terms, x, field))
}

/// Which integrals are functions of those before them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Dependent {
    pub(crate) integrals: Vec<usize>,
    pub(crate) bound: Bound,
}

/// The integrals whose gradients depend on those of earlier ones at every state; `None` if that cannot be decided.
pub(crate) fn dependent(graph: &mut Graph, x: &[Symbol], integrals: &[Id]) -> Option<Dependent> {
    let gradients = diff::jacobian(graph, integrals, x);
    let rank = residues::rank(graph, &gradients)?;
    Some(Dependent { integrals: rank.dependent, bound: rank.bound })
}

/// The products a_i·b_i.
fn product_terms(graph: &mut Graph, a: &[Id], b: &[Id]) -> Vec<Id> {
    let products = a.iter().zip(b).map(|(a, b)| graph.mul(*a, *b));
    products.collect()
}

/// The first index for which an identity is not proven.
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

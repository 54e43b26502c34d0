//! Decides whether the mean of ∇H along the line between two states has a closed form.

use super::degree::Degrees;
use super::leaves::leaves;
use super::quadratic::{Expansion, Quadratic, UNIT};
use super::terms::Sums;
use crate::ir::{Graph, Id, Symbol};

/// The exact method for the mean of ∇H.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MeanValue {
    /// Gauss quadrature with this number of points, for a polynomial H.
    Gauss(u32),
    /// Extrapolation of the tree discrete gradients over the line in 1, 2, … up to this number of parts. H is a sum of ridge functions φ(l) with
    /// affine l and of a polynomial. One part gives the tree discrete gradient.
    Parts(u32),
    /// No closed form is known because of this term.
    NotClosed(Id),
}

/// Returns the number of Gauss points that integrate ∇ of a polynomial of this degree. The tree discrete gradient is a polynomial of the degree of ∇
/// in both ends and even in their distance, so the extrapolation needs the same number of parts.
fn points(degree: u32) -> u32 {
    degree.div_ceil(2)
}

/// Finds the exact method for the mean of ∇H.
pub(super) fn mean_value(graph: &Graph, degrees: &Degrees, energy: Id) -> MeanValue {
    let mut parts = 1;
    for term in Sums::new(graph).terms(energy, |_| true) {
        let Some(factor) = term.moving_factor(graph) else { continue };
        let needed = match degrees.get(factor) {
            Some(0..=2) => 1,
            _ if is_ridge(graph, degrees, factor) => 1,
            Some(degree) => points(degree),
            None => return MeanValue::NotClosed(factor),
        };
        parts = parts.max(needed);
    }
    match degrees.get(energy) {
        // Gauss points cost less than parts.
        Some(degree) if parts > 1 && points(degree) == parts => MeanValue::Gauss(parts),
        _ => MeanValue::Parts(parts),
    }
}

/// Returns whether a node reads the state through one affine function.
fn is_ridge(graph: &Graph, degrees: &Degrees, root: Id) -> bool {
    if graph.symbols(root).into_iter().filter(|symbol: &Symbol| symbol.is_canonical()).count() == 1 {
        return true;
    }
    let directions = || {
        let leaves = leaves(graph, degrees, root, 1)?;
        let mut expansion = Expansion::new(graph, degrees);
        leaves.iter().map(|leaf| direction(expansion.leaf(leaf)?)).collect::<Option<Vec<Quadratic>>>()
    };
    directions().is_some_and(|directions| directions.windows(2).all(|pair| pair[0] == pair[1]))
}

/// Returns the gradient of an affine function in normal form: without the constant, sorted, and with the first number scaled to 1.
fn direction(mut form: Quadratic) -> Option<Quadratic> {
    form.retain(|monomial| monomial.variables[0] != UNIT);
    form.sort_by(|a, b| (a.variables, &a.atoms).cmp(&(b.variables, &b.atoms)));
    let reciprocal = form.first()?.number.recip()?;
    for monomial in &mut form {
        monomial.number = monomial.number.mul(reciprocal)?;
    }
    Some(form)
}

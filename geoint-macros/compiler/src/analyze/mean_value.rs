//! Is the mean of ∇H along the line between two states known in closed form?

use super::degree::Degrees;
use super::leaves::leaves;
use super::quadratic::{Expansion, Quadratic, UNIT};
use super::terms::Sums;
use crate::ir::{Graph, Id, Symbol};

/// How to have the mean of ∇H exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MeanValue {
    /// By so many points of Gauss: H is a polynomial.
    Gauss(u32),
    /// By extrapolation of the tree discrete gradients over the parts of a line in 1, 2, … so many: H is a sum of ridge
    /// functions φ(l) with affine l, and of a polynomial. With 1 it is the tree discrete gradient.
    Parts(u32),
    /// Not known to be closed, because of this term.
    NotClosed(Id),
}

/// ∇ of a polynomial of this degree is one of degree less by one, for which Gauss needs so many points. The tree discrete
/// gradient is one of that degree in both ends, and even in their distance: as many numbers of parts determine its limit.
fn points(degree: u32) -> u32 {
    degree.div_ceil(2)
}

pub(super) fn mean_value(graph: &Graph, degrees: &Degrees, energy: Id) -> MeanValue {
    let mut parts = 1;
    for term in Sums::new(graph).terms(energy, |_| true) {
        let Some(last) = term.factors.last().copied().filter(|last| graph.reads(*last).state()) else { continue };
        let needed = match degrees.get(last) {
            Some(0..=2) => 1,
            _ if is_ridge(graph, degrees, last) => 1,
            Some(degree) => points(degree),
            None => return MeanValue::NotClosed(last),
        };
        parts = parts.max(needed);
    }
    match degrees.get(energy) {
        // A point of Gauss costs less than the parts.
        Some(degree) if parts > 1 && points(degree) == parts => MeanValue::Gauss(parts),
        _ => MeanValue::Parts(parts),
    }
}

/// Whether a node reads the state through one affine function of it.
fn is_ridge(graph: &Graph, degrees: &Degrees, root: Id) -> bool {
    let state = |symbol: &Symbol| matches!(symbol, Symbol::Position(_) | Symbol::Momentum(_));
    if graph.symbols(root).iter().filter(|symbol| state(symbol)).count() == 1 {
        return true;
    }
    let directions = || {
        let leaves = leaves(graph, degrees, root, 1)?;
        let mut expansion = Expansion::new(graph, degrees);
        leaves.iter().map(|leaf| direction(expansion.leaf(leaf)?)).collect::<Option<Vec<Quadratic>>>()
    };
    directions().is_some_and(|directions| directions.windows(2).all(|pair| pair[0] == pair[1]))
}

/// An affine function but for its constant and a factor.
fn direction(mut form: Quadratic) -> Option<Quadratic> {
    form.retain(|monomial| monomial.variables[0] != UNIT);
    form.sort_by(|a, b| (a.variables, &a.atoms).cmp(&(b.variables, &b.atoms)));
    let reciprocal = form.first()?.number.recip()?;
    for monomial in &mut form {
        monomial.number = monomial.number.mul(reciprocal)?;
    }
    Some(form)
}

//! Is the mean of ∇H along the line between two states known in closed form?

use super::degree::Degrees;
use super::dependence::{Dependence, symbols};
use super::form::{Expansion, Form, UNIT};
use super::leaves::leaves;
use super::terms::{Sums, Term};
use crate::ir::{Graph, Id, Symbol};

/// How to have the mean of ∇H exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MeanValue {
    /// It is the tree discrete gradient: H is a sum of ridge functions φ(l) with affine l and of terms of degree 2.
    Tree,
    /// By Gauss quadrature with so many points: H is a polynomial.
    Gauss(u32),
    /// The tree's of the ridge functions (and terms of degree 2), and so many points of Gauss for the polynomial.
    Mixed { ridge: Id, polynomial: Id, points: u32 },
    /// Not known to be closed, because of this term.
    NotClosed(Id),
}

/// ∇ of a polynomial of this degree is one of degree less by one, for which Gauss needs so many points.
fn points(degree: u32) -> u32 {
    degree.div_ceil(2)
}

pub(super) fn mean_value(graph: &mut Graph, dependence: &Dependence, degrees: &Degrees, energy: Id) -> MeanValue {
    let (mut ridge, mut polynomial, mut highest) = (vec![], vec![], 0);
    for term in Sums::new(graph, dependence).terms(energy, |_| true) {
        let Some(last) = term.factors.last().copied().filter(|last| dependence.reads(*last).state()) else { continue };
        match degrees.get(last) {
            Some(degree) if degree <= 2 => ridge.push(term),
            _ if is_ridge(graph, dependence, degrees, last) => ridge.push(term),
            Some(degree) => {
                highest = highest.max(degree);
                polynomial.push(term);
            }
            None => return MeanValue::NotClosed(last),
        }
    }
    match (polynomial.is_empty(), degrees.get(energy)) {
        (true, _) => MeanValue::Tree,
        (_, Some(degree)) => MeanValue::Gauss(points(degree)),
        (_, None) => {
            let mut sum = |terms: Vec<Term>| {
                let terms: Vec<Id> = terms.iter().map(|term| term.build(graph)).collect();
                graph.sum(&terms)
            };
            MeanValue::Mixed { ridge: sum(ridge), polynomial: sum(polynomial), points: points(highest) }
        }
    }
}

/// Whether a node reads the state through one affine function of it.
fn is_ridge(graph: &Graph, dependence: &Dependence, degrees: &Degrees, root: Id) -> bool {
    let state = |symbol: &Symbol| matches!(symbol, Symbol::Q(_) | Symbol::P(_));
    if symbols(graph, root).iter().filter(|symbol| state(symbol)).count() == 1 {
        return true;
    }
    let directions = || {
        let leaves = leaves(graph, dependence, degrees, root, 1)?;
        let mut expansion = Expansion::new(graph, degrees);
        leaves.iter().map(|leaf| direction(expansion.leaf(leaf)?)).collect::<Option<Vec<Form>>>()
    };
    directions().is_some_and(|directions| directions.windows(2).all(|pair| pair[0] == pair[1]))
}

/// An affine function but for its constant and a factor.
fn direction(mut form: Form) -> Option<Form> {
    form.retain(|monomial| monomial.variables[0] != UNIT);
    form.sort_by(|a, b| (a.variables, &a.atoms).cmp(&(b.variables, &b.atoms)));
    let reciprocal = form.first()?.number.recip()?;
    for monomial in &mut form {
        monomial.number = monomial.number.mul(reciprocal)?;
    }
    Some(form)
}

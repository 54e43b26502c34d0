//! The divergence of a field. If it is zero, Liouville's theory decides whether the field has an elementary energy. If not, Jacobi's last multiplier is
//! searched for.

use super::coordinates;
use crate::analyze::crossings::{self, Discontinuity};
use crate::analyze::liouville::{self, Logarithm, NoEnergy};
use crate::analyze::{Identity, Proof, claims, search};
use crate::derive::checks::{Check, Sign, checks_of};
use crate::ir::{Graph, Id, Node, Symbol, UndefinedAt};

/// Facts that follow from the divergence of a field.
#[derive(Debug)]
pub(crate) struct Liouville {
    /// div f, and the result of its test for zero.
    pub(crate) divergence: (Id, Identity),
    /// H with q' = ∂H/∂p and p' = −∂H/∂q for the halves of x, or the reason why there is none. Absent for an odd number of coordinates.
    pub(crate) energy: Option<Result<Recovered, NoEnergy>>,
    /// Present only if div f is not zero.
    pub(crate) multiplier: Option<Multiplier>,
}

impl Liouville {
    /// Returns the energy, if steps may keep it.
    pub(crate) fn kept(&self) -> Option<Id> {
        match self.energy {
            Some(Ok(Recovered { energy, everywhere: true, jump: None, .. })) => Some(energy),
            _ => None,
        }
    }

    /// Returns the divergence, if it is proven not to be zero.
    pub(crate) fn divergent(&self) -> Option<Id> {
        matches!(self.divergence.1, Identity::Wrong(_)).then_some(self.divergence.0)
    }
}

/// An energy that was recovered from a field.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Recovered {
    pub(crate) energy: Id,
    pub(crate) proof: Proof,
    /// True if the energy is defined wherever the field is. Steps may then keep it.
    pub(crate) everywhere: bool,
    /// A place where the energy may jump along the field. The field does not show such jumps.
    pub(crate) jump: Option<Discontinuity>,
}

/// Jacobi's last multiplier: a function μ with div(μf) = 0.
#[derive(Debug)]
pub(crate) struct Multiplier {
    pub(crate) value: Id,
    /// In the plane, H with μf = (∂H/∂y, −∂H/∂x), if it is elementary.
    pub(crate) energy: Option<Id>,
}

/// Derives all facts from the divergence.
pub(crate) fn liouville(graph: &mut Graph, field: &[Id], partial: &[UndefinedAt]) -> Liouville {
    let x = coordinates(field.len());
    let divergence = claims::divergence(graph, &x, field);
    let (q, p) = x.split_at(x.len() / 2);
    let energy = x.len().is_multiple_of(2).then(|| {
        let mut of = |logarithm| liouville::energy(graph, q, p, field, logarithm);
        let (energy, proof) = match of(Logarithm::OfMagnitude) {
            // An energy may still exist in a part of the domain.
            Err(NoEnergy::NotElementary(term, proof)) => {
                of(Logarithm::OfNumber).map_err(|_| NoEnergy::NotElementary(term, proof))?
            }
            found => found?,
        };
        let everywhere = is_defined(graph, energy, field, partial);
        // The flow does not keep an energy that reads time.
        let steady = !graph.reads(energy).t;
        let jump = steady.then(|| crossings::may_jump(graph, &x, field, energy)).flatten();
        Ok(Recovered { energy, proof, everywhere, jump })
    });
    let multiplier = if divergence.1.is_zero() { None } else { multiplier(graph, &x, field) };
    Liouville { divergence, energy, multiplier }
}

/// Searches for a multiplier, and proves it.
fn multiplier(graph: &mut Graph, x: &[Symbol], field: &[Id]) -> Option<Multiplier> {
    let found = match search::multiplier(graph, x, field) {
        Some(exponents) => {
            let mut powers = vec![];
            for (symbol, exponent) in x.iter().zip(exponents) {
                let symbol = graph.symbol(*symbol);
                powers.push(graph.pow(symbol, exponent));
            }
            Some(graph.product(&powers))
        }
        None => of_separable_orbits(graph, x, field),
    };
    let value = found?;
    let scaled: Vec<Id> = field.iter().map(|f| graph.mul(value, *f)).collect();
    if !claims::divergence(graph, x, &scaled).1.is_zero() {
        return None;
    }
    let energy = match x {
        [x, y] => liouville::energy(graph, &[*x], &[*y], &scaled, Logarithm::OfNumber).ok().map(|(energy, _)| energy),
        _ => None,
    };
    Some(Multiplier { value, energy })
}

/// Returns 1/(A(x)D(y)) for a field x' = A(x)B(y), y' = C(x)D(y) in the plane. Its orbits are separable: dy/dx = C/A · D/B.
fn of_separable_orbits(graph: &mut Graph, x: &[Symbol], field: &[Id]) -> Option<Id> {
    let ([x, y], [first, second]) = (x, field) else { return None };
    let mut own = |component: Id, own: Symbol, other: Symbol| {
        let rest = graph.coefficient(component).1;
        let mut product = graph.integer(1);
        for (base, exponent) in graph.factors(rest) {
            let read = graph.symbols(base);
            match (read.contains(&own), read.contains(&other)) {
                (true, true) => return None,
                (true, false) => {
                    let factor = graph.pow(base, exponent.neg());
                    product = graph.mul(product, factor);
                }
                _ => {}
            }
        }
        Some(product)
    };
    // 1/A and 1/D.
    let (a, d) = (own(*first, *x, *y)?, own(*second, *y, *x)?);
    Some(graph.mul(a, d))
}

/// Returns whether a node is defined wherever a field is: the conditions of the field include all conditions of the node.
fn is_defined(graph: &mut Graph, node: Id, field: &[Id], partial: &[UndefinedAt]) -> bool {
    let mut tested: Vec<Id> =
        partial.iter().filter(|partial| partial.condition.is_none()).map(|partial| partial.node).collect();
    let computed = graph.reachable(field);
    if !computed.iter().any(|id| matches!(graph.node(*id), Node::Select(..))) {
        tested.extend(computed);
    }
    let tested = conditions(graph, &tested);
    let asked = graph.reachable(&[node]);
    conditions(graph, &asked).into_iter().all(|(argument, sign)| {
        let covers =
            |(other, tested): &(Id, Sign)| *other == argument && (*tested == sign || *tested == Sign::NotPositive);
        graph.is_positive(argument) || tested.iter().any(covers)
    })
}

/// Returns the forbidden signs of the arguments in some nodes. A square is positive where its base is not zero, so its base is the argument.
fn conditions(graph: &mut Graph, nodes: &[Id]) -> Vec<(Id, Sign)> {
    let checks: Vec<Check> = nodes.iter().flat_map(|id| checks_of(graph, *id)).collect();
    let condition = |check: &Check| match graph.node(check.argument) {
        Node::Power(base, exponent) if exponent.is_integer() && exponent.numerator % 2 == 0 => (*base, Sign::Zero),
        _ => (check.argument, check.forbidden),
    };
    checks.iter().map(condition).collect()
}

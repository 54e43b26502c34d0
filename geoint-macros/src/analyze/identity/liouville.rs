//! Is a field that of an energy, and of which one?
//!
//! q' = ∂H/∂p, p' = −∂H/∂q has a solution H on a simply connected domain if and only if the matrix of second derivatives that it asks
//! for is symmetric. In the plane that is div f = 0 (J. Liouville); with more degrees of freedom it is more. H is put together from
//! antiderivatives of terms, and what is put together is checked. Time and parameters are constants here.

use super::multiplied::Sums;
use super::{Identity, Proof, identity, sum_is_zero};
use crate::diff;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

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

/// What the antiderivative of 1/u is, where u is not known to be positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Logarithm {
    /// ln u, for positive u alone.
    OfNumber,
    /// ln|u| as ln(u²)/2, wherever 1/u is defined.
    OfMagnitude,
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

/// What is integrated over, and how reciprocals are.
type By = (Symbol, Logarithm);

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

/// ∫ term dx, if it is one of: a power, or a function of the table, of something times the derivative of that; or a power of x times an
/// exponential or a wave.
fn antiderivative_of_term(graph: &mut Graph, term: Id, by: By) -> Option<Id> {
    let x = by.0;
    let (coefficient, rest) = graph.coefficient(term);
    let mut constant = graph.number(coefficient);
    let mut factors = vec![];
    if graph.as_number(rest).is_none() {
        for (base, exponent) in graph.factors(rest) {
            if diff::jacobian(graph, &[base], &[x])[0][0] == graph.zero() {
                let factor = graph.pow(base, exponent);
                constant = graph.mul(constant, factor);
            } else {
                factors.push((base, exponent));
            }
        }
    } else {
        constant = term;
    }
    if factors.is_empty() {
        let x = graph.symbol(x);
        return Some(graph.mul(constant, x));
    }
    let integral = by_substitution(graph, &factors, by).or_else(|| by_parts(graph, &factors, by))?;
    Some(graph.mul(constant, integral))
}

fn product(graph: &mut Graph, factors: &[(Id, Ratio)]) -> Id {
    let powers: Vec<Id> = factors.iter().map(|(base, exponent)| graph.pow(*base, *exponent)).collect();
    graph.product(&powers)
}

/// ∫ c·φ(u) u' dx = c·Φ(u), where φ(u) is one of the factors and c does not read x.
fn by_substitution(graph: &mut Graph, factors: &[(Id, Ratio)], (x, logarithm): By) -> Option<Id> {
    for k in 0..factors.len() {
        let others: Vec<(Id, Ratio)> = (0..factors.len()).filter(|i| *i != k).map(|i| factors[i]).collect();
        let others = product(graph, &others);
        // As a function of its argument, or as a power.
        let candidates = [primitive_of_function(graph, factors[k]), primitive_of_power(graph, factors[k], logarithm)];
        for (inner, primitive) in candidates.into_iter().flatten() {
            let slope = diff::jacobian(graph, &[inner], &[x])[0][0];
            // Of one that is zero on a side of a condition there is no quotient.
            if graph.reachable(&[slope]).into_iter().any(|id| matches!(graph.node(id), Node::Select(..))) {
                continue;
            }
            let quotient = graph.div(others, slope);
            let change = diff::jacobian(graph, &[quotient], &[x])[0][0];
            if identity(graph, change).is_zero() {
                return Some(graph.mul(quotient, primitive));
            }
        }
    }
    None
}

/// ∫ xⁿφ(u) dx = xⁿΦ(u)/u' − n/u' ∫ xⁿ⁻¹Φ(u) dx, where u' does not read x.
fn by_parts(graph: &mut Graph, factors: &[(Id, Ratio)], by: By) -> Option<Id> {
    let x = by.0;
    let symbol = graph.symbol(x);
    let at = factors.iter().position(|(base, _)| *base == symbol)?;
    let [other] = factors.iter().enumerate().filter(|(i, _)| *i != at).map(|(_, f)| *f).collect::<Vec<_>>()[..] else {
        return None;
    };
    let n = factors[at].1.to_integer().filter(|n| (1..=8).contains(n))?;
    let Node::Call(Function::Exp | Function::Sin | Function::Cos | Function::Sinh | Function::Cosh, _) =
        graph.node(other.0)
    else {
        return None;
    };
    let (inner, primitive) = primitive_of_function(graph, other)?;
    let slope = diff::jacobian(graph, &[inner], &[x])[0][0];
    if diff::jacobian(graph, &[slope], &[x])[0][0] != graph.zero() {
        return None;
    }
    let primitive = graph.div(primitive, slope);
    let power = graph.pow(symbol, Ratio::integer(n.into()));
    let whole = graph.mul(power, primitive);
    let lower = graph.pow(symbol, Ratio::integer(i128::from(n) - 1));
    let lower = graph.mul(lower, primitive);
    let lower = graph.scale(Number::integer((-n).into()), lower);
    let rest = antiderivative_of_term(graph, lower, by)?;
    Some(graph.add(whole, rest))
}

/// For baseᵉ = φ(u) with a function φ of the table: u, and Φ(u) with Φ' = φ.
fn primitive_of_function(graph: &mut Graph, (base, exponent): (Id, Ratio)) -> Option<(Id, Id)> {
    let Node::Call(function, args) = graph.node(base).clone() else { return None };
    let u = args[0];
    let call = |graph: &mut Graph, function| graph.call(function, &[u]);
    let value = match function {
        // A power of an exponential is one.
        Function::Exp => {
            let power = graph.pow(base, exponent);
            graph.scale(Number::Exact(exponent.recip()?), power)
        }
        _ if exponent != Ratio::ONE => return None,
        Function::Sin => {
            let cosine = call(graph, Function::Cos);
            graph.neg(cosine)
        }
        Function::Cos => call(graph, Function::Sin),
        Function::Sinh => call(graph, Function::Cosh),
        Function::Cosh => call(graph, Function::Sinh),
        Function::Tanh => {
            let cosh = call(graph, Function::Cosh);
            graph.call(Function::Ln, &[cosh])
        }
        Function::Ln => {
            let product = graph.mul(u, base);
            graph.sub(product, u)
        }
        // u atan u − ln(1 + u²)/2.
        Function::Atan => {
            let product = graph.mul(u, base);
            let (one, square) = (graph.integer(1), graph.pow(u, Ratio::integer(2)));
            let sum = graph.add(one, square);
            let logarithm = graph.call(Function::Ln, &[sum]);
            let half = graph.scale(Number::HALF, logarithm);
            graph.sub(product, half)
        }
        _ => return None,
    };
    Some((u, value))
}

/// For uᵉ: u, and its antiderivative.
fn primitive_of_power(graph: &mut Graph, (base, exponent): (Id, Ratio), logarithm: Logarithm) -> Option<(Id, Id)> {
    let next = exponent.add(Ratio::ONE)?;
    let value = match next.recip() {
        Some(reciprocal) => {
            let power = graph.pow(base, next);
            graph.scale(Number::Exact(reciprocal), power)
        }
        None if logarithm == Logarithm::OfNumber || graph.is_positive(base) => graph.call(Function::Ln, &[base]),
        None => {
            let square = graph.pow(base, Ratio::integer(2));
            let logarithm = graph.call(Function::Ln, &[square]);
            graph.scale(Number::HALF, logarithm)
        }
    };
    Some((base, value))
}

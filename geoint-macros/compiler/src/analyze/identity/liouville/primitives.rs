//! Antiderivatives of terms.

use super::{derivative, identity};
use crate::ir::substitute::replaced;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// The antiderivative of 1/u, if u is not known to be positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Logarithm {
    /// ln u, for positive u only. Also allows atan y/x, the angle around a pole, for x ≠ 0 only.
    OfNumber,
    /// ln|u| as ln(u²)/2, wherever 1/u is defined.
    OfMagnitude,
}

/// The variable of an integral, and the antiderivatives that it may use.
#[derive(Clone, Copy)]
pub(super) struct Integration {
    pub(super) variable: Symbol,
    pub(super) logarithm: Logarithm,
}

/// ∫ term dx, if the term has one of these forms: φ(u) u' with a power or a known function φ; a power of x times an exponential or a sine; or
/// the reciprocal of a quadratic polynomial.
pub(super) fn antiderivative_of_term(graph: &mut Graph, term: Id, integration: Integration) -> Option<Id> {
    let x = integration.variable;
    let (coefficient, rest) = graph.coefficient(term);
    let mut constant = graph.number(coefficient);
    let mut factors = vec![];
    for (base, exponent) in graph.factors(rest) {
        if derivative(graph, base, x) == graph.zero() {
            let factor = graph.pow(base, exponent);
            constant = graph.mul(constant, factor);
        } else {
            factors.push((base, exponent));
        }
    }
    if factors.is_empty() {
        let x = graph.symbol(x);
        return Some(graph.mul(constant, x));
    }
    let integral = by_substitution(graph, &factors, integration)
        .or_else(|| by_parts(graph, &factors, integration))
        .or_else(|| of_an_angle(graph, &factors, integration))?;
    Some(graph.mul(constant, integral))
}

fn product(graph: &mut Graph, factors: &[(Id, Ratio)]) -> Id {
    let powers: Vec<Id> = factors.iter().map(|(base, exponent)| graph.pow(*base, *exponent)).collect();
    graph.product(&powers)
}

/// ∫ c·φ(u) u' dx = c·Φ(u), where φ(u) is one of the factors and c does not read x.
fn by_substitution(graph: &mut Graph, factors: &[(Id, Ratio)], integration: Integration) -> Option<Id> {
    for (k, (base, exponent)) in factors.iter().enumerate() {
        let others: Vec<(Id, Ratio)> = (0..factors.len()).filter(|i| *i != k).map(|i| factors[i]).collect();
        let others = product(graph, &others);
        let candidates = [
            primitive_of_function(graph, *base, *exponent),
            primitive_of_power(graph, *base, *exponent, integration.logarithm),
        ];
        for Primitive { inner, value } in candidates.into_iter().flatten() {
            let slope = derivative(graph, inner, integration.variable);
            // A slope with conditions may be zero on one side, so the quotient may be undefined.
            if graph.reachable(&[slope]).into_iter().any(|id| matches!(graph.node(id), Node::Select(..))) {
                continue;
            }
            let quotient = graph.div(others, slope);
            let change = derivative(graph, quotient, integration.variable);
            if identity(graph, change).is_zero() {
                return Some(graph.mul(quotient, value));
            }
        }
    }
    None
}

/// ∫ xⁿφ(u) dx = xⁿΦ(u)/u' − n/u' ∫ xⁿ⁻¹Φ(u) dx, where u' does not read x.
fn by_parts(graph: &mut Graph, factors: &[(Id, Ratio)], integration: Integration) -> Option<Id> {
    let x = graph.symbol(integration.variable);
    let (power, other) = match factors {
        [power, other] if power.0 == x => (power, other),
        [other, power] if power.0 == x => (power, other),
        _ => return None,
    };
    let n = power.1.to_i64().filter(|n| (1..=8).contains(n))?;
    let Node::Call(Function::Exp | Function::Sin | Function::Cos | Function::Sinh | Function::Cosh, _) =
        graph.node(other.0)
    else {
        return None;
    };
    let Primitive { inner, value } = primitive_of_function(graph, other.0, other.1)?;
    let slope = derivative(graph, inner, integration.variable);
    if derivative(graph, slope, integration.variable) != graph.zero() {
        return None;
    }
    let primitive = graph.div(value, slope);
    let power = graph.pow(x, Ratio::integer(n.into()));
    let whole = graph.mul(power, primitive);
    let lower = graph.pow(x, Ratio::integer(i128::from(n) - 1));
    let lower = graph.mul(lower, primitive);
    let lower = graph.scale(Number::integer((-n).into()), lower);
    let rest = antiderivative_of_term(graph, lower, integration)?;
    Some(graph.add(whole, rest))
}

/// ∫ dx/u = 2/w · atan(u'/w) with w² = 2uu'' − u'², where u has degree 2 in x, and w is not a root of an expression that may be negative.
fn of_an_angle(graph: &mut Graph, factors: &[(Id, Ratio)], integration: Integration) -> Option<Id> {
    let [(u, Ratio { numerator: -1, denominator: 1 })] = *factors else { return None };
    let x = integration.variable;
    let first = derivative(graph, u, x);
    let second = derivative(graph, first, x);
    let third = derivative(graph, second, x);
    if !identity(graph, third).is_zero() {
        return None;
    }
    // w does not depend on x. Its expression is simplest at x = 0.
    let zero = graph.zero();
    let [u, slope, bend] = [u, first, second].map(|node| replaced(graph, node, x, zero));
    let (product, square) = (graph.mul(u, bend), graph.pow(slope, Ratio::integer(2)));
    let twice = graph.scale(Number::integer(2), product);
    let discriminant = graph.sub(twice, square);
    let w = root(graph, discriminant, integration.logarithm)?;
    let tangent = graph.div(first, w);
    let angle = graph.call(Function::Atan, &[tangent]);
    let over = graph.div(angle, w);
    Some(graph.scale(Number::integer(2), over))
}

/// Returns w with w² = `square`, defined wherever `square` is. With [`Logarithm::OfMagnitude`] w is also nowhere zero.
fn root(graph: &mut Graph, square: Id, logarithm: Logarithm) -> Option<Id> {
    if graph.is_positive(square) {
        return Some(graph.sqrt(square));
    }
    let (coefficient, rest) = graph.coefficient(square);
    if logarithm == Logarithm::OfMagnitude || coefficient.is_negative() || graph.as_number(square).is_some() {
        return None;
    }
    let mut factors = vec![(graph.number(coefficient), Ratio::HALF)];
    for (base, exponent) in graph.factors(rest) {
        factors.push((base, exponent.to_i64().filter(|n| n % 2 == 0).map(|n| Ratio::integer((n / 2).into()))?));
    }
    Some(product(graph, &factors))
}

/// Φ(u) with Φ' = φ.
struct Primitive {
    /// u.
    inner: Id,
    /// Φ(u).
    value: Id,
}

/// The primitive for baseᵉ = φ(u), where φ is a function.
fn primitive_of_function(graph: &mut Graph, base: Id, exponent: Ratio) -> Option<Primitive> {
    let Node::Call(function, args) = graph.node(base).clone() else { return None };
    let u = args[0];
    let call = |graph: &mut Graph, function| graph.call(function, &[u]);
    let value = match function {
        // A power of an exponential is an exponential.
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
    Some(Primitive { inner: u, value })
}

/// The primitive for baseᵉ, where φ is the power and u the base.
fn primitive_of_power(graph: &mut Graph, base: Id, exponent: Ratio, logarithm: Logarithm) -> Option<Primitive> {
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
    Some(Primitive { inner: base, value })
}

//! Antiderivatives of terms.

use super::identity;
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// What the antiderivative of 1/u is, where u is not known to be positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Logarithm {
    /// ln u, for positive u alone; likewise atan y/x, the angle around a pole, for x that are not zero.
    OfNumber,
    /// ln|u| as ln(u²)/2, wherever 1/u is defined.
    OfMagnitude,
}

/// What is integrated over, and how reciprocals are.
pub(super) type By = (Symbol, Logarithm);

/// ∫ term dx, if it is one of: a power, or a function of the table, of something times the derivative of that; a power of x times an
/// exponential or a wave; or the slope of an angle, over a sum of squares.
pub(super) fn antiderivative_of_term(graph: &mut Graph, term: Id, by: By) -> Option<Id> {
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
    let integral = by_substitution(graph, &factors, by)
        .or_else(|| by_parts(graph, &factors, by))
        .or_else(|| of_an_angle(graph, &factors, by))?;
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

/// ∫ dx/u = 2/w · atan(u'/w) with w² = 2uu'' − u'², where u has degree 2 in x, and w is no root of what may be negative.
fn of_an_angle(graph: &mut Graph, factors: &[(Id, Ratio)], (x, logarithm): By) -> Option<Id> {
    let [(u, Ratio { numerator: -1, denominator: 1 })] = *factors else { return None };
    let derivative = |graph: &mut Graph, node: Id| diff::jacobian(graph, &[node], &[x])[0][0];
    let first = derivative(graph, u);
    let second = derivative(graph, first);
    let third = derivative(graph, second);
    if !identity(graph, third).is_zero() {
        return None;
    }
    // w does not read x, and is simplest where that is 0.
    let zero = graph.zero();
    let mut at_zero = Substitution::new(|_: &mut Graph, symbol| (symbol == x).then_some(zero));
    let [u, slope, bend] = [u, first, second].map(|node| at_zero.apply(graph, node));
    let (product, square) = (graph.mul(u, bend), graph.pow(slope, Ratio::integer(2)));
    let twice = graph.scale(Number::integer(2), product);
    let discriminant = graph.sub(twice, square);
    let w = root(graph, discriminant, logarithm)?;
    let tangent = graph.div(first, w);
    let angle = graph.call(Function::Atan, &[tangent]);
    let over = graph.div(angle, w);
    Some(graph.scale(Number::integer(2), over))
}

/// A w with w² = `square`, defined wherever that is, and nowhere zero if 1/w has to be as well.
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
        factors.push((base, exponent.to_integer().filter(|n| n % 2 == 0).map(|n| Ratio::integer((n / 2).into()))?));
    }
    Some(product(graph, &factors))
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

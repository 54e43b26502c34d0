//! Increments of flows, end − x, without the difference of two nearly equal numbers. Compensated sums need them.

use super::products::factors;
use super::scalar::{geometric_sum, mean_of_power};
use crate::analyze;
use crate::diff;
use crate::ir::formula::{call, pow, squared};
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// Returns end − x for every changed coordinate of a flow.
pub(crate) fn increments(graph: &mut Graph, ends: &[(Symbol, Id)]) -> Vec<Id> {
    let difference = |(symbol, end): &(Symbol, Id)| {
        let x = graph.symbol(*symbol);
        let direct = increment(graph, *end, x);
        direct.unwrap_or_else(|| graph.sub(*end, x))
    };
    ends.iter().map(difference).collect()
}

/// Writes linear maps with constant coefficients as x plus an increment. A rounded coefficient 1 + c would expand or contract areas by the
/// rounding error in every step, so energies and lengths would drift.
pub(crate) fn steady(graph: &mut Graph, ends: Vec<(Symbol, Id)>) -> Vec<(Symbol, Id)> {
    let (moving, all): (Vec<Symbol>, Vec<Id>) = ends.iter().copied().unzip();
    let is_moving = |symbol: Symbol| moving.contains(&symbol);
    if !analyze::is_polynomial_in(graph, &all, 1, is_moving) {
        return ends;
    }
    let weights = diff::jacobian(graph, &all, &moving);
    if weights.into_iter().flatten().any(|weight| graph.reads(weight).moves()) {
        return ends;
    }
    let added = increments(graph, &ends);
    ends.into_iter()
        .zip(added)
        .map(|((symbol, end), added)| {
            let x = graph.symbol(symbol);
            let beside = matches!(graph.node(end), Node::Linear(_, terms) if terms.contains(&(Number::ONE, x)));
            (symbol, if beside { end } else { graph.add(x, added) })
        })
        .collect()
}

/// Returns end − x if x is a term of `end`, up to factors near 1.
fn increment(graph: &mut Graph, end: Id, x: Id) -> Option<Id> {
    if end == x {
        return Some(graph.zero());
    }
    match graph.node(end).clone() {
        Node::Linear(constant, terms) => {
            with_term_replaced(graph, constant, terms, |graph, term| increment(graph, term, x))
        }
        // y + y·(eᶻ − 1).
        Node::Call(Function::Grown, args) => {
            let own = increment(graph, args[0], x)?;
            Some(graph.build(own + args[0] * args[2]))
        }
        Node::Product(_) => {
            let mut others = factors(graph, end);
            let single = |(base, exponent): &(Id, Ratio)| (*exponent == Ratio::ONE).then_some(*base);
            let (i, own) =
                others.iter().enumerate().find_map(|(i, factor)| Some((i, increment(graph, single(factor)?, x)?)))?;
            let (base, _) = others.remove(i);
            let excess = excess_of_product(graph, &others)?;
            Some(graph.build(own + base * excess))
        }
        _ => None,
    }
}

/// Returns factor − 1 for a factor that is near 1 in short steps.
fn excess(graph: &mut Graph, factor: Id) -> Option<Id> {
    match graph.node(factor).clone() {
        Node::Number(number) if number == Number::ONE => Some(graph.zero()),
        Node::Linear(constant, terms) if constant == Number::ONE => Some(graph.linear(Number::ZERO, terms)),
        Node::Linear(constant, terms) if constant.is_zero() => with_term_replaced(graph, constant, terms, excess),
        Node::Product(_) => {
            let all = factors(graph, factor);
            excess_of_product(graph, &all)
        }
        Node::Power(base, exponent) => excess_of_power(graph, base, exponent),
        Node::Call(function, args) => match function {
            Function::Exp => Some(graph.call(Function::ExpM1, &[args[0]])),
            Function::Grown => {
                let own = excess(graph, args[0])?;
                Some(graph.build(own + args[0] * args[2]))
            }
            // −u/(1 + u).
            Function::RecipPositive => {
                let u = excess(graph, args[0])?;
                Some(graph.build(-(u * factor)))
            }
            Function::Powf => match (graph.node(args[0]).clone(), graph.as_number(args[1])?) {
                (Node::Call(Function::NotNegative, base), Number::Exact(exponent)) => {
                    excess_of_positive_power(graph, base[0], exponent)
                }
                _ => None,
            },
            // cos w − 1 = −2 sin² w/2. If the angle w reads the state, the formula would cost one more sine in every step.
            Function::Cos if !graph.reads(args[0]).state() => {
                Some(graph.build(-2 * squared(call(Function::Sin, [Number::HALF * args[0]]))))
            }
            Function::StumpffC0 => {
                let half = graph.scale(Number::HALF, args[0]);
                let sine = graph.build(call(Function::StumpffC1, [Number::HALF * half]));
                Some(graph.build(-(half * sine * sine)))
            }
            _ => None,
        },
        _ => None,
    }
}

/// (1 + a)(1 + b) … − 1 = a + (1 + a)·b + ….
fn excess_of_product(graph: &mut Graph, all: &[(Id, Ratio)]) -> Option<Id> {
    let (mut sum, mut product) = (graph.zero(), graph.integer(1));
    for (base, exponent) in all {
        let own = excess_of_power(graph, *base, *exponent)?;
        sum = graph.build(sum + product * own);
        product = graph.build(product * pow(*base, *exponent));
    }
    Some(sum)
}

/// Returns base^exponent − 1 for a base near 1.
fn excess_of_power(graph: &mut Graph, base: Id, exponent: Ratio) -> Option<Id> {
    if exponent == Ratio::ONE {
        return excess(graph, base);
    }
    if let Node::Call(Function::NotNegative, inner) = graph.node(base).clone() {
        return excess_of_positive_power(graph, inner[0], exponent);
    }
    let (u, n) = (excess(graph, base)?, exponent.numerator);
    if !exponent.is_integer() || n.abs() > 8 {
        return excess_of_positive_power(graph, base, exponent);
    }
    let mean = geometric_sum(graph, base, n.abs());
    let change = graph.mul(u, mean);
    if n > 0 {
        return Some(change);
    }
    Some(graph.build(-(change * pow(base, exponent))))
}

/// Returns d^r − 1, or NaN if d is negative.
fn excess_of_positive_power(graph: &mut Graph, d: Id, r: Ratio) -> Option<Id> {
    let u = excess(graph, d)?;
    let mean = mean_of_power(graph, u, r)?;
    Some(graph.mul(u, mean))
}

/// Returns a sum in which the first term with a result of `replace` is replaced by that result. Scaled terms are not tried.
fn with_term_replaced(
    graph: &mut Graph,
    constant: Number,
    mut terms: Vec<(Number, Id)>,
    replace: impl Fn(&mut Graph, Id) -> Option<Id>,
) -> Option<Id> {
    let mut unscaled = terms.iter().enumerate().filter(|(_, (c, _))| *c == Number::ONE);
    let (i, own) = unscaled.find_map(|(i, (_, term))| Some((i, replace(graph, *term)?)))?;
    terms.remove(i);
    let others = graph.linear(constant, terms);
    Some(graph.add(own, others))
}

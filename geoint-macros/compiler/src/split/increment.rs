//! What a flow adds to a coordinate, without the difference of two numbers that are nearly equal: for sums that compensate.

use super::polynomial::factors;
use super::scalar::mean_of_power;
use crate::analyze;
use crate::diff;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// end − x for every coordinate that a flow changes.
pub(crate) fn increments(graph: &mut Graph, ends: &[(Symbol, Id)]) -> Vec<Id> {
    let difference = |(symbol, end): &(Symbol, Id)| {
        let x = graph.symbol(*symbol);
        let direct = increment(graph, *end, x);
        direct.unwrap_or_else(|| graph.sub(*end, x))
    };
    ends.iter().map(difference).collect()
}

/// Linear maps with constant coefficients as x and what they add to it. 1 + c, rounded, would make areas grow, or shrink, by the same rounding at each
/// step: energies and lengths would have a trend.
pub(crate) fn steady(graph: &mut Graph, ends: Vec<(Symbol, Id)>) -> Vec<(Symbol, Id)> {
    let all: Vec<Id> = ends.iter().map(|(_, end)| *end).collect();
    let moving: Vec<Symbol> = ends.iter().map(|(symbol, _)| *symbol).collect();
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

/// end − x, if it can be seen how x is contained in `end`.
fn increment(graph: &mut Graph, end: Id, x: Id) -> Option<Id> {
    if end == x {
        return Some(graph.zero());
    }
    match graph.node(end).clone() {
        Node::Linear(constant, terms) => {
            let (i, own) = contained(graph, &terms, |graph, term| increment(graph, term, x))?;
            Some(with_others(graph, own, constant, &terms, i))
        }
        // y + y·(eᶻ − 1).
        Node::Call(Function::Grown, args) => {
            let (own, change) = (increment(graph, args[0], x)?, graph.mul(args[0], args[2]));
            Some(graph.add(own, change))
        }
        Node::Product(_) => {
            let all = factors(graph, end);
            let single = |(base, exponent): &(Id, Ratio)| (*exponent == Ratio::ONE).then_some(*base);
            let (i, own) =
                all.iter().enumerate().find_map(|(i, factor)| Some((i, increment(graph, single(factor)?, x)?)))?;
            let others: Vec<(Id, Ratio)> = all.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, f)| *f).collect();
            let excess = excess_of_product(graph, &others)?;
            let change = graph.mul(all[i].0, excess);
            Some(graph.add(own, change))
        }
        _ => None,
    }
}

/// factor − 1 of a factor that is near 1 in short steps.
fn excess(graph: &mut Graph, factor: Id) -> Option<Id> {
    match graph.node(factor).clone() {
        Node::Number(number) if number == Number::ONE => Some(graph.zero()),
        Node::Linear(constant, terms) if constant == Number::ONE => {
            Some(without(graph, Number::ZERO, &terms, terms.len()))
        }
        Node::Linear(constant, terms) if constant.is_zero() => {
            let (i, own) = contained(graph, &terms, excess)?;
            Some(with_others(graph, own, constant, &terms, i))
        }
        Node::Product(_) => {
            let all = factors(graph, factor);
            excess_of_product(graph, &all)
        }
        Node::Power(base, exponent) => excess_of_power(graph, base, exponent),
        Node::Call(function, args) => match function {
            Function::Exp => Some(graph.call(Function::ExpM1, &[args[0]])),
            Function::Grown => {
                let (own, change) = (excess(graph, args[0])?, graph.mul(args[0], args[2]));
                Some(graph.add(own, change))
            }
            // −u/(1 + u).
            Function::RecipPositive => {
                let u = excess(graph, args[0])?;
                let change = graph.mul(u, factor);
                Some(graph.neg(change))
            }
            Function::Powf => match (graph.node(args[0]).clone(), graph.as_number(args[1])?) {
                (Node::Call(Function::NotNegative, base), Number::Exact(exponent)) => {
                    positive(graph, base[0], exponent)
                }
                _ => None,
            },
            // cos w − 1 = −2 sin² w/2, of an angle that is prepared: of others it would be one more sine a step.
            Function::Cos if !graph.reads(args[0]).state() => {
                let half = graph.scale(Number::HALF, args[0]);
                let sine = graph.call(Function::Sin, &[half]);
                let square = graph.mul(sine, sine);
                Some(graph.scale(Number::integer(-2), square))
            }
            Function::StumpffC0 => {
                let half = graph.scale(Number::HALF, args[0]);
                let quarter = graph.scale(Number::HALF, half);
                let sine = graph.call(Function::StumpffC1, &[quarter]);
                let change = graph.product(&[half, sine, sine]);
                Some(graph.neg(change))
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
        let own = graph.mul(product, own);
        sum = graph.add(sum, own);
        let factor = graph.pow(*base, *exponent);
        product = graph.mul(product, factor);
    }
    Some(sum)
}

fn excess_of_power(graph: &mut Graph, base: Id, exponent: Ratio) -> Option<Id> {
    if exponent == Ratio::ONE {
        return excess(graph, base);
    }
    if let Node::Call(Function::NotNegative, inner) = graph.node(base).clone() {
        return positive(graph, inner[0], exponent);
    }
    let (u, n) = (excess(graph, base)?, exponent.numerator);
    if !exponent.is_integer() || n.abs() > 8 {
        return positive(graph, base, exponent);
    }
    // dⁿ − 1 = u·(1 + d + … + dⁿ⁻¹) with d = 1 + u.
    let (mut mean, one) = (graph.zero(), graph.integer(1));
    for _ in 0..n.abs() {
        let inner = graph.mul(base, mean);
        mean = graph.add(one, inner);
    }
    let change = graph.mul(u, mean);
    if n > 0 {
        return Some(change);
    }
    let whole = graph.pow(base, exponent);
    let change = graph.mul(change, whole);
    Some(graph.neg(change))
}

/// d^r − 1 where d must not be negative.
fn positive(graph: &mut Graph, d: Id, r: Ratio) -> Option<Id> {
    let u = excess(graph, d)?;
    let mean = mean_of_power(graph, u, r)?;
    Some(graph.mul(u, mean))
}

/// The first term of a sum that is not scaled and of which `part` finds something.
fn contained(
    graph: &mut Graph,
    terms: &[(Number, Id)],
    part: impl Fn(&mut Graph, Id) -> Option<Id>,
) -> Option<(usize, Id)> {
    let found = |(i, (c, term)): (usize, &(Number, Id))| {
        if *c == Number::ONE { Some((i, part(graph, *term)?)) } else { None }
    };
    terms.iter().enumerate().find_map(found)
}

/// What was found of term `i`, and all others.
fn with_others(graph: &mut Graph, own: Id, constant: Number, terms: &[(Number, Id)], i: usize) -> Id {
    let others = without(graph, constant, terms, i);
    graph.add(own, others)
}

/// A sum without its term `i`.
fn without(graph: &mut Graph, constant: Number, terms: &[(Number, Id)], i: usize) -> Id {
    let mut parts = vec![graph.number(constant)];
    for (j, (c, term)) in terms.iter().enumerate() {
        if j != i {
            parts.push(graph.scale(*c, *term));
        }
    }
    graph.sum(&parts)
}

//! Scalar equations x' = g(x) with elementary functions in g.

use super::super::polynomial::{reads, slope_of_line};
use super::super::products::ScaledPower;
use super::super::time::slope;
use super::{Equation, Solution, mean_of_recip};
use crate::ir::formula::{call, pow, squared};
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// x + ah − ln(1 − k·b·e^(kx)·h·φ₁(kah))/k.
pub(super) fn exponential(graph: &mut Graph, equation: &Equation) -> Option<Solution> {
    let own = equation.x;
    let (mut a, mut b, mut argument) = (graph.zero(), graph.zero(), None);
    for term in terms(graph, equation.rate, own) {
        if !reads(graph, term, own) {
            a = graph.add(a, term);
            continue;
        }
        // All terms must share one exponential.
        let call = Call::of(graph, term, own)?;
        if (call.function, call.exponent) != (Function::Exp, Ratio::ONE)
            || *argument.get_or_insert(call.argument) != call.argument
        {
            return None;
        }
        b = graph.add(b, call.coefficient);
    }
    let argument = argument?;
    equation.steady(graph, &[argument])?;
    let k = slope_of_line(graph, argument, own)?;
    let value = graph.call(Function::Exp, &[argument]);
    let x = graph.symbol(own);
    let (drift, weight) = if graph.is_zero(a) {
        (x, equation.clock.over_step(graph, b)?)
    } else {
        let h = equation.steady(graph, &[a, b])?;
        let mean = graph.build(call(Function::Phi1, [k * a * h]));
        (graph.build(x + a * h), graph.build(b * h * mean))
    };
    let grown = graph.mul(weight, value);
    let shrunk = graph.build(-(k * grown));
    let by_start = graph.build(call(Function::RecipPositive, [1 + shrunk]));
    if graph.as_number(k).is_some() {
        return Some(Solution { end: graph.build(drift - call(Function::Ln1p, [shrunk]) / k), by_start });
    }
    // A parameter k may be zero, so the formula must not divide by k.
    let ln = mean_of_recip(graph, shrunk);
    Some(Solution { end: graph.build(drift + grown * ln), by_start })
}

/// With u = k·x + c and U = k·∫a dt, the flow multiplies a function of u by e^U: tan u/2 for sin, tan (u/2 + π/4) for cos, tanh u/2 for
/// sinh, and sinh u for tanh. For 1/cosh, it adds U to sinh u.
pub(super) fn quadrature(graph: &mut Graph, equation: &Equation) -> Option<Solution> {
    let own = equation.x;
    let Call { function, argument: u, coefficient: a, exponent } = Call::of(graph, equation.rate, own)?;
    equation.steady(graph, &[u])?;
    let k = slope_of_line(graph, u, own)?;
    let total = equation.clock.over_step(graph, a)?;
    let z = graph.mul(k, total);
    let [growth, mean] = [Function::Exp, Function::Phi1].map(|function| graph.call(function, &[z]));
    // The increment of a quantity y that the flow multiplies by e^U, divided by k.
    let gained = |graph: &mut Graph, y: Id| graph.product(&[total, mean, y]);
    let (moved, by_start) = match (function, exponent) {
        (Function::Sin | Function::Cos, Ratio::ONE) => {
            // The half-angle formula for sin avoids 1 − cos u, which loses digits for small u.
            let (across, along, forgotten) = if function == Function::Sin {
                let half = graph.scale(Number::HALF, u);
                let [sine, cosine] = [Function::Sin, Function::Cos].map(|f| graph.call(f, &[half]));
                let [across, along, forgotten] =
                    [[sine, cosine], [sine, sine], [cosine, cosine]].map(|[x, y]| graph.mul(x, y));
                [across, along, forgotten].map(|x| graph.scale(Number::integer(2), x)).into()
            } else {
                let [sine, cosine] = [Function::Sin, Function::Cos].map(|f| graph.call(f, &[u]));
                (cosine, graph.build(1 + sine), graph.build(1 - sine))
            };
            let [above, below] = [across, along].map(|x| gained(graph, x));
            let (high, below) = (graph.mul(k, above), graph.build(2 + k * below));
            // E/(1 ∓ c + E²(1 ± c)) with E = e^U.
            let by_start = graph.build(growth / (forgotten + squared(growth) * along));
            let half = if graph.as_number(k).is_some() {
                graph.build(call(Function::Atan2, [high, below]) / k)
            } else {
                graph.build(above * call(Function::Arc, [high, below]))
            };
            [half, by_start].map(|x| graph.build(2 * x)).into()
        }
        (Function::Sinh, Ratio::ONE) => {
            let tanh = graph.build(call(Function::Tanh, [Number::HALF * u]));
            let gained = gained(graph, tanh);
            let half = rise(graph, Function::Atanh, tanh, gained, k);
            let end = graph.mul(growth, tanh);
            let [above, below] = [tanh, end].map(|x| graph.build(1 - squared(x)));
            let below = graph.call(Function::RecipPositive, &[below]);
            (graph.build(2 * half), graph.build(growth * above * below))
        }
        (Function::Tanh, Ratio::ONE) => {
            let sinh = graph.call(Function::Sinh, &[u]);
            let gained = gained(graph, sinh);
            let moved = rise(graph, Function::Asinh, sinh, gained, k);
            let end = graph.mul(growth, sinh);
            let slope = cosh_ratio(graph, u, end);
            (moved, graph.mul(growth, slope))
        }
        (Function::Cosh, Ratio { numerator: -1, denominator: 1 }) => {
            let sinh = graph.call(Function::Sinh, &[u]);
            let end = graph.add(sinh, z);
            (rise(graph, Function::Asinh, sinh, total, k), cosh_ratio(graph, u, end))
        }
        _ => return None,
    };
    let x = graph.symbol(own);
    Some(Solution { end: graph.add(x, moved), by_start })
}

/// Returns cosh u/√(1 + end²).
fn cosh_ratio(graph: &mut Graph, u: Id, end: Id) -> Id {
    graph.build(call(Function::Cosh, [u]) / pow(1 + squared(end), Ratio::HALF))
}

/// Returns (f(a + k·d) − f(a))/k by the divided difference of f, without cancellation. The formula holds for k = 0, too.
fn rise(graph: &mut Graph, f: Function, a: Id, d: Id, k: Id) -> Id {
    let change = graph.mul(k, d);
    let slope = slope(graph, f, a, change);
    graph.mul(d, slope)
}

/// Returns the terms of a sum, or of a product of a sum and factors that do not read x.
fn terms(graph: &mut Graph, id: Id, x: Symbol) -> Vec<Id> {
    if let Node::Linear(constant, inner) = graph.node(id).clone() {
        let mut all = vec![graph.number(constant)];
        for (c, term) in inner {
            all.extend(terms(graph, term, x).into_iter().map(|term| graph.scale(c, term)));
        }
        return all;
    }
    match ScaledPower::of(graph, id, &|symbol| symbol == x) {
        Some(ScaledPower { coefficient, base, exponent: Ratio::ONE })
            if matches!(graph.node(base), Node::Linear(..)) =>
        {
            terms(graph, base, x).into_iter().map(|term| graph.mul(coefficient, term)).collect()
        }
        _ => vec![id],
    }
}

/// A term coefficient·function(argument)^exponent in which only the argument reads x.
struct Call {
    coefficient: Id,
    function: Function,
    argument: Id,
    exponent: Ratio,
}

impl Call {
    /// Returns a term in this form. Powers of an exponential become factors of its argument.
    fn of(graph: &mut Graph, id: Id, x: Symbol) -> Option<Call> {
        let ScaledPower { coefficient, base, exponent } = ScaledPower::of(graph, id, &|symbol| symbol == x)?;
        match graph.node(base).clone() {
            Node::Call(function @ Function::Exp, args) => {
                let argument = graph.scale(Number::Exact(exponent), args[0]);
                Some(Call { coefficient, function, argument, exponent: Ratio::ONE })
            }
            Node::Call(function, args) if args.len() == 1 => {
                Some(Call { coefficient, function, argument: args[0], exponent })
            }
            _ => None,
        }
    }
}

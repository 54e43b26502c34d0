//! Pieces that are quadratic in (q, p).

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Monomial, Polynomial, is_free};
use super::super::scalar::rotation;
use super::super::time::Clock;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

/// The coefficients of every term, if they are constant, and H has no other than these.
pub(super) fn coefficients(
    graph: &mut Graph,
    group: &Group,
    allowed: impl Fn(&[(Symbol, i128)]) -> bool,
) -> Option<Polynomial> {
    let powers = Polynomial::of(graph, group.energy, &|symbol| symbol.is_coordinate())?;
    let mut steady = true;
    for (monomial, coefficient) in powers.terms() {
        let integers: Option<Vec<(Symbol, i128)>> =
            monomial.iter().map(|(symbol, power)| power.is_integer().then_some((*symbol, power.numerator))).collect();
        if !integers.is_some_and(|integers| allowed(&integers)) {
            return None;
        }
        steady &= is_free(graph, coefficient, &|symbol| symbol == Symbol::Time);
    }
    (steady || group.clock == Clock::Stage).then_some(powers)
}

/// Σ (a p² + 2e q p + b q²)/2 + c s, an oscillator a degree of freedom: with d = e + c/2, ω² = ab − d², C = cos ωh and
/// S = sin ωh/ω, Q = e^(−ch/2)·(C q + S (d q + a p)), P = e^(−ch/2)·(C p − S (b q + d p)), and s − q·p/2 decays like e^(−ct).
pub(in super::super) fn oscillator(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let same = |a: &Symbol, b: &Symbol| {
        let index = |symbol: &Symbol| match symbol {
            Symbol::Position(i) | Symbol::Momentum(i) => Some(*i),
            _ => None,
        };
        index(a).is_some() && index(a) == index(b)
    };
    let powers = coefficients(graph, group, |monomial| match monomial {
        [(Symbol::Action, 1)] => true,
        [(Symbol::Position(_) | Symbol::Momentum(_), 2)] => true,
        [(a, 1), (b, 1)] => same(a, b),
        _ => false,
    })?;
    // What is of degree 1 in the momenta, or reads no positions, is a simpler family.
    let bends = |monomial: &Monomial| {
        monomial.iter().any(|(symbol, power)| matches!(symbol, Symbol::Momentum(_)) && *power == Ratio::integer(2))
    };
    let reads_q = |monomial: &Monomial| monomial.keys().any(|symbol| matches!(symbol, Symbol::Position(_)));
    if powers.has_only(|monomial| !bends(monomial)) || powers.has_only(|monomial| !reads_q(monomial)) {
        return None;
    }
    let (h, one) = (graph.symbol(Symbol::StepLength), graph.integer(1));
    let c = powers.coefficient(graph, &[(Symbol::Action, 1)]);
    let half_c = graph.scale(Number::HALF, c);
    let z = graph.mul(half_c, h);
    let z = graph.neg(z);
    let decay = if graph.is_zero(c) { one } else { graph.call(Function::Exp, &[z]) };
    let mut flow = Flow::rest(graph, group.degrees);
    let mut action = graph.product(&[decay, decay, flow.s]);
    for i in 0..group.degrees {
        let (q, p) = (Symbol::Position(i), Symbol::Momentum(i));
        let [a, b] = [p, q].map(|symbol| {
            let half = powers.coefficient(graph, &[(symbol, 2)]);
            graph.scale(Number::integer(2), half)
        });
        let e = powers.coefficient(graph, &[(q, 1), (p, 1)]);
        let e = graph.add(e, half_c);
        let product = graph.mul(a, b);
        let square = graph.pow(e, Ratio::integer(2));
        let square = graph.sub(product, square);
        let (cosine, sine) = rotation(graph, square, h, false);
        let [q, p] = [q, p].map(|symbol| graph.symbol(symbol));
        let [toward_q, toward_p] = [[e, a], [b, e]].map(|[first, second]| {
            let terms = [graph.mul(first, q), graph.mul(second, p)];
            let sum = graph.sum(&terms);
            graph.mul(sine, sum)
        });
        let [kept_q, kept_p] = [q, p].map(|x| graph.mul(cosine, x));
        let q_end = graph.add(kept_q, toward_q);
        let p_end = graph.sub(kept_p, toward_p);
        let (q_end, p_end) = (graph.mul(decay, q_end), graph.mul(decay, p_end));
        (flow.q[i as usize], flow.p[i as usize]) = (q_end, p_end);
        // What s − q·p/2 being free of forces leaves of q·p/2, without differences of nearly equal numbers.
        let [q_squared, p_squared] = [(b, q), (a, p)].map(|(weight, x)| graph.product(&[weight, x, x]));
        let lagrangian = graph.sub(p_squared, q_squared);
        let energy = graph.add(p_squared, q_squared);
        let mixed = graph.product(&[a, b, q, p]);
        let mixed = graph.scale(Number::integer(2), mixed);
        let energy = graph.mul(e, energy);
        let second = graph.add(mixed, energy);
        let [first, second] = [(cosine, lagrangian), (sine, second)].map(|(weight, x)| graph.mul(weight, x));
        let change = graph.sub(first, second);
        // Each with its decay: the square of a sine that grows may be beyond all numbers.
        let [sine, change] = [sine, change].map(|x| graph.mul(decay, x));
        let change = graph.mul(sine, change);
        let change = graph.scale(Number::HALF, change);
        action = graph.add(action, change);
    }
    flow.s = action;
    Some(flow)
}

/// p·Wp/2 + b·p + g·q + c: the parabola of a throw.
pub(in super::super) fn uniform_field(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = coefficients(graph, group, |monomial| {
        matches!(
            monomial,
            [] | [(Symbol::Position(_) | Symbol::Momentum(_), 1)]
                | [(Symbol::Momentum(_), 2)]
                | [(Symbol::Momentum(_), 1), (Symbol::Momentum(_), 1)]
        )
    })?;
    let degrees = group.degrees;
    let of = |graph: &mut Graph, powers_of: &[(Symbol, i128)]| powers.coefficient(graph, powers_of);
    let g: Vec<Id> = (0..degrees).map(|i| of(graph, &[(Symbol::Position(i), 1)])).collect();
    let b: Vec<Id> = (0..degrees).map(|i| of(graph, &[(Symbol::Momentum(i), 1)])).collect();
    let c = of(graph, &[]);
    // W x.
    let weighted = |graph: &mut Graph, x: &[Id]| -> Vec<Id> {
        let mut rows = vec![];
        for i in 0..degrees {
            let mut row = graph.zero();
            for j in 0..degrees {
                let entry = if i == j {
                    let half = powers.coefficient(graph, &[(Symbol::Momentum(i), 2)]);
                    graph.scale(Number::integer(2), half)
                } else {
                    powers.coefficient(graph, &[(Symbol::Momentum(i.min(j)), 1), (Symbol::Momentum(i.max(j)), 1)])
                };
                let part = graph.mul(entry, x[j as usize]);
                row = graph.add(row, part);
            }
            rows.push(row);
        }
        rows
    };
    let mut flow = Flow::rest(graph, degrees);
    let (q, p, h) = (flow.q.clone(), flow.p.clone(), graph.symbol(Symbol::StepLength));
    let (velocity, fall) = (weighted(graph, &p), weighted(graph, &g));
    let [h2, h3] = [2, 3].map(|power| graph.pow(h, Ratio::integer(power)));
    for i in 0..degrees as usize {
        let rate = graph.add(velocity[i], b[i]);
        let straight = graph.mul(h, rate);
        let bent = graph.mul(h2, fall[i]);
        let bent = graph.scale(Number::HALF, bent);
        let moved = graph.sub(straight, bent);
        flow.q[i] = graph.add(q[i], moved);
        let impulse = graph.mul(h, g[i]);
        flow.p[i] = graph.sub(p[i], impulse);
    }
    // s' = T₂(p) − g·q − c along the parabola.
    let twice = graph.dot(&p, &velocity);
    let kinetic = graph.scale(Number::HALF, twice);
    let height = graph.dot(&g, &q);
    let first = graph.sub(kinetic, height);
    let first = graph.sub(first, c);
    let (with_p, with_b, with_g) = (graph.dot(&g, &velocity), graph.dot(&g, &b), graph.dot(&g, &fall));
    let half = graph.scale(Number::HALF, with_b);
    let second = graph.add(with_p, half);
    let third = graph.scale(Number::Exact(Ratio::integer(3).recip()?), with_g);
    let terms = [graph.mul(h, first), graph.mul(h3, third)];
    let sum = graph.sum(&terms);
    let second = graph.mul(h2, second);
    let change = graph.sub(sum, second);
    flow.s = graph.add(flow.s, change);
    Some(flow)
}

//! Families "oscillators" and "uniform field": quadratic energies with simple closed flows.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Monomial, Polynomial, degree_of_freedom, is_momentum};
use super::super::scalar::{Angle, rotation};
use crate::diff::equations::times;
use crate::ir::formula::{call, squared, sum};
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

/// Returns H as a polynomial, if all coefficients are constant along the flow and all monomials are `allowed`. Exponents are integers.
pub(super) fn coefficients(
    graph: &mut Graph,
    group: &Group,
    allowed: impl Fn(&[(Symbol, i128)]) -> bool,
) -> Option<Polynomial> {
    let powers = Polynomial::of(graph, group.energy, &Symbol::is_coordinate)?;
    let fits = |monomial: &Monomial| {
        let integers: Option<Vec<(Symbol, i128)>> =
            monomial.iter().map(|(symbol, power)| power.is_integer().then_some((*symbol, power.numerator))).collect();
        integers.is_some_and(|integers| allowed(&integers))
    };
    let steady = powers.has_only(fits) && powers.terms().all(|(_, c)| group.clock.is_steady(graph, c));
    steady.then_some(powers)
}

/// Returns the flow of Σ (a p² + 2e q p + b q²)/2 + c s, one oscillator for each degree of freedom.
///
/// With d = e + c/2, ω² = ab − d², C = cos ωh and S = sin ωh/ω: Q = e^(−ch/2)·(C q + S (d q + a p)), P = e^(−ch/2)·(C p − S (b q + d p)),
/// and s − q·p/2 decays as e^(−ct).
pub(super) fn oscillator(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = coefficients(graph, group, |monomial| match monomial {
        [(Symbol::Action, 1)] => true,
        [(Symbol::Position(_) | Symbol::Momentum(_), 2)] => true,
        [(a, 1), (b, 1)] => degree_of_freedom(*a).is_some() && degree_of_freedom(*a) == degree_of_freedom(*b),
        _ => false,
    })?;
    // Simpler families know energies of degree 1 in the momenta and energies without positions.
    let has = |is_part: &dyn Fn(Symbol, Ratio) -> bool| {
        powers.terms().any(|(monomial, _)| monomial.iter().any(|(symbol, power)| is_part(*symbol, *power)))
    };
    if !has(&|symbol, power| is_momentum(symbol) && power == Ratio::integer(2))
        || !has(&|symbol, _| matches!(symbol, Symbol::Position(_)))
    {
        return None;
    }
    let h = graph.symbol(Symbol::StepLength);
    let c = powers.coefficient(graph, &[(Symbol::Action, 1)]);
    let half_c = graph.scale(Number::HALF, c);
    let decay = if graph.is_zero(c) { graph.integer(1) } else { graph.build(call(Function::Exp, [-(half_c * h)])) };
    let mut flow = Flow::rest(graph, group.degrees);
    let mut action = graph.product(&[decay, decay, flow.s]);
    for i in 0..group.degrees {
        let (q, p) = (Symbol::Position(i), Symbol::Momentum(i));
        let [a, b] = [p, q].map(|symbol| powers.second_derivative(graph, symbol, symbol));
        let e = powers.coefficient(graph, &[(q, 1), (p, 1)]);
        let d = graph.add(e, half_c);
        let square = graph.build(a * b - squared(d));
        let (cosine, sine) = rotation(graph, square, h, Angle::Any);
        let [q, p] = [q, p].map(|symbol| graph.symbol(symbol));
        let [toward_q, toward_p] = [[d, a], [b, d]].map(|[first, second]| {
            let sum = graph.dot(&[first, second], &[q, p]);
            graph.mul(sine, sum)
        });
        let [kept_q, kept_p] = [q, p].map(|x| graph.mul(cosine, x));
        let (q_end, p_end) = (graph.add(kept_q, toward_q), graph.sub(kept_p, toward_p));
        flow.q[i as usize] = graph.mul(decay, q_end);
        flow.p[i as usize] = graph.mul(decay, p_end);
        // S (C (a p² − b q²) − S (2ab qp + d (a p² + b q²)))/2, damped, is the part of Q·P/2 beyond e^(−ch) q·p/2. The formula subtracts no nearly
        // equal numbers.
        let [q_squared, p_squared] = [(b, q), (a, p)].map(|(weight, x)| graph.product(&[weight, x, x]));
        let (lagrangian, energy) = (graph.sub(p_squared, q_squared), graph.add(p_squared, q_squared));
        let second = graph.build(2 * (a * b * q * p) + d * energy);
        let change = graph.build(cosine * lagrangian - sine * second);
        // Each factor is damped by itself, because the square of a growing sine may overflow.
        action = graph.build(action + Number::HALF * ((decay * sine) * (decay * change)));
    }
    flow.s = action;
    Some(flow)
}

/// Returns the flow of p·Wp/2 + b·p + g·q + c, the parabola of a throw.
pub(super) fn uniform_field(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = coefficients(graph, group, |monomial| {
        matches!(
            monomial,
            [] | [(Symbol::Position(_) | Symbol::Momentum(_), 1)]
                | [(Symbol::Momentum(_), 2)]
                | [(Symbol::Momentum(_), 1), (Symbol::Momentum(_), 1)]
        )
    })?;
    let all = || 0..group.degrees;
    let g: Vec<Id> = all().map(|i| powers.coefficient(graph, &[(Symbol::Position(i), 1)])).collect();
    let b: Vec<Id> = all().map(|i| powers.coefficient(graph, &[(Symbol::Momentum(i), 1)])).collect();
    let c = powers.coefficient(graph, &[]);
    let mut flow = Flow::rest(graph, group.degrees);
    let (q, p, h) = (flow.q.clone(), flow.p.clone(), graph.symbol(Symbol::StepLength));
    let row = |graph: &mut Graph, i| -> Vec<Id> {
        all().map(|j| powers.second_derivative(graph, Symbol::Momentum(i), Symbol::Momentum(j))).collect()
    };
    let w: Vec<Vec<Id>> = all().map(|i| row(graph, i)).collect();
    let (velocity, fall) = (times(graph, &w, &p), times(graph, &w, &g));
    let [h2, h3] = [2, 3].map(|power| graph.pow(h, Ratio::integer(power)));
    for i in 0..q.len() {
        flow.q[i] = graph.build(q[i] + (h * (velocity[i] + b[i]) - Number::HALF * (h2 * fall[i])));
        flow.p[i] = graph.build(p[i] - h * g[i]);
    }
    // The integral of s' = p·Wp/2 − g·q − c along the parabola.
    let twice = graph.dot(&p, &velocity);
    let kinetic = graph.scale(Number::HALF, twice);
    let height = graph.dot(&g, &q);
    let first = graph.build(kinetic - height - c);
    let (with_p, with_b, with_g) = (graph.dot(&g, &velocity), graph.dot(&g, &b), graph.dot(&g, &fall));
    let second = graph.build(with_p + Number::HALF * with_b);
    let third = graph.scale(Number::Exact(Ratio::integer(3).recip()?), with_g);
    let change = graph.build(sum([h * first, h3 * third]) - h2 * second);
    flow.s = graph.add(flow.s, change);
    Some(flow)
}

//! Families of energies whose momenta keep their direction.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Polynomial, degree, is_free, is_momentum, reads, single_momentum, times_powers};
use super::super::products::{Separated, quotient, separated};
use super::super::scalar::{self, Equation, positive_power};
use super::super::time::Clock;
use crate::diff;
use crate::ir::formula::{pow, squared};
use crate::ir::substitute::replaced;
use crate::ir::{Graph, Id, Number, Ratio, Symbol};

/// Returns the flow of T(p, t): q grows by ∫∂T/∂p dt, and s by ∫(p·∂T/∂p − T) dt.
pub(in super::super) fn free(graph: &mut Graph, group: &Group) -> Option<Flow> {
    if !is_free(graph, group.energy, &|symbol| matches!(symbol, Symbol::Position(_) | Symbol::Action)) {
        return None;
    }
    let mut flow = Flow::rest(graph, group.degrees);
    let velocity = diff::gradient(graph, group.energy, group.degrees).p;
    let lagrangian = lagrangian(graph, group.energy, &velocity)?;
    for (q, velocity) in flow.q.iter_mut().zip(velocity) {
        let change = group.clock.over_step(graph, velocity)?;
        *q = graph.add(*q, change);
    }
    let change = group.clock.over_step(graph, lagrangian)?;
    flow.s = graph.add(flow.s, change);
    Some(flow)
}

/// Returns p·∂H/∂p − H. If H is a polynomial in p, each term of degree k contributes k − 1 times itself.
fn lagrangian(graph: &mut Graph, energy: Id, velocity: &[Id]) -> Option<Id> {
    if let Some(powers) = Polynomial::of(graph, energy, &is_momentum) {
        let mut sum = graph.zero();
        for (monomial, coefficient) in powers.into_terms() {
            let weight = degree(&monomial)?.add(Ratio::integer(-1))?;
            let weighted = graph.scale(Number::Exact(weight), coefficient);
            let term = times_powers(graph, weighted, &monomial);
            sum = graph.add(sum, term);
        }
        return Some(sum);
    }
    let negative = graph.neg(energy);
    Some((0..).zip(velocity).fold(negative, |sum, (i, velocity)| {
        let p = graph.symbol(Symbol::Momentum(i));
        graph.build(sum + p * *velocity)
    }))
}

/// Returns the flow of K(p)·F(s) for K homogeneous of degree 2. F p is constant, and s' = K(F p)/F(s).
pub(super) fn weighted(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = Polynomial::of(graph, group.energy, &is_momentum)?;
    let changes = |symbol: Symbol| symbol.is_coordinate() || symbol == Symbol::Time && group.clock == Clock::Own;
    let (mut kinetic, mut weight) = (graph.zero(), None);
    for (monomial, coefficient) in powers.into_terms() {
        let weight = *weight.get_or_insert(coefficient);
        let relative = graph.div(coefficient, weight);
        let whole = monomial.values().all(|power| power.is_integer());
        if !whole || degree(&monomial)? != Ratio::integer(2) || !is_free(graph, relative, &changes) {
            return None;
        }
        let term = times_powers(graph, relative, &monomial);
        kinetic = graph.add(kinetic, term);
    }
    let weight =
        weight.filter(|weight| is_free(graph, *weight, &|symbol| symbol != Symbol::Action && changes(symbol)))?;
    // A coefficient may be zero, so only the factors that read s become the divisor.
    let Separated { free: coefficient, reading: weight } = separated(graph, weight, Symbol::Action);
    if !reads(graph, weight, Symbol::Action) {
        return None;
    }
    let kinetic = graph.mul(coefficient, kinetic);
    // `ActionIncrement` stands for the constant K(F p) while the equation of s is solved.
    let constant = graph.build(kinetic * squared(weight));
    let name = graph.symbol(Symbol::ActionIncrement);
    let rate = graph.div(name, weight);
    let end = scalar::solve(graph, &Equation { x: Symbol::Action, rate, clock: group.clock })?.end;
    let end = replaced(graph, end, Symbol::ActionIncrement, constant);
    let weight_end = replaced(graph, weight, Symbol::Action, end);
    let change = quotient(graph, weight, weight_end);

    let mut flow = Flow::rest(graph, group.degrees);
    let velocity = diff::gradient(graph, kinetic, group.degrees).p;
    let h = graph.symbol(Symbol::StepLength);
    for (q, velocity) in flow.q.iter_mut().zip(velocity) {
        *q = graph.build(*q + h * weight * velocity);
    }
    for p in &mut flow.p {
        *p = graph.mul(*p, change);
    }
    flow.s = end;
    Some(flow)
}

/// Returns the flow of c s pᵢᵏ. With D = 1 + k c h pᵢᵏ: Qᵢ = qᵢ + k c h pᵢᵏ⁻¹ s, P = p D^(−1/k), S = s D^((k−1)/k).
pub(super) fn power(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let powers = Polynomial::of(graph, group.energy, &|symbol| is_momentum(symbol) || symbol == Symbol::Action)?;
    let (monomial, c) = powers.single()?;
    let (i, k) = single_momentum(monomial)?;
    if monomial.get(&Symbol::Action) != Some(&Ratio::ONE)
        || monomial.len() != 2
        || !is_free(graph, c, &Symbol::is_coordinate)
    {
        return None;
    }
    let c = graph.scale(Number::Exact(k), c);
    let weight = group.clock.over_step(graph, c)?;
    let [p, s] = [Symbol::Momentum(i), Symbol::Action].map(|symbol| graph.symbol(symbol));
    let moved = graph.build(weight * pow(p, k.add(Ratio::integer(-1))?) * s);
    let d = graph.build(1 + weight * pow(p, k));
    let inverse = k.recip()?.neg();
    let [shrunk, grown] = [inverse, Ratio::ONE.add(inverse)?].map(|exponent| positive_power(graph, d, exponent));
    let mut flow = Flow::rest(graph, group.degrees);
    let q = &mut flow.q[i as usize];
    *q = graph.add(*q, moved);
    for p in &mut flow.p {
        *p = graph.mul(*p, shrunk);
    }
    flow.s = graph.mul(s, grown);
    Some(flow)
}

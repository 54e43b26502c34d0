//! The same of a Lagrangian L(q, v, s, t) with an action: s' = L, d/dt ∂L/∂v = ∂L/∂q + ∂L/∂s ∂L/∂v.

use super::super::forward::jacobian;
use super::super::gradient::{Gradient, discrete_gradient, partial};
use super::{Given, ends, force, means, polarisation, stage};
use crate::ir::collect::collected_with;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Number, Symbol};

/// ∂L/∂q and σ = −∂L/∂s.
pub(crate) fn action_force(graph: &mut Graph, given: Given<'_>, lagrangian: Id) -> Vec<Id> {
    let by_action = partial(graph, lagrangian, Symbol::Action);
    let decay = graph.neg(by_action);
    [force(graph, given), vec![decay]].concat()
}

/// What [`stage`] has; then L, σ, ∂p/∂s, ∂f/∂s and ∂σ/∂s.
pub(crate) fn action_stage(graph: &mut Graph, given: Given<'_>, lagrangian: Id) -> Vec<Id> {
    let (known, by_action) = (stage(graph, given), partial(graph, lagrangian, Symbol::Action));
    let decay = graph.neg(by_action);
    let vectors = [given.momenta, given.forces, &[decay]].concat();
    let by_action = jacobian(graph, &vectors, &[Symbol::Action]).concat();
    [known, vec![lagrangian, decay], by_action].concat()
}

/// The polarised discrete gradient with decay, for d = (v₁ − v₀, s₁ − s₀): see `ContactPolarised` of the runtime. Time is that of the middle
/// of the step.
pub(crate) fn decaying(graph: &mut Graph, given: Given<'_>, lagrangian: Id) -> Vec<Id> {
    let degrees = given.momenta.len() as u32;
    let h = graph.symbol(Symbol::StepLength);
    let (ends, means) = (ends(graph, degrees), means(graph, degrees));
    let increments: Vec<Id> = means.iter().map(|mean| graph.mul(h, *mean)).collect();
    let polarised = polarisation(graph, given);
    let Gradient { q, s, .. } = discrete_gradient(graph, polarised, degrees);
    let mut moved = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::PositionIncrement(i) => Some(increments[i as usize]),
        _ => None,
    });
    let [forces, growth]: [Vec<Id>; 2] =
        [q, vec![s]].map(|slopes| slopes.iter().map(|slope| moved.apply(graph, *slope)).collect());
    let growth = graph.mul(h, growth[0]);

    let momenta = momenta_at_end(graph, given, &ends, &increments);
    let (mut residual, mut steps, mut power) = (vec![], vec![], vec![]);
    for (i, (momentum, force)) in (0..).zip(momenta.iter().zip(&forces)) {
        let p = graph.symbol(Symbol::Momentum(i));
        let sum = graph.add(p, *momentum);
        let mean = graph.scale(Number::HALF, sum);
        power.push(graph.mul(mean, means[i as usize]));
        let (pushed, grown) = (graph.mul(h, *force), graph.mul(growth, mean));
        let step = graph.add(pushed, grown);
        let [p, back] = [p, step].map(|id| graph.neg(id));
        residual.push(graph.sum(&[*momentum, p, back]));
        steps.push(step);
    }
    // p̄·v̄ − H₀ φ₁(hΛ_s), with H₀ = p₀·v₀ − L.
    let decayed = graph.call(Function::Phi1, &[growth]);
    let energy = energy_before(graph, lagrangian, degrees);
    let lost = graph.mul(energy, decayed);
    power.push(graph.neg(lost));
    let power = graph.sum(&power);
    let step = graph.mul(h, power);
    let ds = graph.symbol(Symbol::ActionIncrement);
    residual.push(graph.sub(ds, step));
    steps.push(step);

    let unknowns: Vec<Symbol> = (0..degrees).map(Symbol::VelocityIncrement).chain([Symbol::ActionIncrement]).collect();
    let [matrix, steps_by] = [&residual, &steps].map(|values| jacobian(graph, values, &unknowns).concat());
    let roots = [residual, steps, matrix, steps_by].concat();
    let ends = super::ends::by_slopes(graph, &given.read(), &increments);
    collected_with(graph, &roots, &ends)
}

/// p₀·v₀ − L.
fn energy_before(graph: &mut Graph, lagrangian: Id, degrees: u32) -> Id {
    let mut terms = vec![graph.neg(lagrangian)];
    for i in 0..degrees {
        let [p, v] = [Symbol::Momentum(i), Symbol::Velocity(i)].map(|symbol| graph.symbol(symbol));
        terms.push(graph.mul(p, v));
    }
    graph.sum(&terms)
}

/// M(q₁, s₁)v₁ + a(q₁, s₁).
fn momenta_at_end(graph: &mut Graph, given: Given<'_>, ends: &[Id], increments: &[Id]) -> Vec<Id> {
    let mut end = Substitution::new(|graph: &mut Graph, symbol| {
        let increment = match symbol {
            Symbol::Position(i) => increments[i as usize],
            Symbol::Action => graph.symbol(Symbol::ActionIncrement),
            _ => return None,
        };
        let start = graph.symbol(symbol);
        Some(graph.add(start, increment))
    });
    super::momenta(graph, given, ends, |graph, node| end.apply(graph, node))
}

//! RATTLE and the discrete gradient with constraints.

use super::{Equation, Given, ends, moved, sums};
use crate::diff::gradient::discrete_gradient;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Symbol};

/// RATTLE up to the momentum that is to be made tangent at the end.
pub(crate) fn rattle(graph: &mut Graph, given: &Given<'_>) -> Equation {
    let n = given.degrees();
    let [h, t] = [Symbol::StepLength, Symbol::Time].map(|symbol| graph.symbol(symbol));
    let (half, later) = (graph.scale(Number::HALF, h), graph.add(t, h));
    let pull = pulls(graph, &given.gradients, Number::ONE);
    let impulse =
        |graph: &mut Graph, force: &[Id]| force.iter().map(|force| graph.mul(half, *force)).collect::<Vec<_>>();
    if given.mean_velocity.is_none() {
        let kick = impulse(graph, given.force);
        let increments = sums(graph, &kick, &pull);
        let shift = shifts(graph, given.velocity, &increments, Number::ONE);
        let end = ends(graph, Symbol::Position, &shift);
        let there = moved(graph, given.force, (&end, None), later);
        let last = impulse(graph, &there);
        let unknowns = multipliers(given);
        return Equation {
            residual: given.bound(graph, &end),
            end: [shift, sums(graph, &increments, &last)].concat(),
            origin: given.origin(graph, &unknowns, Number::ONE),
            unknowns,
        };
    }
    let [dq, dp] = increments(graph, n);
    let [end, middle] = [ends(graph, Symbol::Position, &dq), ends(graph, Symbol::Momentum, &dp)];
    let start: Vec<Id> = (0..n as u32).map(|i| graph.symbol(Symbol::Position(i))).collect();
    let mut at = |nodes: &[Id], positions: &[Id], time| moved(graph, nodes, (positions, Some(&middle)), time);
    let (first, last) = (at(given.velocity, &start, t), at(given.velocity, &end, later));
    let (kick, kicked) = (at(given.force, &start, t), at(given.force, &end, later));
    let mut residual = vec![];
    for i in 0..n {
        let velocity = graph.add(first[i], last[i]);
        let shift = graph.mul(half, velocity);
        residual.push(graph.sub(dq[i], shift));
    }
    let kick = impulse(graph, &kick);
    for i in 0..n {
        let increment = graph.add(kick[i], pull[i]);
        residual.push(graph.sub(dp[i], increment));
    }
    residual.extend(given.bound(graph, &end));
    let last = impulse(graph, &kicked);
    let unknowns = all(given);
    Equation {
        residual,
        end: [dq, sums(graph, &dp, &last)].concat(),
        origin: given.origin(graph, &unknowns, Number::ONE),
        unknowns,
    }
}

/// The discrete gradient with constraints; time is that of the middle of the step.
pub(crate) fn gradient(graph: &mut Graph, given: &Given<'_>) -> Equation {
    let n = given.degrees();
    let h = graph.symbol(Symbol::StepLength);
    let two = Number::ONE.add(Number::ONE);
    let slopes: Vec<Vec<Id>> =
        given.constraints.iter().map(|constraint| discrete_gradient(graph, *constraint, n as u32).q).collect();
    let pull = pulls(graph, &slopes, two);
    let impulse: Vec<Id> = given.mean_force.iter().map(|force| graph.mul(h, *force)).collect();
    let impulse = sums(graph, &impulse, &pull);
    let [dq, dp] = increments(graph, n);
    let end = ends(graph, Symbol::Position, &dq);
    let less =
        |graph: &mut Graph, a: &[Id], b: &[Id]| a.iter().zip(b).map(|(a, b)| graph.sub(*a, *b)).collect::<Vec<_>>();
    let (unknowns, mut residual, added) = match given.mean_velocity {
        None => {
            let shift = shifts(graph, given.velocity, &impulse, Number::HALF);
            let unknowns = [(0..n as u32).map(Symbol::PositionIncrement).collect(), multipliers(given)].concat();
            (unknowns, less(graph, &dq, &shift), [shift, impulse].concat())
        }
        Some(velocity) => {
            let shift: Vec<Id> = velocity.iter().map(|velocity| graph.mul(h, *velocity)).collect();
            let rows = [less(graph, &dq, &shift), less(graph, &dp, &impulse)].concat();
            (all(given), rows, [dq, dp].concat())
        }
    };
    residual.extend(given.bound(graph, &end));
    Equation { residual, end: added, origin: given.origin(graph, &unknowns, two), unknowns }
}

fn multipliers(given: &Given<'_>) -> Vec<Symbol> {
    (0..given.constraints.len() as u32).map(Symbol::Multiplier).collect()
}

fn all(given: &Given<'_>) -> Vec<Symbol> {
    let n = given.degrees() as u32;
    (0..n)
        .map(Symbol::PositionIncrement)
        .chain((0..n).map(Symbol::MomentumIncrement))
        .chain(multipliers(given))
        .collect()
}

/// The increments of positions and momenta as unknowns.
fn increments(graph: &mut Graph, n: usize) -> [Vec<Id>; 2] {
    [Symbol::PositionIncrement, Symbol::MomentumIncrement]
        .map(|symbol: fn(u32) -> Symbol| (0..n as u32).map(|i| graph.symbol(symbol(i))).collect())
}

/// What multipliers add to momenta: a number of times Gᵀν/h.
fn pulls(graph: &mut Graph, gradients: &[Vec<Id>], times: Number) -> Vec<Id> {
    let h = graph.symbol(Symbol::StepLength);
    let weight = graph.recip(h);
    let weight = graph.scale(times, weight);
    let mut pull = |i: usize| {
        let mut terms = vec![];
        for (k, gradient) in (0..).zip(gradients) {
            let multiplier = graph.symbol(Symbol::Multiplier(k));
            terms.push(graph.product(&[weight, gradient[i], multiplier]));
        }
        graph.sum(&terms)
    };
    (0..gradients.first().map_or(0, Vec::len)).map(&mut pull).collect()
}

/// h ∂H/∂p where part of the increments was added to momenta.
fn shifts(graph: &mut Graph, velocity: &[Id], increments: &[Id], part: Number) -> Vec<Id> {
    let h = graph.symbol(Symbol::StepLength);
    let added: Vec<Id> = increments.iter().map(|increment| graph.scale(part, *increment)).collect();
    let momenta = ends(graph, Symbol::Momentum, &added);
    let mut there = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::Momentum(i) => Some(momenta[i as usize]),
        _ => None,
    });
    let mut shift = |velocity: &Id| {
        let velocity = there.apply(graph, *velocity);
        graph.mul(h, velocity)
    };
    velocity.iter().map(&mut shift).collect()
}

//! RATTLE and the discrete gradient with constraints, with multipliers ν, f = −∂H/∂q and v = ∂H/∂p.
//!
//! - RATTLE: p½ = p₀ + (h/2) f(q₀, p½) + Gᵀ(q₀) ν/h, q₁ = q₀ + (h/2) (v(q₀, p½) + v(q₁, p½)), g(q₁) = 0, p₁ = p½ + (h/2) f(q₁, p½). The runtime then projects p₁
//!   to the tangent space, with `Constrained::rates`. (H. C. Andersen 1983; L. O. Jay 1996 for general H.)
//! - Discrete gradient: q₁ = q₀ + h v̄, p₁ = p₀ + h f̄ + 2 Ḡᵀ ν/h, g(q₁) = 0, with discrete gradients v̄, f̄ and Ḡ (O. Gonzalez 1999).
//!
//! If H = T(p) + V(q) with a constant mass matrix, momenta determine positions: the unknowns are fewer then, and `mean_velocity` is absent.

use super::{Constrained, Equation};
use crate::diff::gradient::{discrete_gradient, with_values};
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Symbol};

/// RATTLE up to the momentum at the end, before its projection to the tangent space.
pub(crate) fn rattle(graph: &mut Graph, system: &Constrained<'_>) -> Equation {
    let n = system.degrees();
    let [h, t] = [Symbol::StepLength, Symbol::Time].map(|symbol| graph.symbol(symbol));
    let (half, end_time) = (graph.scale(Number::HALF, h), graph.add(t, h));
    let pull = pulls(graph, &system.gradients, Number::ONE);
    if system.mean_velocity.is_none() {
        let kick = scaled(graph, half, system.force);
        let increments = sums(graph, &kick, &pull);
        let shift = shifts(graph, system.velocity, &increments, Number::ONE);
        let end = ends(graph, Symbol::Position, &shift);
        let force = moved(graph, system.force, &end, None, end_time);
        let last = scaled(graph, half, &force);
        let unknowns = multipliers(system);
        return Equation {
            residual: system.constraints_at(graph, &end),
            end: [shift, sums(graph, &increments, &last)].concat(),
            origin: system.origin(graph, &unknowns, Number::ONE),
            unknowns,
        };
    }
    // Here Δp leads to the momenta in the middle of the step.
    let [dq, dp] = increments(graph, n);
    let [end, middle] = [ends(graph, Symbol::Position, &dq), ends(graph, Symbol::Momentum, &dp)];
    let start: Vec<Id> = (0..n as u32).map(|i| graph.symbol(Symbol::Position(i))).collect();
    let mut at = |nodes: &[Id], positions: &[Id], time| moved(graph, nodes, positions, Some(&middle), time);
    let (first, last) = (at(system.velocity, &start, t), at(system.velocity, &end, end_time));
    let (first_force, last_force) = (at(system.force, &start, t), at(system.force, &end, end_time));
    let velocity = sums(graph, &first, &last);
    let shift = scaled(graph, half, &velocity);
    let mut residual = differences(graph, &dq, &shift);
    let kick = scaled(graph, half, &first_force);
    let impulse = sums(graph, &kick, &pull);
    residual.extend(differences(graph, &dp, &impulse));
    residual.extend(system.constraints_at(graph, &end));
    let last = scaled(graph, half, &last_force);
    let unknowns = all_unknowns(system);
    Equation {
        residual,
        end: [dq, sums(graph, &dp, &last)].concat(),
        origin: system.origin(graph, &unknowns, Number::ONE),
        unknowns,
    }
}

/// The discrete gradient with constraints. The mean force already reads time in the middle of the step.
pub(crate) fn discrete_gradient_step(graph: &mut Graph, system: &Constrained<'_>) -> Equation {
    let n = system.degrees();
    let h = graph.symbol(Symbol::StepLength);
    // The mean momentum takes half of the impulse to the positions. With the factor 2, they move by W Gᵀν, as in RATTLE.
    let two = Number::integer(2);
    let slopes: Vec<Vec<Id>> =
        system.constraints.iter().map(|constraint| discrete_gradient(graph, *constraint, n as u32).q).collect();
    let pull = pulls(graph, &slopes, two);
    let impulse = scaled(graph, h, system.mean_force);
    let impulse = sums(graph, &impulse, &pull);
    let [dq, dp] = increments(graph, n);
    let at_end = ends(graph, Symbol::Position, &dq);
    let (unknowns, mut residual, end) = match system.mean_velocity {
        None => {
            let shift = shifts(graph, system.velocity, &impulse, Number::HALF);
            let unknowns = [(0..n as u32).map(Symbol::PositionIncrement).collect(), multipliers(system)].concat();
            (unknowns, differences(graph, &dq, &shift), [shift, impulse].concat())
        }
        Some(velocity) => {
            let shift = scaled(graph, h, velocity);
            let rows = [differences(graph, &dq, &shift), differences(graph, &dp, &impulse)].concat();
            (all_unknowns(system), rows, [dq, dp].concat())
        }
    };
    residual.extend(system.constraints_at(graph, &at_end));
    Equation { residual, end, origin: system.origin(graph, &unknowns, two), unknowns }
}

fn multipliers(system: &Constrained<'_>) -> Vec<Symbol> {
    (0..system.constraints.len() as u32).map(Symbol::Multiplier).collect()
}

/// The increments of positions and momenta, and the multipliers.
fn all_unknowns(system: &Constrained<'_>) -> Vec<Symbol> {
    let n = system.degrees() as u32;
    (0..n)
        .map(Symbol::PositionIncrement)
        .chain((0..n).map(Symbol::MomentumIncrement))
        .chain(multipliers(system))
        .collect()
}

/// The increments of positions and of momenta as nodes.
fn increments(graph: &mut Graph, n: usize) -> [Vec<Id>; 2] {
    [Symbol::PositionIncrement, Symbol::MomentumIncrement]
        .map(|symbol: fn(u32) -> Symbol| (0..n as u32).map(|i| graph.symbol(symbol(i))).collect())
}

/// The impulse `times`·Gᵀν/h of the multipliers.
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

/// h ∂H/∂p at the momenta p + part·increments.
fn shifts(graph: &mut Graph, velocity: &[Id], increments: &[Id], part: Number) -> Vec<Id> {
    let h = graph.symbol(Symbol::StepLength);
    let added: Vec<Id> = increments.iter().map(|increment| graph.scale(part, *increment)).collect();
    let momenta = ends(graph, Symbol::Momentum, &added);
    let velocity = with_values(graph, velocity, Symbol::Momentum, &momenta);
    scaled(graph, h, &velocity)
}

/// Coordinates after increments.
fn ends(graph: &mut Graph, coordinate: fn(u32) -> Symbol, increments: &[Id]) -> Vec<Id> {
    let mut end = |(i, increment): (u32, &Id)| {
        let start = graph.symbol(coordinate(i));
        graph.add(start, *increment)
    };
    (0..).zip(increments).map(&mut end).collect()
}

/// Nodes at other positions, at other momenta if given, and at another time.
fn moved(graph: &mut Graph, nodes: &[Id], positions: &[Id], momenta: Option<&[Id]>, time: Id) -> Vec<Id> {
    let mut moved = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::Position(i) => Some(positions[i as usize]),
        Symbol::Momentum(i) => momenta.map(|momenta| momenta[i as usize]),
        Symbol::Time => Some(time),
        _ => None,
    });
    nodes.iter().map(|node| moved.apply(graph, *node)).collect()
}

fn scaled(graph: &mut Graph, factor: Id, vector: &[Id]) -> Vec<Id> {
    vector.iter().map(|entry| graph.mul(factor, *entry)).collect()
}

fn sums(graph: &mut Graph, a: &[Id], b: &[Id]) -> Vec<Id> {
    a.iter().zip(b).map(|(a, b)| graph.add(*a, *b)).collect()
}

fn differences(graph: &mut Graph, a: &[Id], b: &[Id]) -> Vec<Id> {
    a.iter().zip(b).map(|(a, b)| graph.sub(*a, *b)).collect()
}

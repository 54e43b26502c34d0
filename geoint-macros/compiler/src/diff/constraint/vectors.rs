//! Vectors of nodes in the equations of a step: increments, ends, impulses.

use crate::diff::gradient::with_values;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Symbol};

/// The multipliers of so many rows.
pub(super) fn multipliers(count: usize) -> Vec<Symbol> {
    (0..count as u32).map(Symbol::Multiplier).collect()
}

/// The increments of positions and of momenta as nodes.
pub(super) fn increments(graph: &mut Graph, n: usize) -> [Vec<Id>; 2] {
    [Symbol::PositionIncrement, Symbol::MomentumIncrement]
        .map(|symbol: fn(u32) -> Symbol| (0..n as u32).map(|i| graph.symbol(symbol(i))).collect())
}

/// The impulse `times`·Aᵀμ/h of the multipliers μ.
pub(super) fn pulls(graph: &mut Graph, gradients: &[Vec<Id>], times: Number) -> Vec<Id> {
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

/// Σ weights[k]·rows[k].
pub(super) fn combination(graph: &mut Graph, rows: &[Vec<Id>], weights: &[Id]) -> Vec<Id> {
    let mut entry = |i: usize| {
        let products: Vec<Id> = rows.iter().zip(weights).map(|(row, weight)| graph.mul(row[i], *weight)).collect();
        graph.sum(&products)
    };
    (0..rows.first().map_or(0, Vec::len)).map(&mut entry).collect()
}

/// h ∂H/∂p at the momenta p + part·increments.
pub(super) fn shifts(graph: &mut Graph, velocity: &[Id], increments: &[Id], part: Number) -> Vec<Id> {
    let h = graph.symbol(Symbol::StepLength);
    let added: Vec<Id> = increments.iter().map(|increment| graph.scale(part, *increment)).collect();
    let momenta = ends(graph, Symbol::Momentum, &added);
    let velocity = with_values(graph, velocity, Symbol::Momentum, &momenta);
    scaled(graph, h, &velocity)
}

/// Coordinates after increments.
pub(super) fn ends(graph: &mut Graph, coordinate: fn(u32) -> Symbol, increments: &[Id]) -> Vec<Id> {
    let mut end = |(i, increment): (u32, &Id)| {
        let start = graph.symbol(coordinate(i));
        graph.add(start, *increment)
    };
    (0..).zip(increments).map(&mut end).collect()
}

/// Nodes at other positions, at other momenta if given, and at another time.
pub(super) fn moved(graph: &mut Graph, nodes: &[Id], positions: &[Id], momenta: Option<&[Id]>, time: Id) -> Vec<Id> {
    let mut moved = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::Position(i) => Some(positions[i as usize]),
        Symbol::Momentum(i) => momenta.map(|momenta| momenta[i as usize]),
        Symbol::Time => Some(time),
        _ => None,
    });
    nodes.iter().map(|node| moved.apply(graph, *node)).collect()
}

pub(super) fn scaled(graph: &mut Graph, factor: Id, vector: &[Id]) -> Vec<Id> {
    vector.iter().map(|entry| graph.mul(factor, *entry)).collect()
}

pub(super) fn sums(graph: &mut Graph, a: &[Id], b: &[Id]) -> Vec<Id> {
    a.iter().zip(b).map(|(a, b)| graph.add(*a, *b)).collect()
}

pub(super) fn differences(graph: &mut Graph, a: &[Id], b: &[Id]) -> Vec<Id> {
    a.iter().zip(b).map(|(a, b)| graph.sub(*a, *b)).collect()
}

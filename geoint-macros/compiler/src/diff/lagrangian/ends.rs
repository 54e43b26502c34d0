//! Sines and cosines at the end of a step by divided differences: f(q₁) = f(q₀) + f[q₀, q₁] (q₁ − q₀).
//!
//! The step needs the divided difference f[q₀, q₁] anyway. The formula takes two operations in place of a call.

use super::super::gradient::with_values;
use super::super::slope::Slopes;
use super::EulerLagrange;
use crate::ir::{Function, Graph, Id, Node, Symbol};

/// Returns pairs of a sine or cosine at the end of a step and its expression by a divided difference, for M, a and V.
pub(super) fn by_slopes(graph: &mut Graph, equation: EulerLagrange<'_>, increments: &[Id]) -> Vec<(Id, Id)> {
    let EulerLagrange { mass, shift, potential, .. } = equation;
    let roots: Vec<Id> = mass.iter().flatten().chain(shift).chain([&potential]).copied().collect();
    let mut slopes = Slopes::default();
    let mut replaced = vec![];
    for id in graph.reachable(&roots) {
        let circular = matches!(graph.node(id), Node::Call(Function::Sin | Function::Cos, _));
        // Slopes read the time of the middle of the step, so a call that reads time stays.
        if !circular || graph.reads(id).t || slopes.is_constant(graph, id) {
            continue;
        }
        let nodes = [slopes.end(graph, id), slopes.increment(graph, id)];
        let nodes = with_values(graph, &nodes, Symbol::PositionIncrement, increments);
        replaced.push((nodes[0], graph.add(id, nodes[1])));
    }
    replaced
}

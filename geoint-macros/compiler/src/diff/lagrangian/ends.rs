//! Sines and cosines at the end of a step from those at its start: f(q₁) = f(q₀) + f[q₀, q₁] (q₁ − q₀), where the divided difference is computed
//! anyway. Two operations in place of a call.

use super::super::slope::Slopes;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Symbol};

/// The sines and cosines at the end of a step, and such values in their place, of what `given` reads, where the increments of positions are
/// known.
pub(super) fn by_slopes(graph: &mut Graph, given: &[Id], increments: &[Id]) -> Vec<(Id, Id)> {
    let mut slopes = Slopes::default();
    let mut moved = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::PositionIncrement(i) => Some(increments[i as usize]),
        _ => None,
    });
    let mut replaced = vec![];
    for id in graph.reachable(given) {
        let circular = matches!(graph.node(id), Node::Call(Function::Sin | Function::Cos, _));
        // Time at the end is not that of the slopes.
        if !circular || graph.reads(id).t || slopes.is_constant(graph, id) {
            continue;
        }
        let end = slopes.end(graph, id);
        let end = moved.apply(graph, end);
        let increment = slopes.increment(graph, id);
        let increment = moved.apply(graph, increment);
        replaced.push((end, graph.add(id, increment)));
    }
    replaced
}

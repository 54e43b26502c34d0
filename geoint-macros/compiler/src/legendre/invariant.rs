//! Removes coordinates from entries of mass matrices that do not depend on them.
//!
//! Kinematics that are written step by step give sin²q + cos²q for 1, and cos a cos b + sin a sin b for cos(a − b). If a derivative is proven to
//! vanish everywhere, its coordinate can be set to zero.

use crate::analyze::{self, Direction, vanishes};
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Ratio, Symbol};

/// Returns a node that equals the entry and reads fewer coordinates, if possible. The result is zero, omits a coordinate, or reads two coordinates
/// through their sum or difference only.
pub(super) fn simplified(graph: &mut Graph, entry: Id) -> Id {
    if !graph.reads(entry).q || !is_total(graph, entry) || jumps(graph, entry) {
        return entry;
    }
    if vanishes(graph, entry) {
        return graph.zero();
    }
    let mut positions = graph.symbols(entry);
    positions.retain(|symbol| matches!(symbol, Symbol::Position(_)));
    let mut directions = directions(&positions);
    analyze::retain_constant(graph, entry, &mut directions);
    let mut entry = entry;
    for direction in directions {
        // An earlier direction may have removed a coordinate.
        let read = direction.iter().all(|(q, _)| graph.symbols(entry).contains(q));
        if read && is_constant(graph, entry, &direction) {
            entry = without_last(graph, entry, &direction);
        }
    }
    entry
}

/// Returns the directions of each coordinate alone, and of two coordinates with equal or opposite rates.
fn directions(positions: &[Symbol]) -> Vec<Direction> {
    let mut directions: Vec<Direction> = positions.iter().map(|q| vec![(*q, Ratio::ONE)]).collect();
    for (i, first) in positions.iter().enumerate() {
        for second in &positions[i + 1..] {
            directions.extend([Ratio::ONE, Ratio::ONE.neg()].map(|rate| vec![(*first, Ratio::ONE), (*second, rate)]));
        }
    }
    directions
}

/// Returns whether a node is proven to be constant along a direction. Precondition: the node does not jump.
fn is_constant(graph: &mut Graph, id: Id, direction: &Direction) -> bool {
    let rates: Vec<(Symbol, Id)> =
        direction.iter().map(|(symbol, rate)| (*symbol, graph.number(Number::Exact(*rate)))).collect();
    let rate = |symbol| rates.iter().find(|(other, _)| *other == symbol).map(|(_, rate)| *rate);
    let slope = diff::along(graph, &[id], rate);
    vanishes(graph, slope[0])
}

/// Moves a node along a direction until the last coordinate is zero. Precondition: the node is constant along the direction.
fn without_last(graph: &mut Graph, id: Id, direction: &Direction) -> Id {
    let (last, unit) = direction[direction.len() - 1];
    let replace = |graph: &mut Graph, symbol| {
        let (_, rate) = direction.iter().find(|(other, _)| *other == symbol)?;
        let [q, last] = [symbol, last].map(|symbol| graph.symbol(symbol));
        Some(if *rate == unit { graph.sub(q, last) } else { graph.add(q, last) })
    };
    Substitution::new(replace).apply(graph, id)
}

/// Returns whether a node is defined at every state.
fn is_total(graph: &Graph, id: Id) -> bool {
    !graph.reachable(&[id]).into_iter().any(|id| graph.is_partial(id) && graph.reads(id).state())
}

/// Returns whether a node may jump at a condition on positions. A jumping node with a slope of zero need not be constant.
fn jumps(graph: &mut Graph, id: Id) -> bool {
    analyze::conditions(graph, id).into_iter().any(|condition| graph.reads(condition).q)
}

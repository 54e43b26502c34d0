//! Removes coordinates that an entry of a mass matrix reads without depending on them.
//!
//! Kinematics that are written step by step give sin²q + cos²q for 1, and cos a cos b + sin a sin b for cos(a − b). If the derivative by a coordinate is
//! proven to vanish everywhere, the coordinate is set to zero. If the derivative along a sum or a difference of two coordinates vanishes, the entry depends
//! on the other combination only. Other directions, such as 2a − b, are not tried.

use crate::analyze::{self, Direction, vanishes};
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// Returns a node that equals the entry. It is zero, or omits coordinates, or reads two coordinates through their sum or difference only. Returns the
/// entry itself if nothing is proven.
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
    // A quick test at points drops most directions. Each remaining direction is proven below.
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

/// Returns whether a node is proven to be constant along a direction. Precondition: the node is defined everywhere and does not jump.
fn is_constant(graph: &mut Graph, id: Id, direction: &Direction) -> bool {
    let rates: Vec<(Symbol, Id)> =
        direction.iter().map(|(symbol, rate)| (*symbol, graph.number(Number::Exact(*rate)))).collect();
    let rate = |symbol| rates.iter().find(|(other, _)| *other == symbol).map(|(_, rate)| *rate);
    let slope = diff::along(graph, &[id], rate);
    vanishes(graph, slope[0])
}

/// Follows a direction to the point at which its last coordinate is zero, and returns the node there: f(q) → f(0), f(a, b) → f(a − b, 0) or
/// f(a + b, 0). Precondition: the node is constant along the direction. All rates are 1 or −1.
fn without_last(graph: &mut Graph, id: Id, direction: &Direction) -> Id {
    let (last, rate_of_last) = direction[direction.len() - 1];
    let replace = |graph: &mut Graph, symbol| {
        let (_, rate) = direction.iter().find(|(other, _)| *other == symbol)?;
        let [q, way] = [symbol, last].map(|symbol| graph.symbol(symbol));
        Some(if *rate == rate_of_last { graph.sub(q, way) } else { graph.add(q, way) })
    };
    Substitution::new(replace).apply(graph, id)
}

/// Returns whether a node is defined at every state.
fn is_total(graph: &Graph, id: Id) -> bool {
    !graph.reachable(&[id]).into_iter().any(|id| graph.is_partial(id) && graph.reads(id).state())
}

/// Returns whether a node may jump: it has a condition on positions, a sign, or an angle by `atan2`. A node with jumps need not be constant if its slope
/// is zero.
fn jumps(graph: &mut Graph, id: Id) -> bool {
    let is_angle = |id: Id| matches!(graph.node(id), Node::Call(Function::Atan2, _)) && graph.reads(id).q;
    let angle = graph.reachable(&[id]).into_iter().any(is_angle);
    angle || analyze::conditions(graph, id).into_iter().any(|condition| graph.reads(condition).q)
}

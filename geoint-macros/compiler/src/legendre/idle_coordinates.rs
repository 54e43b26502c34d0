//! Removes idle coordinates, alone or in pairs: those that an entry of a mass matrix reads without depending on them.
//!
//! Kinematics that are written step by step give sin²q + cos²q for 1, and cos a cos b + sin a sin b for cos(a − b). Without idle coordinates more mass matrices
//! are constant, and all derivatives are shorter.
//!
//! If the derivative with respect to a coordinate is proven to vanish everywhere, the coordinate is set to zero. If the derivative along the direction (1, 1) of two
//! coordinates a and b vanishes, the entry is a function of a − b. For the direction (1, −1) it is a function of a + b. Other directions, such as (1, 2), are not
//! tried. Entries that may jump, or that are undefined at some states, stay as they are: a zero derivative does not prove that they are constant.

use crate::analyze::{self, Direction, vanishes};
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// Returns a node that equals the entry. It is zero, or omits coordinates, or reads two coordinates through their sum or difference only. Returns the
/// entry itself if nothing is proven.
pub(super) fn without_idle_coordinates(graph: &mut Graph, entry: Id) -> Id {
    if !graph.reads(entry).q || !is_total(graph, entry) || jumps(graph, entry) {
        return entry;
    }
    let mut positions = graph.symbols(entry);
    positions.retain(|symbol| matches!(symbol, Symbol::Position(_)));
    let mut directions = directions(&positions);
    // A quick test at points drops most directions. Each remaining direction is proven below.
    analyze::retain_likely_constant(graph, entry, &mut directions);
    if directions.is_empty() {
        return entry;
    }
    if vanishes(graph, entry) {
        return graph.zero();
    }
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
    let derivative = diff::along(graph, &[id], rate);
    vanishes(graph, derivative[0])
}

/// Follows a direction to the point at which its last coordinate is zero, and returns the node there: f(q) → f(0), f(a, b) → f(a − b, 0) or
/// f(a + b, 0). Precondition: the node is constant along the direction. All rates are 1 or −1.
fn without_last(graph: &mut Graph, id: Id, direction: &Direction) -> Id {
    let (last, rate_of_last) = direction[direction.len() - 1];
    let replace = |graph: &mut Graph, symbol| {
        let (_, rate) = direction.iter().find(|(other, _)| *other == symbol)?;
        let [coordinate, distance] = [symbol, last].map(|symbol| graph.symbol(symbol));
        Some(if *rate == rate_of_last { graph.sub(coordinate, distance) } else { graph.add(coordinate, distance) })
    };
    Substitution::new(replace).apply(graph, id)
}

/// Returns whether a node is defined at every state. Nodes of parameters alone are undefined at all states or at none, so they do not count.
fn is_total(graph: &Graph, id: Id) -> bool {
    !graph.reachable(&[id]).into_iter().any(|id| graph.is_partial(id) && graph.reads(id).state())
}

/// Returns whether a node may jump: it has a condition or a sign that reads positions, or an angle by `atan2`. A node with jumps need not be constant if its
/// derivative is zero.
fn jumps(graph: &mut Graph, id: Id) -> bool {
    let is_angle = |id: Id| matches!(graph.node(id), Node::Call(Function::Atan2, _)) && graph.reads(id).q;
    let angle = graph.reachable(&[id]).into_iter().any(is_angle);
    angle || analyze::conditions(graph, id).into_iter().any(|condition| graph.reads(condition).q)
}

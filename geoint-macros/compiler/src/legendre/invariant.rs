//! Entries of mass matrices without coordinates on which they do not depend.
//!
//! Kinematics that are written step by step give sin²q + cos²q for 1, and cos a cos b + sin a sin b for cos(a − b). That a derivative
//! vanishes everywhere is proven, so that the coordinate may be put to zero.

use crate::analyze::{self, Direction, vanishes};
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Ratio, Symbol};

/// A node that is equal to an entry wherever that is defined, and reads fewer coordinates if that is possible: zero; or without one of them;
/// or by the difference, or sum, of two.
pub(super) fn simplified(graph: &mut Graph, entry: Id) -> Id {
    if !graph.reads(entry).q || !is_total(graph, entry) || jumps(graph, entry) {
        return entry;
    }
    if vanishes(graph, entry) {
        return graph.zero();
    }
    let mut directions = directions(&positions(graph, entry));
    analyze::retain_constant(graph, entry, &mut directions);
    let mut entry = entry;
    for direction in directions {
        // Coordinates may be gone by now.
        let read = direction.iter().all(|(q, _)| graph.symbols(entry).contains(q));
        if read && is_constant(graph, entry, &direction) {
            entry = without_last(graph, entry, &direction);
        }
    }
    entry
}

/// Of each coordinate alone, and of two, by the same or by opposite amounts.
fn directions(positions: &[Symbol]) -> Vec<Direction> {
    let mut directions: Vec<Direction> = positions.iter().map(|q| vec![(*q, Ratio::ONE)]).collect();
    for (i, first) in positions.iter().enumerate() {
        for second in &positions[i + 1..] {
            directions.extend([Ratio::ONE, Ratio::ONE.neg()].map(|rate| vec![(*first, Ratio::ONE), (*second, rate)]));
        }
    }
    directions
}

/// Whether a node that does not jump is proven to be constant along a direction.
fn is_constant(graph: &mut Graph, id: Id, direction: &Direction) -> bool {
    let rates: Vec<(Symbol, Id)> =
        direction.iter().map(|(symbol, rate)| (*symbol, graph.number(Number::Exact(*rate)))).collect();
    let rate = |symbol| rates.iter().find(|(other, _)| *other == symbol).map(|(_, rate)| *rate);
    let slope = diff::along(graph, &[id], rate);
    vanishes(graph, slope[0])
}

/// A node that is constant along a direction, where the last coordinate is zero.
fn without_last(graph: &mut Graph, id: Id, direction: &Direction) -> Id {
    let (last, unit) = direction[direction.len() - 1];
    let replace = |graph: &mut Graph, symbol| {
        let (_, rate) = direction.iter().find(|(other, _)| *other == symbol)?;
        let [q, last] = [symbol, last].map(|symbol| graph.symbol(symbol));
        Some(if *rate == unit { graph.sub(q, last) } else { graph.add(q, last) })
    };
    Substitution::new(replace).apply(graph, id)
}

/// Whether a node is defined everywhere.
fn is_total(graph: &Graph, id: Id) -> bool {
    !graph.reachable(&[id]).into_iter().any(|id| graph.is_partial(id) && graph.reads(id).state())
}

/// Whether a node may jump: a slope that vanishes everywhere then says nothing of its values.
fn jumps(graph: &mut Graph, id: Id) -> bool {
    let mut conditions = analyze::conditions(graph, id);
    conditions.retain(|condition| graph.reads(*condition).q);
    !conditions.is_empty()
}

/// The coordinates that a node reads.
fn positions(graph: &Graph, id: Id) -> Vec<Symbol> {
    graph.symbols(id).into_iter().filter(|symbol| matches!(symbol, Symbol::Position(_))).collect()
}

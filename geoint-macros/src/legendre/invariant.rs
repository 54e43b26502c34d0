//! Entries of mass matrices without coordinates on which they do not depend.
//!
//! Kinematics that are written step by step give sin²q + cos²q for 1, and cos a cos b + sin a sin b for cos(a − b). That a derivative
//! vanishes everywhere is proven, so that the coordinate may be put to zero.

use crate::analyze::{self, vanishes};
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Symbol};

/// A node that is equal to an entry wherever that is defined, and reads fewer coordinates if that is possible: zero; or without one of them;
/// or by the difference, or sum, of two.
pub(super) fn simplified(graph: &mut Graph, entry: Id) -> Id {
    if !graph.reads(entry).q || !is_total(graph, entry) || jumps(graph, entry) {
        return entry;
    }
    if vanishes(graph, entry) {
        return graph.zero();
    }
    let mut entry = entry;
    for k in positions(graph, entry) {
        let slope = diff::partial(graph, entry, Symbol::Q(k));
        if vanishes(graph, slope) {
            entry = with(graph, entry, |graph, i| (i == k).then(|| graph.zero()));
        }
    }
    let left = positions(graph, entry);
    for (k, l) in left.iter().enumerate().flat_map(|(i, k)| left[i + 1..].iter().map(move |l| (*k, *l))) {
        let [first, second] = [k, l].map(|i| diff::partial(graph, entry, Symbol::Q(i)));
        for (together, opposite) in [(graph.add(first, second), true), (graph.sub(first, second), false)] {
            // Coordinates of the other terms may be gone by now.
            if positions(graph, entry).contains(&l) && vanishes(graph, together) {
                entry = with(graph, entry, |graph, i| {
                    let [q, other] = [k, l].map(|i| graph.symbol(Symbol::Q(i)));
                    match i {
                        _ if i == l => Some(graph.zero()),
                        _ if i == k => Some(if opposite { graph.sub(q, other) } else { graph.add(q, other) }),
                        _ => None,
                    }
                });
            }
        }
    }
    entry
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
fn positions(graph: &Graph, id: Id) -> Vec<u32> {
    let position = |symbol: &Symbol| match symbol {
        Symbol::Q(i) => Some(*i),
        _ => None,
    };
    graph.symbols(id).iter().filter_map(position).collect()
}

/// A node with something in place of some coordinates.
fn with(graph: &mut Graph, id: Id, replaced: impl Fn(&mut Graph, u32) -> Option<Id>) -> Id {
    let replace = |graph: &mut Graph, symbol| match symbol {
        Symbol::Q(i) => replaced(graph, i),
        _ => None,
    };
    Substitution::new(replace).apply(graph, id)
}

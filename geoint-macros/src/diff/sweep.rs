//! The reverse sweep, for derivatives and for divided differences: only the rules differ.

use super::rules::{Derivative, derivative};
use crate::ir::{Graph, Id, Node, Symbol};
use std::collections::{BTreeMap, BTreeSet};

/// The derivative with respect to each symbol of phase space that the root reads.
pub(super) type Entries = BTreeMap<Symbol, Id>;

/// How the change of a node is passed on.
pub(super) enum Step {
    /// Σ coefficient·(change of operand).
    Operands(Vec<(Id, Id)>),
    /// Σ coefficient·(change of coordinate).
    Coordinates(Entries),
}

/// The derivatives of `root`.
pub(super) fn gradient(graph: &mut Graph, root: Id) -> Entries {
    reverse(graph, root, &mut |graph, id| match derivative(graph, id) {
        Derivative::Chain(partials) => Step::Operands(partials),
        // Each side is swept on its own, so that what belongs to a branch is computed in that branch only.
        Derivative::Branch(condition, first, second) => {
            let (first, second) = (gradient(graph, first), gradient(graph, second));
            Step::Coordinates(select(graph, condition, &first, &second))
        }
    })
}

/// Sweeps from `root` to the coordinates.
pub(super) fn reverse(graph: &mut Graph, root: Id, step: &mut impl FnMut(&mut Graph, Id) -> Step) -> Entries {
    let order = graph.reachable(&[root]);
    let mut active = vec![false; graph.len()];
    for id in &order {
        active[id.index()] = match graph.node(*id) {
            Node::Symbol(symbol) => symbol.is_coordinate(),
            node => node.children().iter().any(|child| active[child.index()]),
        };
    }
    let mut adjoints: BTreeMap<Id, Vec<Id>> = BTreeMap::from([(root, vec![graph.integer(1)])]);
    let mut entries: BTreeMap<Symbol, Vec<Id>> = BTreeMap::new();
    for id in order.into_iter().rev().filter(|id| active[id.index()]) {
        let Some(contributions) = adjoints.remove(&id) else { continue };
        let adjoint = graph.sum(&contributions);
        if let Node::Symbol(symbol) = graph.node(id) {
            entries.entry(*symbol).or_default().push(adjoint);
            continue;
        }
        match step(graph, id) {
            Step::Operands(partials) => {
                for (operand, partial) in partials {
                    if active[operand.index()] {
                        adjoints.entry(operand).or_default().push(graph.mul(adjoint, partial));
                    }
                }
            }
            Step::Coordinates(partials) => {
                for (symbol, partial) in partials {
                    entries.entry(symbol).or_default().push(graph.mul(adjoint, partial));
                }
            }
        }
    }
    entries.into_iter().map(|(symbol, parts)| (symbol, graph.sum(&parts))).collect()
}

/// Either side's entries.
pub(super) fn select(graph: &mut Graph, condition: Id, first: &Entries, second: &Entries) -> Entries {
    let zero = graph.zero();
    let side = |side: &Entries, symbol| side.get(&symbol).copied().unwrap_or(zero);
    let symbols: BTreeSet<_> = first.keys().chain(second.keys()).copied().collect();
    symbols.into_iter().map(|s| (s, graph.select(condition, side(first, s), side(second, s)))).collect()
}

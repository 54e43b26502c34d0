//! The reverse sweep over the graph. Derivatives and divided differences share it, and differ in the rules for a node only.

use super::rules::{Derivative, derivative};
use crate::ir::{Graph, Id, Node, Symbol, Table};
use std::collections::{BTreeMap, BTreeSet};

/// The derivatives with respect to the coordinates that the root reads.
pub(super) type Entries = BTreeMap<Symbol, Id>;

/// How a sweep passes the change of a node on.
pub(super) enum Step {
    /// The change is Σ coefficient·(change of operand). The pairs are (operand, coefficient).
    Operands(Vec<(Id, Id)>),
    /// The change is Σ coefficient·(change of coordinate).
    Coordinates(Entries),
}

/// Computes the derivatives of `root`.
pub(super) fn gradient(graph: &mut Graph, root: Id) -> Entries {
    reverse(graph, root, &mut |graph, id| match derivative(graph, id) {
        Derivative::Chain(partials) => Step::Operands(partials),
        // Sweep each branch separately, so that its operations are computed in that branch only.
        Derivative::Branch(condition, first, second) => {
            let (first, second) = (gradient(graph, first), gradient(graph, second));
            Step::Coordinates(select(graph, condition, &first, &second))
        }
    })
}

/// Sweeps from `root` to the coordinates, with `step` as the rule for a node.
pub(super) fn reverse(graph: &mut Graph, root: Id, step: &mut impl FnMut(&mut Graph, Id) -> Step) -> Entries {
    let order = graph.reachable(&[root]);
    // Index of the contributions to the adjoint of each node that reads a coordinate.
    let mut active: Table<usize> = Table::default();
    let mut adjoints: Vec<Vec<Id>> = vec![];
    for id in &order {
        let mut reads = matches!(graph.node(*id), Node::Symbol(symbol) if symbol.is_coordinate());
        graph.node(*id).for_each_child(|child| reads |= active.contains(child));
        if reads {
            active.insert(*id, adjoints.len());
            adjoints.push(vec![]);
        }
    }
    if let Some(place) = active.get(root) {
        adjoints[place].push(graph.integer(1));
    }
    let mut entries: BTreeMap<Symbol, Vec<Id>> = BTreeMap::new();
    for id in order.into_iter().rev() {
        let Some(place) = active.get(id) else { continue };
        let contributions = std::mem::take(&mut adjoints[place]);
        if contributions.is_empty() {
            continue;
        }
        let adjoint = graph.sum(&contributions);
        if let Node::Symbol(symbol) = graph.node(id) {
            entries.entry(*symbol).or_default().push(adjoint);
            continue;
        }
        match step(graph, id) {
            Step::Operands(partials) => {
                for (operand, partial) in partials {
                    if let Some(place) = active.get(operand) {
                        adjoints[place].push(graph.mul(adjoint, partial));
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

/// Selects between the entries of two branches.
pub(super) fn select(graph: &mut Graph, condition: Id, first: &Entries, second: &Entries) -> Entries {
    let zero = graph.zero();
    let side = |side: &Entries, symbol| side.get(&symbol).copied().unwrap_or(zero);
    let symbols: BTreeSet<_> = first.keys().chain(second.keys()).copied().collect();
    symbols.into_iter().map(|s| (s, graph.select(condition, side(first, s), side(second, s)))).collect()
}

//! The reverse sweep, for derivatives and for divided differences: only the rules differ.

use super::rules::Rule;
use crate::ir::{Graph, Id, Node, Symbol};
use std::collections::BTreeMap;

/// The derivative with respect to each symbol of phase space that the root reads.
pub(super) type Entries = BTreeMap<Symbol, Id>;

/// Sweeps from `root` to the coordinates.
pub(super) fn reverse<E>(
    graph: &mut Graph,
    root: Id,
    rule: &mut impl FnMut(&mut Graph, Id) -> Result<Rule, E>,
) -> Result<Entries, E> {
    let order = graph.reachable(&[root]);
    let mut active = vec![false; graph.len()];
    for id in &order {
        active[id.index()] = match graph.node(*id) {
            Node::Symbol(Symbol::Q(_) | Symbol::P(_)) => true,
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
        match rule(graph, id)? {
            Rule::Chain(partials) => {
                for (operand, partial) in partials {
                    if active[operand.index()] {
                        let contribution = graph.mul(adjoint, partial);
                        adjoints.entry(operand).or_default().push(contribution);
                    }
                }
            }
            // Each side is swept on its own, so that what belongs to a branch is computed in that branch only.
            Rule::Branch(condition, first, second) => {
                let (first, second) = (reverse(graph, first, rule)?, reverse(graph, second, rule)?);
                let zero = graph.zero();
                let symbols: std::collections::BTreeSet<_> = first.keys().chain(second.keys()).copied().collect();
                for symbol in symbols {
                    let side = |side: &Entries| side.get(&symbol).copied().unwrap_or(zero);
                    let selected = graph.select(condition, side(&first), side(&second));
                    let contribution = graph.mul(adjoint, selected);
                    entries.entry(symbol).or_default().push(contribution);
                }
            }
        }
    }
    Ok(entries.into_iter().map(|(symbol, parts)| (symbol, graph.sum(&parts))).collect())
}

//! Conditions of an energy: by how much it jumps where one of them changes.

use super::enclosable::enclosable;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Relation};

/// The jump of the energy at a condition that reads the state. Conditions on time or parameters alone do not change along a solution of an autonomous
/// system.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jump {
    /// 1 where it holds, −1 where it does not.
    pub(crate) side: Id,
    /// The energy if it holds, less the energy if it does not.
    pub(crate) shown: Id,
    /// The same, rearranged so that intervals enclose it well. Messages have `shown`.
    pub(crate) height: Id,
}

/// The conditions of an energy, signs of numbers among them.
pub(crate) fn jumps(graph: &mut Graph, energy: Id) -> Vec<Jump> {
    let mut conditions = conditions(graph, energy);
    conditions.retain(|condition| graph.reads(*condition).state());
    let mut jump = |condition| {
        let there = at_boundary(graph, energy, condition);
        let [yes, no] = [true, false].map(|holds| decided(graph, there, condition, holds));
        let shown = graph.sub(yes, no);
        let sides = [graph.integer(1), graph.integer(-1)];
        Jump { side: graph.select(condition, sides[0], sides[1]), shown, height: enclosable(graph, shown) }
    };
    conditions.into_iter().map(&mut jump).collect()
}

/// A node at the boundary of a condition on x, such as x < 3. There x is 3, and this decides whether x < 2 and x < 4. In a table of pieces the jump
/// at a bound then reads the two pieces beside it only. Bounds that are not numbers decide nothing.
fn at_boundary(graph: &mut Graph, node: Id, condition: Id) -> Id {
    let Node::Compare(_, left, right) = *graph.node(condition) else { return node };
    let [x, bound] = if graph.as_number(right).is_some() { [left, right] } else { [right, left] };
    if graph.as_number(bound).is_none() {
        return node;
    }
    let mut form = Substitution::new(|_: &mut Graph, _| None);
    for id in graph.reachable(&[node]) {
        let Node::Compare(relation, a, b) = *graph.node(id) else { continue };
        let [a, b] = [a, b].map(|side| if side == x { bound } else { side });
        // A condition with the same bound changes at the same place: it stays open.
        if a != b {
            let known = graph.compare(relation, a, b);
            if graph.as_truth(known).is_some() {
                form.insert(id, known);
            }
        }
    }
    form.apply(graph, node)
}

/// The conditions that a node reads; x < 0 for the sign of x.
pub(crate) fn conditions(graph: &mut Graph, node: Id) -> Vec<Id> {
    let mut conditions: Vec<Id> = vec![];
    for id in graph.reachable(&[node]) {
        let condition = match *graph.node(id) {
            Node::Select(condition, ..) => condition,
            Node::Call(Function::Signum, ref args) => {
                let x = args[0];
                let zero = graph.zero();
                graph.compare(Relation::Less, x, zero)
            }
            _ => continue,
        };
        if !conditions.contains(&condition) {
            conditions.push(condition);
        }
    }
    conditions
}

/// A node with a condition decided.
pub(crate) fn decided(graph: &mut Graph, node: Id, condition: Id, holds: bool) -> Id {
    let mut form = Substitution::new(|_: &mut Graph, _| None);
    for id in graph.reachable(&[node]) {
        let replacement = match *graph.node(id) {
            Node::Select(own, first, second) if own == condition => {
                form.apply(graph, if holds { first } else { second })
            }
            Node::Call(Function::Signum, ref args) => {
                let (x, zero) = (args[0], graph.zero());
                if graph.compare(Relation::Less, x, zero) != condition {
                    continue;
                }
                graph.integer(if holds { -1 } else { 1 })
            }
            _ => continue,
        };
        form.insert(id, replacement);
    }
    form.apply(graph, node)
}

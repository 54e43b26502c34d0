//! The jumps of an energy at its conditions.

use super::enclosable::enclosable;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Relation};

/// The jump of the energy at a condition that reads the state. Conditions on time or parameters alone do not change along a solution of an autonomous
/// system.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Jump {
    /// 1 where the condition holds, −1 elsewhere.
    pub(crate) side: Id,
    /// The energy if the condition holds, less the energy if it does not.
    pub(crate) shown: Id,
    /// `shown`, rearranged so that intervals enclose it tightly. Messages print `shown`.
    pub(crate) height: Id,
}

/// Returns the jumps at all conditions of an energy. The sign of a number counts as a condition.
pub(crate) fn jumps(graph: &mut Graph, energy: Id) -> Vec<Jump> {
    let mut conditions = conditions(graph, energy);
    conditions.retain(|condition| graph.reads(*condition).state());
    let mut jump = |condition| {
        let there = at_boundary(graph, energy, condition);
        let shown = jump_of(graph, there, condition);
        let [inside, outside] = [1, -1].map(|side| graph.integer(side));
        Jump { side: graph.select(condition, inside, outside), shown, height: enclosable(graph, shown) }
    };
    conditions.into_iter().map(&mut jump).collect()
}

/// Returns a node at the boundary of a condition on x, such as x < 3. There x is 3, which decides conditions such as x < 2 and x < 4. The jump at a
/// bound in a table of pieces then reads only the two pieces beside the bound. Bounds that are not numbers decide nothing.
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
        // A condition with the same bound changes at the same place, so it stays open.
        if a != b {
            let known = graph.compare(relation, a, b);
            if graph.as_truth(known).is_some() {
                form.insert(id, known);
            }
        }
    }
    form.apply(graph, node)
}

/// Returns the conditions that a node reads. The sign of x has the condition x < 0.
pub(crate) fn conditions(graph: &mut Graph, node: Id) -> Vec<Id> {
    let mut conditions: Vec<Id> = vec![];
    for id in graph.reachable(&[node]) {
        let condition = match *graph.node(id) {
            Node::Select(condition, ..) => condition,
            Node::Call(Function::Signum, ref args) => is_negative(graph, args[0]),
            _ => continue,
        };
        if !conditions.contains(&condition) {
            conditions.push(condition);
        }
    }
    conditions
}

/// Returns a node where a condition holds, less the node where it does not hold.
pub(crate) fn jump_of(graph: &mut Graph, node: Id, condition: Id) -> Id {
    let [yes, no] = [true, false].map(|holds| {
        let mut form = Substitution::new(|_: &mut Graph, _| None);
        for id in graph.reachable(&[node]) {
            let replacement = match *graph.node(id) {
                Node::Select(own, first, second) if own == condition => {
                    form.apply(graph, if holds { first } else { second })
                }
                Node::Call(Function::Signum, ref args) => {
                    if is_negative(graph, args[0]) != condition {
                        continue;
                    }
                    graph.integer(if holds { -1 } else { 1 })
                }
                _ => continue,
            };
            form.insert(id, replacement);
        }
        form.apply(graph, node)
    });
    graph.sub(yes, no)
}

/// Builds x < 0.
fn is_negative(graph: &mut Graph, x: Id) -> Id {
    let zero = graph.zero();
    graph.compare(Relation::Less, x, zero)
}

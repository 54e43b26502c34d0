//! Terms of a function that jump by 2π times their slope, because they read an angle computed by `atan2`.

use crate::ir::{Function, Graph, Id, Node, Number, Ratio};
use std::collections::HashSet;

/// Returns the terms of a function that jump where an angle of the state crosses its branch cut.
pub(crate) fn turning_terms(graph: &Graph, function: Id) -> Vec<Id> {
    let terms = match graph.node(function) {
        Node::Linear(_, terms) => terms.iter().map(|(_, term)| *term).collect(),
        _ => vec![function],
    };
    terms.into_iter().filter(|term| reads_turns(graph, *term)).collect()
}

/// Returns an angle of the state whose turns do not add multiples of one constant to a function, as in θ² or cos(θ/2).
pub(crate) fn irregular_turn(graph: &Graph, function: Id) -> Option<Id> {
    let mut open = turning_terms(graph, function);
    while let Some(term) = open.pop() {
        let mut moving = graph.factors(term);
        moving.retain(|(base, _)| graph.reads(*base).moves());
        match moving[..] {
            [(angle, Ratio::ONE)] if is_angle(graph, angle) => {}
            // A constant times a sum.
            [(sum, Ratio::ONE)] if matches!(graph.node(sum), Node::Linear(..)) => {
                open.extend(turning_terms(graph, sum))
            }
            _ => return graph.reachable(&[term]).into_iter().find(|id| is_angle(graph, *id)),
        }
    }
    None
}

/// Returns whether a node reads an angle otherwise than by the sine, cosine or tangent of its integer multiples.
fn reads_turns(graph: &Graph, root: Id) -> bool {
    let (mut open, mut seen) = (vec![root], HashSet::new());
    while let Some(id) = open.pop() {
        if is_angle(graph, id) {
            return true;
        }
        if !seen.insert(id) {
            continue;
        }
        match graph.node(id) {
            Node::Call(Function::Sin | Function::Cos | Function::Tan, args) => {
                open.extend(without_whole_turns(graph, args[0]));
            }
            node => open.extend(node.children()),
        }
    }
    false
}

/// Returns whether a node is an angle that changes along a motion.
fn is_angle(graph: &Graph, id: Id) -> bool {
    matches!(graph.node(id), Node::Call(Function::Atan2, _)) && graph.reads(id).moves()
}

/// Returns the terms of the argument of a periodic function, without integer multiples of angles.
fn without_whole_turns(graph: &Graph, argument: Id) -> Vec<Id> {
    let is_whole = |coefficient: &Number| matches!(coefficient, Number::Exact(ratio) if ratio.is_integer());
    let (mut open, mut rest) = (vec![argument], vec![]);
    while let Some(id) = open.pop() {
        match graph.node(id) {
            Node::Linear(_, terms) => {
                for (coefficient, term) in terms {
                    if is_whole(coefficient) { open.push(*term) } else { rest.push(*term) }
                }
            }
            _ if is_angle(graph, id) => {}
            _ => rest.push(id),
        }
    }
    rest
}

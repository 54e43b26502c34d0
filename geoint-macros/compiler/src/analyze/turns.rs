//! Terms of a function that jump because an angle by `atan2` in them jumps by 2π where it comes round.

use crate::ir::{Function, Graph, Id, Node, Number};
use std::collections::HashSet;

/// The terms of a function that jump where an angle of the state comes round.
pub(crate) fn turning_terms(graph: &Graph, function: Id) -> Vec<Id> {
    let terms = match graph.node(function) {
        Node::Linear(_, terms) => terms.iter().map(|(_, term)| *term).collect(),
        _ => vec![function],
    };
    terms.into_iter().filter(|term| reads_turns(graph, *term)).collect()
}

/// Returns whether a node reads an angle otherwise than by the sine, cosine or tangent of its whole multiples.
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

/// An angle that the state or time changes.
fn is_angle(graph: &Graph, id: Id) -> bool {
    let reads = graph.reads(id);
    matches!(graph.node(id), Node::Call(Function::Atan2, _)) && (reads.state() || reads.t)
}

/// The terms of the argument of a periodic function, without whole multiples of angles.
fn without_whole_turns(graph: &Graph, argument: Id) -> Vec<Id> {
    let whole = |coefficient: Number| matches!(coefficient, Number::Exact(ratio) if ratio.is_integer());
    let terms = match graph.node(argument) {
        Node::Linear(_, terms) => terms.to_vec(),
        _ => vec![(Number::ONE, argument)],
    };
    let left = terms.into_iter().filter(|(coefficient, term)| !(whole(*coefficient) && is_angle(graph, *term)));
    left.map(|(_, term)| term).collect()
}

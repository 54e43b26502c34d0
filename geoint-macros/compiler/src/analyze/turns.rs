//! Terms of a function that jump by 2π times their slope, because they read an angle computed by `atan2`.

use crate::ir::{Function, Graph, Id, Node, Number};
use std::collections::HashSet;

/// Returns the terms of a function that jump where an angle of the state crosses its branch cut.
pub(crate) fn turning_terms(graph: &Graph, function: Id) -> Vec<Id> {
    let terms = match graph.node(function) {
        Node::Linear(_, terms) => terms.iter().map(|(_, term)| *term).collect(),
        _ => vec![function],
    };
    terms.into_iter().filter(|term| reads_turns(graph, *term)).collect()
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
    let whole = |coefficient: Number| matches!(coefficient, Number::Exact(ratio) if ratio.is_integer());
    let terms = match graph.node(argument) {
        Node::Linear(_, terms) => terms.to_vec(),
        _ => vec![(Number::ONE, argument)],
    };
    let left = terms.into_iter().filter(|(coefficient, term)| !(whole(*coefficient) && is_angle(graph, *term)));
    left.map(|(_, term)| term).collect()
}

//! An expression in a form whose evaluation with intervals is tight: no condition, no product of a number with itself.

use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Number, Relation};

/// The same function with |x|ⁿ for xⁿ of even n, and w·a + (1 − w)·b for `if c { a } else { b }`, where w is 1 if c holds, and between 0
/// and 1 where that is not known.
pub(crate) fn enclosable(graph: &mut Graph, root: Id) -> Id {
    let mut form = Substitution::new(|_: &mut Graph, _| None);
    for id in graph.reachable(&[root]) {
        let replacement = match *graph.node(id) {
            Node::Power(base, exponent) if exponent.is_integer() && exponent.numerator % 2 == 0 => {
                let base = form.apply(graph, base);
                let size = graph.call(Function::Abs, &[base]);
                graph.pow(size, exponent)
            }
            Node::Select(condition, first, second) => {
                let (first, second) = (form.apply(graph, first), form.apply(graph, second));
                let margin = margin(graph, condition);
                let margin = form.apply(graph, margin);
                let sign = graph.call(Function::Signum, &[margin]);
                let (half, one) = (graph.number(Number::HALF), graph.integer(1));
                let weight = graph.scale(Number::HALF, sign);
                let weight = graph.add(half, weight);
                let rest = graph.sub(one, weight);
                let sides = [graph.mul(weight, first), graph.mul(rest, second)];
                graph.sum(&sides)
            }
            _ => continue,
        };
        form.insert(id, replacement);
    }
    form.apply(graph, root)
}

/// A number that is positive where a condition holds, negative where it does not, and zero on the border.
pub(super) fn margin(graph: &mut Graph, condition: Id) -> Id {
    match *graph.node(condition) {
        Node::Compare(Relation::Equal, a, b) => {
            let difference = graph.sub(b, a);
            let distance = graph.call(Function::Abs, &[difference]);
            graph.neg(distance)
        }
        Node::Compare(_, a, b) => graph.sub(b, a),
        Node::And(a, b) => {
            let sides = [margin(graph, a), margin(graph, b)];
            graph.call(Function::Min, &sides)
        }
        Node::Or(a, b) => {
            let sides = [margin(graph, a), margin(graph, b)];
            graph.call(Function::Max, &sides)
        }
        Node::Not(a) => {
            let opposite = margin(graph, a);
            graph.neg(opposite)
        }
        Node::Truth(true) => graph.integer(1),
        _ => graph.integer(-1),
    }
}

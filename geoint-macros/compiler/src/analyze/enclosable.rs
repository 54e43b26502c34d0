//! Rewrites an expression so that interval arithmetic encloses it tightly: no interval is multiplied with itself.

use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node};

/// Replaces xⁿ by |x|ⁿ for every even n.
pub(super) fn enclosable(graph: &mut Graph, root: Id) -> Id {
    let mut form = Substitution::new(|_: &mut Graph, _| None);
    for id in graph.reachable(&[root]) {
        if let Node::Power(base, exponent) = *graph.node(id)
            && exponent.is_integer()
            && exponent.numerator % 2 == 0
        {
            let base = form.apply(graph, base);
            let size = graph.call(Function::Abs, &[base]);
            let power = graph.pow(size, exponent);
            form.insert(id, power);
        }
    }
    form.apply(graph, root)
}

//! Evaluates graphs in f64: the reference for tests of derivatives and schedules.

use crate::ir::{Graph, Id, Node, Symbol};
use std::collections::HashMap;

/// Returns the value of `root`. `value` gives the values of symbols.
pub(crate) fn eval(graph: &Graph, root: Id, value: &impl Fn(Symbol) -> f64) -> f64 {
    let mut values: HashMap<Id, f64> = HashMap::new();
    for id in graph.reachable(&[root]) {
        let of = |id: &Id| values[id];
        let truth = |x: bool| f64::from(u8::from(x));
        let x = match graph.node(id) {
            Node::Number(x) => x.to_f64(),
            Node::Symbol(symbol) => value(*symbol),
            Node::Linear(constant, terms) => {
                terms.iter().fold(constant.to_f64(), |sum, (c, id)| sum + c.to_f64() * of(id))
            }
            Node::Product(ids) => ids.iter().map(of).product(),
            Node::Power(base, exponent) => of(base).powf(exponent.to_f64()),
            Node::Call(function, args) => (function.entry().value)(&args.iter().map(of).collect::<Vec<_>>()),
            Node::Select(c, a, b) => of(if of(c) == 1.0 { a } else { b }),
            Node::Compare(relation, a, b) => truth(relation.holds(of(a), of(b))),
            Node::And(a, b) => of(a) * of(b),
            Node::Or(a, b) => of(a).max(of(b)),
            Node::Not(a) => 1.0 - of(a),
            Node::Truth(value) => truth(*value),
        };
        values.insert(id, x);
    }
    values[&root]
}

//! Evaluates graphs in f64: the reference for tests of derivatives and schedules.

use crate::ir::{Function, Graph, Id, Node, Symbol};
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
            // A matrix is no number.
            Node::Call(Function::FlowMatrix, _) => f64::NAN,
            Node::Call(Function::FlowChange, args) => flow_change(graph, args, &of),
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

/// A row of (exp(A) − 1) x, by the series A x + A (A x)/2 + …
fn flow_change(graph: &Graph, args: &[Id], of: &impl Fn(&Id) -> f64) -> f64 {
    let [row, matrix, x @ ..] = args else { panic!("a row, a matrix, and a vector") };
    let Node::Call(Function::FlowMatrix, entries) = graph.node(*matrix) else { panic!("a matrix") };
    let mut term: Vec<f64> = x.iter().map(of).collect();
    let mut sum = vec![0.0; x.len()];
    for k in 1..60 {
        let mut next = vec![0.0; x.len()];
        for entry in entries[1..].chunks_exact(2) {
            let place = of(&entry[0]) as usize;
            next[place % x.len()] += of(&entry[1]) * term[place / x.len()] / f64::from(k);
        }
        term = next;
        sum.iter_mut().zip(&term).for_each(|(sum, term)| *sum += term);
    }
    sum[of(row) as usize]
}

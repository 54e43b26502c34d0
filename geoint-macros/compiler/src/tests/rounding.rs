//! Evaluates graphs with a bound on rounding errors.

use crate::ir::{Graph, Id, Node, Symbol};
use std::collections::HashMap;

/// A number with a bound on its rounding errors, in units of ε.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rounded {
    pub(super) value: f64,
    pub(super) error: f64,
}

/// Returns the value of `root` and a bound on its rounding error. Each operation adds one ε of its value, and a sum one ε of each term. Numerical
/// derivatives propagate the errors of operands.
pub(super) fn rounded(graph: &Graph, root: Id, symbol: &impl Fn(Symbol) -> f64) -> Rounded {
    let mut values: HashMap<Id, Rounded> = HashMap::new();
    for id in graph.reachable(&[root]) {
        let of = |id: &Id| values[id];
        let exact = |value: f64| Rounded { value, error: 0.0 };
        let truth = |x: bool| exact(f64::from(u8::from(x)));
        let x = match graph.node(id) {
            Node::Number(x) => Rounded { value: x.to_f64(), error: x.to_f64().abs() },
            Node::Symbol(name) => exact(symbol(*name)),
            Node::Linear(constant, terms) => {
                let constant = constant.to_f64();
                terms.iter().fold(Rounded { value: constant, error: constant.abs() }, |sum, (c, id)| {
                    let (c, term) = (c.to_f64(), of(id));
                    let value = sum.value + c * term.value;
                    let rounding = value.abs() + 2.0 * (c * term.value).abs();
                    Rounded { value, error: sum.error + (c * term.error).abs() + rounding }
                })
            }
            Node::Product(ids) => ids.iter().map(of).fold(exact(1.0), |product, factor| Rounded {
                value: product.value * factor.value,
                error: (product.value * factor.value).abs()
                    + (product.value * factor.error).abs()
                    + (product.error * factor.value).abs(),
            }),
            Node::Power(base, exponent) => {
                let (base, exponent) = (of(base), exponent.to_f64());
                let value = base.value.powf(exponent);
                let slope = exponent * base.value.powf(exponent - 1.0);
                Rounded { value, error: exponent.abs() * value.abs() + (slope * base.error).abs() }
            }
            Node::Call(function, args) => {
                let args: Vec<Rounded> = args.iter().map(of).collect();
                let f = |x: &[f64]| (function.entry().value)(x);
                let x: Vec<f64> = args.iter().map(|arg| arg.value).collect();
                let value = f(&x);
                let passed = |(i, arg): (usize, &Rounded)| {
                    let h = 1e-6 * arg.value.abs().max(1e-200);
                    let [mut above, mut below] = [x.clone(), x.clone()];
                    above[i] += h;
                    below[i] -= h;
                    // At the end of a domain, one side is enough.
                    let slopes = [(f(&above) - value) / h, (value - f(&below)) / h];
                    let slope = slopes.into_iter().filter(|slope| !slope.is_nan()).fold(0.0_f64, |a, b| a.max(b.abs()));
                    slope * arg.error
                };
                let inherited: f64 = args.iter().enumerate().filter(|(_, arg)| arg.error > 0.0).map(passed).sum();
                Rounded { value, error: 4.0 * value.abs() + inherited }
            }
            Node::Select(c, a, b) => of(if of(c).value == 1.0 { a } else { b }),
            Node::Compare(relation, a, b) => truth(relation.holds(of(a).value, of(b).value)),
            Node::And(a, b) => exact(of(a).value * of(b).value),
            Node::Or(a, b) => exact(of(a).value.max(of(b).value)),
            Node::Not(a) => exact(1.0 - of(a).value),
            Node::Truth(value) => truth(*value),
        };
        values.insert(id, x);
    }
    values[&root]
}

/// Returns whether rounding decides a comparison on the way to `root`.
pub(super) fn is_undecided(graph: &Graph, root: Id, symbol: &impl Fn(Symbol) -> f64) -> bool {
    graph.reachable(&[root]).into_iter().any(|id| match graph.node(id) {
        Node::Compare(_, a, b) => {
            let [a, b] = [a, b].map(|id| rounded(graph, *id, symbol));
            let rounding = 4.0 * f64::EPSILON * (a.error + b.error);
            rounding > 0.0 && (a.value - b.value).abs() <= rounding
        }
        _ => false,
    })
}

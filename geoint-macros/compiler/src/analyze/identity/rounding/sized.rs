//! Values in floating point with estimates of their rounding errors.

use crate::analyze::identity::OpenBoundaries;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol, Table};

/// Values of symbols.
pub(crate) type State = Vec<(Symbol, Ratio)>;

/// A value below this fraction of its size may be a rounding error.
const TOLERANCE: f64 = 1e-10;

/// A value with the size of its terms. Its rounding error is a few roundings of numbers of that size.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sized {
    pub(super) value: f64,
    pub(super) size: f64,
}

impl Sized {
    /// A value whose only error is its own rounding.
    fn of(value: f64) -> Sized {
        Sized { value, size: value.abs() }
    }

    pub(super) fn is_finite(self) -> bool {
        self.value.is_finite() && self.size.is_finite()
    }

    /// Returns whether the value is larger than a rounding error.
    pub(super) fn differs(self) -> bool {
        self.value.abs() > TOLERANCE * self.size
    }

    fn add(self, other: Sized) -> Sized {
        Sized { value: self.value + other.value, size: self.size + other.size }
    }

    fn mul(self, other: Sized) -> Sized {
        Sized { value: self.value * other.value, size: self.size * other.size }
    }
}

/// Evaluates nodes at states.
pub(super) struct Evaluation<'a> {
    graph: &'a Graph,
    /// Operands precede the nodes that use them.
    order: Vec<Id>,
    /// The values at the last state.
    values: Table<Sized>,
}

impl<'a> Evaluation<'a> {
    pub(super) fn new(graph: &'a Graph, roots: &[Id]) -> Self {
        Evaluation { graph, order: graph.reachable(roots), values: Table::default() }
    }

    /// The values at a state.
    pub(super) fn at(&mut self, state: &State) -> &Table<Sized> {
        for id in &self.order {
            let value = sized(self.graph, *id, &self.values, state);
            self.values.insert(*id, value);
        }
        &self.values
    }

    /// Σ terms at a state.
    pub(super) fn sum(&mut self, terms: &[Id], state: &State) -> Sized {
        let values = self.at(state);
        terms.iter().fold(Sized::of(0.0), |sum, term| sum.add(values[*term]))
    }

    /// Returns whether the last state lies on a boundary to rounding.
    pub(super) fn is_on_any(&self, boundaries: &OpenBoundaries) -> bool {
        boundaries.iter().any(|id| match self.graph.node(*id) {
            Node::Compare(_, a, b) => {
                let (a, b) = (self.values[*a], self.values[*b]);
                !Sized { value: a.value - b.value, size: a.size + b.size }.differs()
            }
            Node::Call(_, args) => !self.values[args[0]].differs(),
            _ => false,
        })
    }
}

/// The value of a node from those of its operands. A condition is 1 if it holds, and 0 otherwise.
fn sized(graph: &Graph, id: Id, values: &Table<Sized>, state: &State) -> Sized {
    let of = |id: &Id| values[*id];
    let truth = |holds: bool| Sized::of(f64::from(u8::from(holds)));
    match graph.node(id) {
        Node::Number(number) => constant(*number),
        Node::Symbol(symbol) => {
            let known = state.iter().find(|(other, _)| other == symbol);
            Sized::of(known.map_or(f64::NAN, |(_, value)| value.to_f64()))
        }
        Node::Linear(c, terms) => terms.iter().fold(constant(*c), |sum, (c, term)| sum.add(constant(*c).mul(of(term)))),
        Node::Product(ids) => ids.iter().map(of).fold(Sized::of(1.0), Sized::mul),
        Node::Power(base, exponent) => perturbed(&[of(base)], |x| x[0].powf(exponent.to_f64())),
        Node::Call(function, args) => {
            perturbed(&args.iter().map(of).collect::<Vec<_>>(), |x| function_value(*function, x))
        }
        Node::Select(condition, first, second) => of(if of(condition).value == 1.0 { first } else { second }),
        Node::Compare(relation, a, b) => truth(relation.holds(of(a).value, of(b).value)),
        Node::And(a, b) => truth(of(a).value * of(b).value == 1.0),
        Node::Or(a, b) => truth(of(a).value + of(b).value > 0.0),
        Node::Not(a) => truth(of(a).value == 0.0),
        Node::Truth(holds) => truth(*holds),
    }
}

/// The value of a constant. A tiny rounded number may be a rounding error of numbers of size 1 that cancelled.
fn constant(number: Number) -> Sized {
    let value = number.to_f64();
    let is_rounding_error = value.abs() < 1e-14 && number.is_rounded();
    Sized { value, size: if is_rounding_error { 1.0 } else { value.abs() } }
}

/// The value of a function. Its size includes the sensitivity to the sizes of the arguments, by differences.
fn perturbed(args: &[Sized], function: impl Fn(&[f64]) -> f64) -> Sized {
    const STEP: f64 = 1e-7;
    let mut x: Vec<f64> = args.iter().map(|arg| arg.value).collect();
    let value = function(&x);
    let mut size = value.abs();
    for (i, arg) in args.iter().enumerate() {
        x[i] += STEP * arg.size;
        let change = (function(&x) - value).abs() / STEP;
        size += if change.is_finite() { change } else { 0.0 };
        x[i] = arg.value;
    }
    Sized { value, size }
}

fn function_value(function: Function, x: &[f64]) -> f64 {
    match function {
        Function::RecipPositive if x[0] > 0.0 => 1.0 / x[0],
        Function::NotNegative | Function::Bounded | Function::AtMost | Function::Provided => x[0],
        Function::Root => x[0].sqrt(),
        _ if function.entry().public => (function.entry().value)(x),
        _ => f64::NAN,
    }
}

//! Values in floating point, with a bound on what rounding does to them.

use crate::analyze::identity::OpenBoundaries;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol, Table};

/// Values of symbols.
pub(crate) type State = Vec<(Symbol, Ratio)>;

/// What is smaller than this part of the terms may be rounding.
const TOLERANCE: f64 = 1e-10;

/// A value, and how large its terms are: its error is a few roundings of that.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sized {
    pub(super) value: f64,
    pub(super) size: f64,
}

impl Sized {
    pub(super) fn is_finite(self) -> bool {
        self.value.is_finite() && self.size.is_finite()
    }

    /// Whether this is not zero to rounding.
    pub(super) fn differs(self) -> bool {
        self.value.abs() > TOLERANCE * self.size
    }

    pub(super) fn add(self, other: Sized) -> Sized {
        Sized { value: self.value + other.value, size: self.size + other.size }
    }

    pub(super) fn mul(self, other: Sized) -> Sized {
        Sized { value: self.value * other.value, size: self.size * other.size }
    }
}

/// The values of nodes at one state after the other.
pub(super) struct Evaluation<'a> {
    graph: &'a Graph,
    order: Vec<Id>,
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

    /// The value of a node at another state, where all that it is built of is the same but for what reads positions.
    pub(super) fn moved(&mut self, root: Id, state: &State) -> Sized {
        for id in &self.order {
            if self.graph.reads(*id).q {
                let value = sized(self.graph, *id, &self.values, state);
                self.values.insert(*id, value);
            }
        }
        self.values[root]
    }

    /// Σ terms at a state.
    pub(super) fn sum(&mut self, terms: &[Id], state: &State) -> Sized {
        let values = self.at(state);
        terms.iter().fold(Sized { value: 0.0, size: 0.0 }, |sum, term| sum.add(values[*term]))
    }

    /// Whether the last state lies on a boundary, as far as rounding lets one tell.
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

fn sized(graph: &Graph, id: Id, values: &Table<Sized>, state: &State) -> Sized {
    let of = |id: &Id| values[*id];
    let alone = |value: f64| Sized { value, size: value.abs() };
    let truth = |holds: bool| alone(f64::from(u8::from(holds)));
    match graph.node(id) {
        Node::Number(number) => constant(*number),
        Node::Symbol(symbol) => {
            for (other, value) in state {
                if other == symbol {
                    return alone(value.to_f64());
                }
            }
            alone(f64::NAN)
        }
        Node::Linear(c, terms) => {
            let mut sum = constant(*c);
            for (c, term) in terms {
                sum = sum.add(constant(*c).mul(of(term)));
            }
            sum
        }
        Node::Product(ids) => {
            let mut product = alone(1.0);
            for id in ids {
                product = product.mul(of(id));
            }
            product
        }
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

/// What is left when rounded numbers cancel is as uncertain as they were.
fn constant(number: Number) -> Sized {
    let value = number.to_f64();
    let left_over = value.abs() < 1e-14 && number.is_rounded();
    Sized { value, size: if left_over { 1.0 } else { value.abs() } }
}

/// A function, and its size: that of its value and of what its arguments contribute.
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

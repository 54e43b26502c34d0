//! Does a sum vanish in floating point, as far as rounding lets one see? Nothing is proven by that: it tells what to say of what was
//! not proven.

use super::witness::is_rounded;
use crate::ir::{Function, Graph, HashMap, Id, Node, Number, Ratio, Symbol};

/// Values of symbols.
pub(super) type State = Vec<(Symbol, Ratio)>;

/// What floating point shows.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Shown {
    /// It is zero to rounding at so many states.
    Zero,
    /// It is not, at this one.
    Differs(State, f64),
    /// No state was met at which it is defined.
    Nowhere,
}

/// States at which a sum has to vanish, and how often one is drawn.
const STATES: u32 = 20;
const DRAWS: u64 = 200;

/// What is smaller than this part of the terms may be rounding.
const TOLERANCE: f64 = 1e-10;

/// The value of Σ terms at states that look random, against the size of the terms.
pub(super) fn shown(graph: &Graph, terms: &[Id], symbols: &[Symbol]) -> Shown {
    let order = graph.reachable(terms);
    let mut states = 0;
    for draw in 0..DRAWS {
        // Eighths up to 2; all positive, all negative, or of either sign.
        let coordinate = |(i, symbol): (usize, &Symbol)| {
            let noise = super::residues::noise(draw * 1_000 + i as u64);
            let negative = draw % 4 == 1 || draw % 4 > 1 && noise & 64 != 0;
            let sign = if negative { -1 } else { 1 };
            (*symbol, Ratio::new(sign * (i128::from(noise % 16) + 1), 8).unwrap_or(Ratio::ONE))
        };
        let state: State = symbols.iter().enumerate().map(coordinate).collect();
        let (value, size) = sum(graph, &order, terms, &state);
        if !value.is_finite() || !size.is_finite() {
            continue;
        }
        if value.abs() > TOLERANCE * size {
            return Shown::Differs(state, value);
        }
        states += 1;
        if states == STATES {
            return Shown::Zero;
        }
    }
    if states == 0 { Shown::Nowhere } else { Shown::Zero }
}

/// The value at a state, if it is not zero to rounding.
pub(super) fn value_at(graph: &Graph, terms: &[Id], state: &State) -> Option<f64> {
    let (value, size) = sum(graph, &graph.reachable(terms), terms, state);
    (value.is_finite() && value.abs() > TOLERANCE * size).then_some(value)
}

/// A value, and how large its terms are: its error is a few roundings of that.
#[derive(Clone, Copy, Debug)]
struct Sized {
    value: f64,
    size: f64,
}

fn sum(graph: &Graph, order: &[Id], terms: &[Id], state: &State) -> (f64, f64) {
    let mut values: HashMap<Id, Sized> = HashMap::default();
    for id in order {
        let value = sized(graph, *id, &values, state);
        values.insert(*id, value);
    }
    let all = || terms.iter().map(|term| values[term]);
    (all().map(|term| term.value).sum(), all().map(|term| term.size).sum())
}

fn sized(graph: &Graph, id: Id, values: &HashMap<Id, Sized>, state: &State) -> Sized {
    let of = |id: &Id| values[id];
    let alone = |value: f64| Sized { value, size: value.abs() };
    let truth = |holds: bool| alone(f64::from(u8::from(holds)));
    match graph.node(id) {
        Node::Number(number) => constant(*number),
        Node::Symbol(symbol) => {
            let known = state.iter().find(|(other, _)| other == symbol);
            alone(known.map_or(f64::NAN, |(_, value)| value.to_f64()))
        }
        Node::Linear(c, terms) => terms.iter().fold(constant(*c), |sum, (c, term)| {
            let (c, term) = (constant(*c), of(term));
            Sized { value: sum.value + c.value * term.value, size: sum.size + c.size * term.size }
        }),
        Node::Product(ids) => ids.iter().map(of).fold(alone(1.0), |product, factor| Sized {
            value: product.value * factor.value,
            size: product.size * factor.size,
        }),
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
    let left_over = value.abs() < 1e-14 && is_rounded(number);
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

//! States with small integers at which a sum is not zero. The value is a ratio if it can be computed exactly.

use super::OpenBoundaries;
use super::residues::pseudorandom;
use super::rounding::{Shown, State, shown_at};
use crate::ir::{Function, Graph, HashMap, Id, Node, Number, Ratio, Symbol};

/// A state with the value of the sum.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Witness {
    pub(crate) state: State,
    pub(crate) value: Value,
}

/// A value that is not zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Value {
    Exact(Ratio),
    /// A value with rounding errors that are smaller than the value.
    Near(f64),
}

/// The number of states that are tried with values 1 and 2, and of those with pseudorandom integers.
const IN_ORDER: u64 = 16;
const RANDOM: u64 = 100;

/// Returns the first candidate state at which the value is an exact ratio that is not zero.
pub(super) fn exact_witness(graph: &Graph, terms: &[Id], symbols: &[Symbol], open: &OpenBoundaries) -> Option<Witness> {
    let order = graph.reachable(terms);
    // A sum without an exact value at the first states has none at most others.
    let mut failures = 0;
    for state in states(symbols) {
        match exact_sum(graph, &order, terms, &state, open) {
            Some(value) if value != Ratio::ZERO => return Some(Witness { state, value: Value::Exact(value) }),
            Some(_) => {}
            None => failures += 1,
        }
        if failures > IN_ORDER {
            return None;
        }
    }
    None
}

/// Returns the first candidate state at which the value is larger than its rounding error.
pub(super) fn near_witness(graph: &Graph, terms: &[Id], symbols: &[Symbol], open: &OpenBoundaries) -> Option<Witness> {
    match shown_at(graph, terms, open, states(symbols), usize::MAX) {
        Shown::Differs(state, value) => Some(Witness { state, value: Value::Near(value) }),
        Shown::Zero | Shown::Nowhere => None,
    }
}

/// The candidate states: combinations of 1 and 2, then pseudorandom integers from −3 to 3.
fn states(symbols: &[Symbol]) -> impl Iterator<Item = State> + '_ {
    let state = |integer: &dyn Fn(u64) -> i128| -> State {
        symbols.iter().zip(0..).map(|(symbol, i)| (*symbol, Ratio::integer(integer(i)))).collect()
    };
    let pairs = 1_u64.checked_shl(symbols.len() as u32).map_or(IN_ORDER, |all| all.min(IN_ORDER));
    let in_order = (0..pairs).map(move |bits| state(&|i| 1 + i128::from(bits >> i.min(63) & 1)));
    let random = (0..RANDOM).map(move |k| state(&|i| i128::from(pseudorandom(k * 1_000 + i) % 7) - 3));
    in_order.chain(random)
}

/// Returns whether nodes contain rounded numbers.
pub(super) fn has_rounded(graph: &Graph, terms: &[Id]) -> bool {
    graph.reachable(terms).into_iter().any(|id| match graph.node(id) {
        Node::Number(number) => number.is_rounded(),
        Node::Linear(constant, terms) => constant.is_rounded() || terms.iter().any(|(c, _)| c.is_rounded()),
        _ => false,
    })
}

/// The sum of terms. `None` if it is not a ratio, is too long, or the state is on an open boundary.
fn exact_sum(graph: &Graph, order: &[Id], terms: &[Id], state: &State, open: &OpenBoundaries) -> Option<Ratio> {
    let mut values: HashMap<Id, Ratio> = HashMap::default();
    for id in order {
        // A node without a value may belong to a branch that is not taken.
        if let Some(value) = exact_value(graph, *id, &values, state, open) {
            values.insert(*id, value);
        }
    }
    terms.iter().try_fold(Ratio::ZERO, |sum, term| sum.add(*values.get(term)?))
}

/// The value of a node from those of its operands. A condition is 1 if it holds, and 0 otherwise.
fn exact_value(
    graph: &Graph,
    id: Id,
    values: &HashMap<Id, Ratio>,
    state: &State,
    open: &OpenBoundaries,
) -> Option<Ratio> {
    let of = |id: &Id| values.get(id).copied();
    let holds = |condition: &Id| Some(of(condition)? == Ratio::ONE);
    let truth = |holds: bool| Some(Ratio::integer(holds.into()));
    match graph.node(id) {
        Node::Number(value) => ratio(*value),
        Node::Symbol(symbol) => Some(state.iter().find(|(other, _)| other == symbol)?.1),
        Node::Linear(constant, terms) => {
            terms.iter().try_fold(ratio(*constant)?, |sum, (c, term)| sum.add(ratio(*c)?.mul(of(term)?)?))
        }
        Node::Product(ids) => ids.iter().try_fold(Ratio::ONE, |product, id| product.mul(of(id)?)),
        Node::Power(base, exponent) if exponent.is_integer() => ratio(Number::Exact(of(base)?).pow(*exponent)?),
        Node::Power(..) => None,
        Node::Call(function, args) => {
            let args: Vec<Ratio> = args.iter().map(of).collect::<Option<_>>()?;
            if args[0] == Ratio::ZERO && open.contains(&id) { None } else { exact_function(*function, &args) }
        }
        Node::Select(condition, first, second) => of(if holds(condition)? { first } else { second }),
        Node::Compare(_, a, b) if open.contains(&id) && of(a)? == of(b)? => None,
        Node::Compare(relation, a, b) => truth(relation.holds(of(a)?, of(b)?)),
        Node::And(a, b) => truth(holds(a)? && holds(b)?),
        Node::Or(a, b) => truth(holds(a)? || holds(b)?),
        Node::Not(a) => truth(!holds(a)?),
        Node::Truth(holds) => truth(*holds),
    }
}

fn exact_function(function: Function, x: &[Ratio]) -> Option<Ratio> {
    match (function, x) {
        (Function::Abs, [x]) => Some(if *x < Ratio::ZERO { x.neg() } else { *x }),
        (Function::Signum, [x]) => Some(Ratio::integer(if *x < Ratio::ZERO { -1 } else { 1 })),
        (Function::Min, [x, y]) => Some(*x.min(y)),
        (Function::Max, [x, y]) => Some(*x.max(y)),
        (Function::RecipPositive, [x]) if *x > Ratio::ZERO => x.recip(),
        (Function::NotNegative, [x]) | (Function::Bounded | Function::AtMost | Function::Provided, [x, _]) => Some(*x),
        _ => None,
    }
}

fn ratio(number: Number) -> Option<Ratio> {
    match number {
        Number::Exact(ratio) => Some(ratio),
        Number::Root(..) | Number::Float(_) => None,
    }
}

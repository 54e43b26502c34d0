//! A state at which a sum is not zero: small integers, with the value as a ratio where there is one.

use super::OpenBoundaries;
use super::rounding::{State, value_at};
use crate::ir::{Function, Graph, HashMap, Id, Node, Number, Ratio, Relation, Symbol};

/// A state, and the value there.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Witness {
    pub(crate) state: State,
    pub(crate) value: Value,
}

/// A value that is not zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Value {
    Exact(Ratio),
    /// To rounding.
    Near(f64),
}

/// So many states are tried: first ones and twos, then integers that look random.
const IN_ORDER: u64 = 16;
const RANDOM: u64 = 100;

/// The first small integers at which the value is an exact ratio that is not zero.
pub(super) fn exact_witness(graph: &Graph, terms: &[Id], symbols: &[Symbol], open: &OpenBoundaries) -> Option<Witness> {
    let order = graph.reachable(terms);
    // A sum that has no exact value at the first state has none at most others.
    let mut failures = 0;
    for state in states(symbols) {
        match exact(graph, &order, terms, &state, open) {
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

/// The first small integers at which the value is not zero to rounding.
pub(super) fn near_witness(graph: &Graph, terms: &[Id], symbols: &[Symbol], open: &OpenBoundaries) -> Option<Witness> {
    let near = |state| Some(Witness { value: Value::Near(value_at(graph, terms, &state, open)?), state });
    states(symbols).find_map(near)
}

fn states(symbols: &[Symbol]) -> impl Iterator<Item = State> + '_ {
    let pairs = 1_u64.checked_shl(symbols.len() as u32).map_or(IN_ORDER, |all| all.min(IN_ORDER));
    let in_order = (0..pairs).map(|bits| (0..symbols.len()).map(|i| 1 + (bits >> i.min(63) & 1) as i128).collect());
    let random = (0..RANDOM).map(|k| {
        let integer = |i| i128::from(super::residues::noise(k * 1_000 + i as u64) % 7) - 3;
        (0..symbols.len()).map(integer).collect()
    });
    in_order.chain(random).map(|integers: Vec<i128>| {
        symbols.iter().zip(integers).map(|(symbol, integer)| (*symbol, Ratio::integer(integer))).collect()
    })
}

/// Whether a node has numbers in it that were rounded.
pub(super) fn has_rounded(graph: &Graph, terms: &[Id]) -> bool {
    graph.reachable(terms).into_iter().any(|id| match graph.node(id) {
        Node::Number(number) => number.is_rounded(),
        Node::Linear(constant, terms) => constant.is_rounded() || terms.iter().any(|(c, _)| c.is_rounded()),
        _ => false,
    })
}

#[derive(Clone, Copy)]
enum Exact {
    Number(Ratio),
    Truth(bool),
}

/// The sum of terms, if it is a ratio that is not too long.
fn exact(graph: &Graph, order: &[Id], terms: &[Id], state: &State, open: &OpenBoundaries) -> Option<Ratio> {
    let mut values: HashMap<Id, Exact> = HashMap::default();
    for id in order {
        // What has no value may be in the branch that is not taken.
        if let Some(value) = exact_node(graph, *id, &values, state, open) {
            values.insert(*id, value);
        }
    }
    terms.iter().try_fold(Ratio::ZERO, |sum, term| match values.get(term)? {
        Exact::Number(value) => sum.add(*value),
        Exact::Truth(_) => None,
    })
}

fn exact_node(
    graph: &Graph,
    id: Id,
    values: &HashMap<Id, Exact>,
    state: &State,
    open: &OpenBoundaries,
) -> Option<Exact> {
    let number = |id: &Id| match values.get(id)? {
        Exact::Number(value) => Some(*value),
        Exact::Truth(_) => None,
    };
    let truth = |id: &Id| match values.get(id)? {
        Exact::Truth(value) => Some(*value),
        Exact::Number(_) => None,
    };
    let value = match graph.node(id) {
        Node::Number(value) => ratio(*value)?,
        Node::Symbol(symbol) => state.iter().find(|(other, _)| other == symbol)?.1,
        Node::Linear(constant, terms) => {
            terms.iter().try_fold(ratio(*constant)?, |sum, (c, term)| sum.add(ratio(*c)?.mul(number(term)?)?))?
        }
        Node::Product(ids) => ids.iter().try_fold(Ratio::ONE, |product, id| product.mul(number(id)?))?,
        Node::Power(base, exponent) if exponent.is_integer() => ratio(Number::Exact(number(base)?).pow(*exponent)?)?,
        Node::Power(..) => return None,
        Node::Call(function, args) => {
            let args: Vec<Ratio> = args.iter().map(number).collect::<Option<_>>()?;
            if args[0] == Ratio::ZERO && open.contains(&id) {
                return None;
            }
            exact_function(*function, &args)?
        }
        Node::Select(condition, first, second) => number(if truth(condition)? { first } else { second })?,
        Node::Compare(relation, a, b) => {
            let order = number(a)?.cmp(&number(b)?);
            if order.is_eq() && open.contains(&id) {
                return None;
            }
            return Some(Exact::Truth(match relation {
                Relation::Less => order.is_lt(),
                Relation::LessEqual => order.is_le(),
                Relation::Equal => order.is_eq(),
            }));
        }
        Node::And(a, b) => return Some(Exact::Truth(truth(a)? && truth(b)?)),
        Node::Or(a, b) => return Some(Exact::Truth(truth(a)? || truth(b)?)),
        Node::Not(a) => return Some(Exact::Truth(!truth(a)?)),
        Node::Truth(value) => return Some(Exact::Truth(*value)),
    };
    Some(Exact::Number(value))
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

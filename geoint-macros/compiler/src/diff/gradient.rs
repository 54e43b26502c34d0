//! The gradient of a node at a point, and its discrete counterparts between two points.

use super::forward::jacobian;
use super::slope::Slopes;
use super::sweep;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Symbol};

/// The partial derivatives of a node with respect to positions, momenta, velocities and the action.
#[derive(Clone, Debug)]
pub(crate) struct Gradient {
    pub(crate) q: Vec<Id>,
    pub(crate) p: Vec<Id>,
    pub(crate) v: Vec<Id>,
    pub(crate) s: Id,
}

/// Computes ∇root by one reverse sweep.
pub(crate) fn gradient(graph: &mut Graph, root: Id, degrees: u32) -> Gradient {
    let entries = sweep::gradient(graph, root);
    collect(graph, &entries, degrees)
}

/// Computes the tree discrete gradient of `root` between (q, p, s) and (q + dq, p + dp, s + ds).
pub(crate) fn discrete_gradient(graph: &mut Graph, root: Id, degrees: u32) -> Gradient {
    let entries = Slopes::default().gradient(graph, root);
    collect(graph, &entries, degrees)
}

fn collect(graph: &mut Graph, entries: &sweep::Entries, degrees: u32) -> Gradient {
    let zero = graph.zero();
    let entry = |symbol| entries.get(&symbol).copied().unwrap_or(zero);
    let all = |symbol: fn(u32) -> Symbol| (0..degrees).map(|i| entry(symbol(i))).collect();
    Gradient { q: all(Symbol::Position), p: all(Symbol::Momentum), v: all(Symbol::Velocity), s: entry(Symbol::Action) }
}

/// The discrete gradient of I(x, t) over a step of length h: I(x + dx, t₁) − I(x, t₀) = by_x·dx + h·by_t.
pub(crate) struct DiscreteGradient {
    pub(crate) by_x: Vec<Id>,
    pub(crate) by_t: Id,
}

/// Computes the tree discrete gradient of I(x, t).
///
/// A function of time alone enters as a coordinate. Its increment is the difference of its values at both ends, unlike any other increment. The end
/// value of a step equals the start value of the next step bit for bit, so rounding errors do not accumulate.
pub(crate) fn discrete_gradient_with_time(graph: &mut Graph, root: Id, degrees: u32) -> DiscreteGradient {
    let timed: Vec<Id> = graph.reachable(&[root]).into_iter().filter(|id| is_of_time_alone(graph, *id)).collect();
    let mut as_coordinates = Substitution::new(|_: &mut Graph, _| None);
    for (symbol, id) in (0..=TIME).rev().map(Symbol::Position).zip(&timed) {
        let coordinate = graph.symbol(symbol);
        as_coordinates.insert(*id, coordinate);
    }
    let root = as_coordinates.apply(graph, root);
    let entries = Slopes::default().gradient(graph, root);

    let [h, start, end] = [Symbol::StepLength, Symbol::StepStart, Symbol::StepEnd].map(|symbol| graph.symbol(symbol));
    let [mut at_start, mut at_end] =
        [start, end].map(|t| Substitution::new(move |_: &mut Graph, symbol| (symbol == Symbol::Time).then_some(t)));
    let ends: Vec<[Id; 2]> = timed.iter().map(|id| [at_start.apply(graph, *id), at_end.apply(graph, *id)]).collect();
    let changes: Vec<Id> = ends.iter().map(|[start, end]| graph.sub(*end, *start)).collect();
    let timed_index = |i: u32| (i > TIME - timed.len() as u32).then(|| (TIME - i) as usize);
    let mut as_functions = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::Position(i) => timed_index(i).map(|i| ends[i][0]),
        Symbol::PositionIncrement(i) => timed_index(i).map(|i| changes[i]),
        _ => None,
    });
    let mut entry = |graph: &mut Graph, i: u32| match entries.get(&Symbol::Position(i)) {
        Some(entry) => as_functions.apply(graph, *entry),
        None => graph.zero(),
    };
    let by_x = (0..degrees).map(|i| entry(graph, i)).collect();
    let mut rises = vec![];
    for (i, change) in (0..).zip(&changes) {
        let entry = entry(graph, TIME - i);
        rises.push(graph.mul(entry, *change));
    }
    let rise = graph.sum(&rises);
    DiscreteGradient { by_x, by_t: graph.div(rise, h) }
}

/// Returns whether a node is a number that depends on time and on no coordinate.
fn is_of_time_alone(graph: &Graph, id: Id) -> bool {
    let reads = graph.reads(id);
    reads.t && !reads.state() && !graph.node(id).is_condition()
}

/// Computes the divided difference (f(t + h) − f(t))/h of a function of time, without cancellation.
pub(crate) fn mean_rate(graph: &mut Graph, root: Id) -> Id {
    let root = rename(graph, root, |symbol| (symbol == Symbol::Time).then_some(Symbol::Position(TIME)));
    let entries = Slopes::default().gradient(graph, root);
    let mean = entries.get(&Symbol::Position(TIME)).copied().unwrap_or_else(|| graph.zero());
    rename(graph, mean, |symbol| match symbol {
        Symbol::Position(TIME) => Some(Symbol::Time),
        Symbol::PositionIncrement(TIME) => Some(Symbol::StepLength),
        _ => None,
    })
}

/// Computes the increment of a node between (q, p) and (q + dq, p + dp), without a difference of its two values.
pub(crate) fn increment(graph: &mut Graph, root: Id) -> Id {
    Slopes::default().increment(graph, root)
}

/// The coordinates from this number downwards stand for time or functions of time. No system uses them. The rules of slopes thus need no case for time.
const TIME: u32 = u32::MAX;

/// Replaces the symbols `kind(i)` in nodes by `values[i]`.
pub(super) fn with_values(graph: &mut Graph, nodes: &[Id], kind: fn(u32) -> Symbol, values: &[Id]) -> Vec<Id> {
    let value = |symbol| (0..).map(kind).zip(values).find(|(other, _)| *other == symbol).map(|(_, value)| *value);
    let mut replaced = Substitution::new(|_: &mut Graph, symbol| value(symbol));
    nodes.iter().map(|node| replaced.apply(graph, *node)).collect()
}

/// Renames symbols in a node.
pub(super) fn rename(graph: &mut Graph, root: Id, new: impl Fn(Symbol) -> Option<Symbol>) -> Id {
    Substitution::new(|graph, symbol| new(symbol).map(|symbol| graph.symbol(symbol))).apply(graph, root)
}

/// Computes ∂root/∂symbol.
pub(crate) fn partial_derivative(graph: &mut Graph, root: Id, symbol: Symbol) -> Id {
    jacobian(graph, &[root], &[symbol])[0][0]
}

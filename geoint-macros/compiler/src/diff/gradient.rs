//! The gradient, and what is in its place between two points.

use super::forward::jacobian;
use super::{slope, sweep};
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

/// ∇ of `root` by one reverse sweep.
pub(crate) fn gradient(graph: &mut Graph, root: Id, degrees: u32) -> Gradient {
    let entries = sweep::gradient(graph, root);
    collect(graph, &entries, degrees)
}

/// The tree discrete gradient of `root` between (q, p, s) and (q + dq, p + dp, s + ds).
pub(crate) fn discrete_gradient(graph: &mut Graph, root: Id, degrees: u32) -> Gradient {
    let entries = slope::Slopes::default().gradient(graph, root);
    collect(graph, &entries, degrees)
}

fn collect(graph: &mut Graph, entries: &sweep::Entries, degrees: u32) -> Gradient {
    let zero = graph.zero();
    let entry = |symbol| entries.get(&symbol).copied().unwrap_or(zero);
    let all = |symbol: fn(u32) -> Symbol| (0..degrees).map(|i| entry(symbol(i))).collect();
    Gradient { q: all(Symbol::Position), p: all(Symbol::Momentum), v: all(Symbol::Velocity), s: entry(Symbol::Action) }
}

/// The tree discrete gradient of I(x, t) by x, and its rate in time: I(x + dx, end) − I(x, start) = ḡ·dx + h·rate.
///
/// A function of time alone is a coordinate here, and its increment a difference of two values, unlike any other: the value at the end of a
/// step is that at the start of the next one, to the last bit, so that rounding does not add up however much the clock shows.
pub(crate) fn discrete_gradient_and_rate(graph: &mut Graph, root: Id, degrees: u32) -> (Vec<Id>, Id) {
    let timed: Vec<Id> = graph.reachable(&[root]).into_iter().filter(|id| is_of_time_alone(graph, *id)).collect();
    let mut known = Substitution::new(|_: &mut Graph, _| None);
    for (symbol, id) in (0..=TIME).rev().map(Symbol::Position).zip(&timed) {
        let coordinate = graph.symbol(symbol);
        known.insert(*id, coordinate);
    }
    let root = known.apply(graph, root);
    let entries = slope::Slopes::default().gradient(graph, root);

    let [h, start, end] = [Symbol::StepLength, Symbol::StepStart, Symbol::StepEnd].map(|symbol| graph.symbol(symbol));
    let [mut at_start, mut at_end] =
        [start, end].map(|t| Substitution::new(move |_: &mut Graph, symbol| (symbol == Symbol::Time).then_some(t)));
    let ends: Vec<[Id; 2]> = timed.iter().map(|id| [at_start.apply(graph, *id), at_end.apply(graph, *id)]).collect();
    let changes: Vec<Id> = ends.iter().map(|[start, end]| graph.sub(*end, *start)).collect();
    let of_time = |i: u32| (i > TIME - timed.len() as u32).then(|| (TIME - i) as usize);
    let mut back = Substitution::new(|_: &mut Graph, symbol| match symbol {
        Symbol::Position(i) => of_time(i).map(|i| ends[i][0]),
        Symbol::PositionIncrement(i) => of_time(i).map(|i| changes[i]),
        _ => None,
    });
    let mut entry = |graph: &mut Graph, i: u32| match entries.get(&Symbol::Position(i)) {
        Some(entry) => back.apply(graph, *entry),
        None => graph.zero(),
    };
    let slope = (0..degrees).map(|i| entry(graph, i)).collect();
    let mut rises = vec![];
    for (i, change) in changes.iter().enumerate() {
        let entry = entry(graph, TIME - i as u32);
        rises.push(graph.mul(entry, *change));
    }
    let rise = graph.sum(&rises);
    (slope, graph.div(rise, h))
}

/// Whether a node is a number that changes with time and with nothing else.
fn is_of_time_alone(graph: &Graph, id: Id) -> bool {
    let reads = graph.reads(id);
    reads.t && !reads.state() && !graph.node(id).is_condition()
}

/// The divided difference of a function of time over a step: (f(t + h) − f(t))/h without cancellation.
pub(crate) fn mean_rate(graph: &mut Graph, root: Id) -> Id {
    let root = time_as_coordinate(graph, root);
    let entries = slope::Slopes::default().gradient(graph, root);
    let mean = entries.get(&Symbol::Position(TIME)).copied().unwrap_or_else(|| graph.zero());
    coordinate_as_time(graph, mean)
}

/// What a node grows by between (q, p) and (q + dq, p + dp), never a difference of two values.
pub(crate) fn increment(graph: &mut Graph, root: Id) -> Id {
    slope::Slopes::default().increment(graph, root)
}

/// Coordinates that nobody else uses, from this one down, stand for time or what depends on it alone, so that the slope rules need not know
/// of clocks.
const TIME: u32 = u32::MAX;

fn time_as_coordinate(graph: &mut Graph, root: Id) -> Id {
    rename(graph, root, |symbol| (symbol == Symbol::Time).then_some(Symbol::Position(TIME)))
}

/// Back, for a step of length h that starts at t.
fn coordinate_as_time(graph: &mut Graph, node: Id) -> Id {
    rename(graph, node, |symbol| match symbol {
        Symbol::Position(TIME) => Some(Symbol::Time),
        Symbol::PositionIncrement(TIME) => Some(Symbol::StepLength),
        _ => None,
    })
}

/// A node with some symbols called otherwise.
pub(super) fn rename(graph: &mut Graph, root: Id, new: impl Fn(Symbol) -> Option<Symbol>) -> Id {
    Substitution::new(|graph, symbol| new(symbol).map(|symbol| graph.symbol(symbol))).apply(graph, root)
}

/// ∂root/∂symbol.
pub(crate) fn partial(graph: &mut Graph, root: Id, symbol: Symbol) -> Id {
    jacobian(graph, &[root], &[symbol])[0][0]
}

//! The gradient, and what is in its place between two points.

use super::forward::jacobian;
use super::{slope, sweep};
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Number, Symbol};

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
    Gradient { q: all(Symbol::Q), p: all(Symbol::P), v: all(Symbol::V), s: entry(Symbol::S) }
}

/// The tree discrete gradient of I(x, t) by x, and its divided difference in time: I(x + dx, t + h/2) − I(x, t − h/2) = ḡ·dx + h·rate.
pub(crate) fn discrete_gradient_and_rate(graph: &mut Graph, root: Id, degrees: u32) -> (Vec<Id>, Id) {
    let (t, h) = (graph.symbol(Symbol::T), graph.symbol(Symbol::H));
    let half = graph.scale(Number::HALF, h);
    let start = graph.sub(t, half);
    let root = time_as_coordinate(graph, root);
    let entries = slope::Slopes::default().gradient(graph, root);
    let zero = graph.zero();
    let mut entry = |i: u32| {
        let entry = entries.get(&Symbol::Q(i)).copied().unwrap_or(zero);
        coordinate_as_time(graph, entry, start)
    };
    ((0..degrees).map(&mut entry).collect(), entry(TIME))
}

/// The divided difference of a function of time over a step: (f(t + h) − f(t))/h without cancellation.
pub(crate) fn mean_rate(graph: &mut Graph, root: Id) -> Id {
    let root = time_as_coordinate(graph, root);
    let entries = slope::Slopes::default().gradient(graph, root);
    let mean = entries.get(&Symbol::Q(TIME)).copied().unwrap_or_else(|| graph.zero());
    let start = graph.symbol(Symbol::T);
    coordinate_as_time(graph, mean, start)
}

/// What a node grows by between (q, p) and (q + dq, p + dp), never a difference of two values.
pub(crate) fn increment(graph: &mut Graph, root: Id) -> Id {
    slope::Slopes::default().increment(graph, root)
}

/// A coordinate that nobody else uses stands for time, so that the slope rules need not know of clocks.
const TIME: u32 = u32::MAX;

fn time_as_coordinate(graph: &mut Graph, root: Id) -> Id {
    rename(graph, root, |symbol| (symbol == Symbol::T).then_some(Symbol::Q(TIME)))
}

/// Back, for a step of length h that starts at a time.
fn coordinate_as_time(graph: &mut Graph, node: Id, start: Id) -> Id {
    let back = |graph: &mut Graph, symbol| match symbol {
        Symbol::Q(TIME) => Some(start),
        Symbol::Dq(TIME) => Some(graph.symbol(Symbol::H)),
        _ => None,
    };
    Substitution::new(back).apply(graph, node)
}

/// A node with some symbols called otherwise.
pub(super) fn rename(graph: &mut Graph, root: Id, new: impl Fn(Symbol) -> Option<Symbol>) -> Id {
    Substitution::new(|graph, symbol| new(symbol).map(|symbol| graph.symbol(symbol))).apply(graph, root)
}

/// ∂root/∂symbol.
pub(crate) fn partial(graph: &mut Graph, root: Id, symbol: Symbol) -> Id {
    jacobian(graph, &[root], &[symbol])[0][0]
}

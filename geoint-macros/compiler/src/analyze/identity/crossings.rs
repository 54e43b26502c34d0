//! Surfaces on which a function may jump along a field. The derivative of the function does not show these jumps.

use super::angles::{angles, broken_at};
use super::surface::vanishes_on;
use super::vanishes;
use crate::diff;
use crate::ir::substitute::{Substitution, replaced};
use crate::ir::{Function, Graph, Id, Node, Symbol};

/// The surface on which two numbers are equal, and the nodes that change there.
#[derive(Clone, Debug)]
pub(crate) struct Edge {
    pub(crate) equal: [Id; 2],
    pub(crate) difference: Id,
    changing: Vec<Changing>,
}

/// A condition or sign that changes at an edge.
#[derive(Clone, Copy, Debug)]
struct Changing {
    node: Id,
    /// The value for a negative difference.
    below: Id,
    /// The value for a positive difference.
    above: Id,
}

/// Returns the edges at which a function may jump: equality of both sides was not proven.
pub(crate) fn edges_of_jumps(graph: &mut Graph, function: Id) -> Vec<Edge> {
    let mut edges = edges(graph, function);
    edges.retain(|edge| {
        let below = on_side(graph, function, edge, |changing| changing.below);
        let above = on_side(graph, function, edge, |changing| changing.above);
        let height = graph.sub(above, below);
        !vanishes_on(graph, edge.difference, height)
    });
    edges
}

/// A surface on which a function may jump while a field is followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Discontinuity {
    /// The two numbers that are equal on the surface.
    pub(crate) equal: [Id; 2],
    /// The condition, sign or angle that changes.
    pub(crate) node: Id,
    pub(crate) kind: Kind,
}

/// How a function may jump.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Solutions lead across the surface.
    Crossed,
    /// Solutions stay on the surface: rounding decides on which side.
    Followed,
    /// Both arguments of an angle vanish, and solutions lead across the surface.
    Angle,
}

/// A surface on which a function may jump while a field is followed; `None` if it was proven not to.
///
/// A function does not jump if both sides are equal, or if no solution leads from one side to the other. A surface that solutions follow
/// counts, because rounding moves states across it, unless the coordinates of the surface rest.
pub(crate) fn may_jump(graph: &mut Graph, x: &[Symbol], field: &[Id], function: Id) -> Option<Discontinuity> {
    for edge in edges_of_jumps(graph, function) {
        let found = |kind| Discontinuity { equal: edge.equal, node: edge.changing[0].node, kind };
        if is_crossed(graph, x, field, edge.difference) {
            return Some(found(Kind::Crossed));
        }
        if !stands_still(graph, x, field, edge.difference) {
            return Some(found(Kind::Followed));
        }
    }
    for node in angles(graph, function) {
        for g in broken_at(graph, node) {
            if is_crossed(graph, x, field, g) {
                return Some(Discontinuity { equal: [g, graph.zero()], node, kind: Kind::Angle });
            }
        }
    }
    None
}

/// Returns whether it was not proven that solutions stay where a difference is zero.
fn is_crossed(graph: &mut Graph, x: &[Symbol], field: &[Id], difference: Id) -> bool {
    let rate = diff::derivative_along(graph, x, field, difference, None);
    let rate = graph.sum(&rate);
    !vanishes_on(graph, difference, rate)
}

/// Returns whether rounding moves no state off the surface: its coordinates rest, or a coordinate that is zero stays zero.
fn stands_still(graph: &mut Graph, x: &[Symbol], field: &[Id], difference: Id) -> bool {
    let (read, zero) = (graph.symbols(difference), graph.zero());
    let rests = |(symbol, rate): (&Symbol, &Id)| {
        let mut is_zero_at_zero = |node: Id| {
            let there = replaced(graph, node, *symbol, zero);
            graph.is_zero(there)
        };
        !read.contains(symbol) || is_zero_at_zero(*rate) && (*rate == zero || is_zero_at_zero(difference))
    };
    !read.contains(&Symbol::Time) && x.iter().zip(field).all(rests)
}

/// The edges of all conditions and signs that read the state or time.
fn edges(graph: &mut Graph, function: Id) -> Vec<Edge> {
    let mut edges: Vec<Edge> = vec![];
    for node in graph.reachable(&[function]) {
        let (a, b, below, above) = match *graph.node(node) {
            // The value on the edge itself, as of `a == b`, must not matter either.
            Node::Compare(_, a, b) => (a, b, graph.truth(false), graph.truth(true)),
            Node::Call(Function::Signum, ref args) => {
                let x = args[0];
                (graph.zero(), x, graph.integer(-1), graph.integer(1))
            }
            _ => continue,
        };
        let difference = graph.sub(b, a);
        if graph.symbols(difference).iter().all(|symbol| matches!(symbol, Symbol::Parameter(_))) {
            continue;
        }
        let opposite = graph.neg(difference);
        let mut equal = |a: Id, b: Id| {
            let rest = graph.sub(a, b);
            vanishes(graph, rest)
        };
        if let Some(edge) = edges.iter_mut().find(|edge| equal(edge.difference, difference)) {
            edge.changing.push(Changing { node, below, above });
        } else if let Some(edge) = edges.iter_mut().find(|edge| equal(edge.difference, opposite)) {
            edge.changing.push(Changing { node, below: above, above: below });
        } else {
            let equal = if graph.as_number(a).is_some() { [b, a] } else { [a, b] };
            edges.push(Edge { equal, difference, changing: vec![Changing { node, below, above }] });
        }
    }
    edges
}

/// The function on one side of an edge, continued across it.
fn on_side(graph: &mut Graph, function: Id, edge: &Edge, value: impl Fn(&Changing) -> Id) -> Id {
    let mut fixed = Substitution::new(|_: &mut Graph, _| None);
    for changing in &edge.changing {
        fixed.insert(changing.node, value(changing));
    }
    fixed.apply(graph, function)
}

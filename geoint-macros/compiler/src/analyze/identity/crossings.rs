//! Surfaces on which a function may jump along a field. The derivative of the function does not show these jumps.
//!
//! Conditions, signs and angles by `atan2` jump. A proof uses identities of the graph; a failed proof counts as a jump, so all answers are on the safe
//! side.

use super::angles::{angles, broken_at};
use super::surface::vanishes_on;
use super::vanishes;
use crate::diff;
use crate::ir::substitute::{Substitution, replaced};
use crate::ir::{Function, Graph, Id, Node, Ratio, Symbol};

/// An edge: the surface on which two numbers are equal, with the conditions and signs that change there.
#[derive(Clone, Debug)]
pub(crate) struct Edge {
    pub(crate) equal: [Id; 2],
    /// Zero on the surface.
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

/// Returns the edges on which the limits of a function from both sides are not proven to be equal.
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
    /// Two numbers that are equal on the surface. For an angle, a common factor of both arguments of `atan2`, and zero.
    pub(crate) equal: [Id; 2],
    /// A condition, sign or angle that changes. A message points at this node.
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
    /// Both arguments of an angle have a common factor that changes its sign: solutions lead across its zeros, where the angle jumps by π.
    Angle,
}

/// Returns a surface on which a function may jump along a field. Returns `None` if the function is proven not to jump.
///
/// A function does not jump if the limits from both sides are equal, or if no solution leads from one side to the other. A surface that contains whole
/// solutions counts as well, because rounding moves states across it, unless [`is_exact`] holds.
pub(crate) fn may_jump(graph: &mut Graph, x: &[Symbol], field: &[Id], function: Id) -> Option<Discontinuity> {
    for edge in edges_of_jumps(graph, function) {
        let found = |kind| Discontinuity { equal: edge.equal, node: edge.changing[0].node, kind };
        if is_crossed(graph, x, field, edge.difference) {
            return Some(found(Kind::Crossed));
        }
        if !is_exact(graph, x, field, edge.difference) {
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

/// Returns whether solutions may lead across the zeros of a difference. They do not if the rate of the difference is proven to vanish there: each
/// zero then belongs to a solution within the surface.
fn is_crossed(graph: &mut Graph, x: &[Symbol], field: &[Id], difference: Id) -> bool {
    let rate = diff::derivative_along(graph, x, field, difference, None);
    let rate = graph.sum(&rate);
    !vanishes_on(graph, difference, rate)
}

/// Returns whether no rounding moves a state off the zeros of a difference.
///
/// Each factor of the difference must read resting coordinates only, or must be a coordinate whose rate vanishes with it: steps keep both exactly.
fn is_exact(graph: &mut Graph, x: &[Symbol], field: &[Id], difference: Id) -> bool {
    let (read, zero) = (graph.symbols(difference), graph.zero());
    let factors = graph.factors(graph.coefficient(difference).1);
    let mut keeps = |(factor, _): &(Id, Ratio)| {
        let read = graph.symbols(*factor);
        x.iter().zip(field).all(|(symbol, rate)| {
            let is_coordinate = *graph.node(*factor) == Node::Symbol(*symbol);
            let rate = if is_coordinate { replaced(graph, *rate, *symbol, zero) } else { *rate };
            !read.contains(symbol) || graph.is_zero(rate)
        })
    };
    !read.contains(&Symbol::Time) && factors.iter().all(&mut keeps)
}

/// Returns the edges of all conditions and signs that read more than parameters.
fn edges(graph: &mut Graph, function: Id) -> Vec<Edge> {
    let mut edges: Vec<Edge> = vec![];
    for node in graph.reachable(&[function]) {
        let (a, b, below, above) = match *graph.node(node) {
            // `<`, `≤` and `==` differ on the edge only. The limits from both sides decide.
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

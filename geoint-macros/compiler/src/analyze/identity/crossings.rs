//! Surfaces on which a function may jump along a field.
//!
//! An integral needs two proofs: its derivative along the field is zero (`claims`), and it does not jump along solutions (here). Energies are tested for edges
//! only, because steps end at a jump of the energy. Conditions, signs and angles by `atan2` jump; no other operation of energies does. Poles and ends of domains
//! are the subject of `derive/domain`.
//!
//! A proof uses identities of the graph. A failed proof counts as a jump. The exception is `share_a_part`: two surfaces count as separate unless one is proven to
//! contain a part of the other.

use super::angles::{angles, broken_at};
use super::surface::{moves, parts, vanishes_on, vanishes_on_a_part};
use super::vanishes;
use crate::analyze::irregular_turn;
use crate::diff;
use crate::ir::substitute::{Substitution, replaced};
use crate::ir::{Function, Graph, Id, Node, Ratio, Relation, Symbol};

/// An edge: the surface on which two numbers are equal, with the conditions and signs that change there.
#[derive(Clone, Debug)]
pub(crate) struct Edge {
    pub(crate) equal: [Id; 2],
    /// Zero on the surface.
    pub(crate) difference: Id,
    /// The conditions and signs. There is at least one.
    changing: Vec<Changing>,
}

/// A condition or sign that changes at an edge, with its values for a negative difference, on the edge, and for a positive difference.
#[derive(Clone, Copy, Debug)]
struct Changing {
    node: Id,
    below: Id,
    on_edge: Id,
    above: Id,
}

/// Returns the edges on which a function is not proven to have one value: its limits from both sides, and its value on the edge itself.
pub(crate) fn edges_of_jumps(graph: &mut Graph, function: Id) -> Vec<Edge> {
    let edges = edges(graph, &[function]);
    edges.iter().filter(|edge| may_jump_at(graph, function, edge, &edges)).cloned().collect()
}

/// Returns whether a function is not proven to have one value on an edge. `all` contains all edges of the function.
fn may_jump_at(graph: &mut Graph, function: Id, edge: &Edge, all: &[Edge]) -> bool {
    let [below, on_edge, above] =
        [|node: &Changing| node.below, |node: &Changing| node.on_edge, |node: &Changing| node.above]
            .map(|value| continued(graph, function, edge, value));
    let heights = [graph.sub(above, below), graph.sub(on_edge, below)];
    // On the edge the function often is one of its two continuations.
    let is_on_one_side = on_edge == below || on_edge == above;
    let heights = if is_on_one_side { &heights[..1] } else { &heights[..] };
    // The proof holds all other conditions fixed. It fails if one of them changes on the same surface, as x < 0 and 2x < 0 do.
    let read = graph.reachable(heights);
    let other_edges = all.iter().filter(|other| other.difference != edge.difference);
    let mut remaining = other_edges.filter(|other| other.changing.iter().any(|changing| read.contains(&changing.node)));
    remaining.any(|other| share_a_part(graph, edge, other))
        || !heights.iter().all(|height| vanishes_on(graph, edge.difference, *height))
}

/// Returns whether the other difference is proven to vanish on a part of an edge.
fn share_a_part(graph: &mut Graph, edge: &Edge, other: &Edge) -> bool {
    parts(graph, edge.difference).into_iter().any(|part| vanishes_on_a_part(graph, part, other.difference))
}

/// A surface on which a function may jump along a solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Discontinuity {
    /// Two numbers that are equal on the surface. For an angle, a common factor of both arguments of `atan2`, and zero. For a turn, the angle twice.
    pub(crate) equal: [Id; 2],
    /// A condition, sign or angle that changes. A message points at this node.
    pub(crate) node: Id,
    pub(crate) kind: Kind,
}

/// How a function may jump.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Solutions may lead across the surface. A flux is not tested for this.
    Crossed,
    /// Solutions stay on the surface: rounding decides on which side.
    Followed,
    /// Both arguments of an angle have a common factor that changes its sign: solutions lead across its zeros, where the angle jumps by π.
    Angle,
    /// An angle turns, and its turns are not known to add multiples of one constant to the function.
    Turn,
}

/// Returns a surface on which a function may jump along a field. Returns `None` if the function is proven not to jump.
///
/// A function does not jump if the limits from both sides are equal, or if no solution leads from one side to the other. A surface of conditions that contains
/// whole solutions counts as well, because rounding moves states across it, unless [`is_exact`] holds. On the surface of an angle, the angle is undefined.
///
/// Turns of an angle that add a multiple of one constant do not count: the values of such a function are compared up to turns.
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
    irregular_turn(graph, function).map(|angle| Discontinuity { equal: [angle, angle], node: angle, kind: Kind::Turn })
}

/// Returns a surface on which the flux of the density ρ along the field f may jump. Such a surface gains or loses measure although div(ρf) = 0 on both sides.
///
/// The flux through an edge g = 0 is ρ·(f·∇g + ∂g/∂t). Every angle counts as a jump.
pub(crate) fn flux_may_jump(graph: &mut Graph, x: &[Symbol], field: &[Id], density: Id) -> Option<Discontinuity> {
    let functions = [field, &[density]].concat();
    let edges = edges(graph, &functions);
    for edge in &edges {
        let mut flux = diff::derivative_along(graph, x, field, edge.difference, None);
        flux.iter_mut().for_each(|term| *term = graph.mul(density, *term));
        let flux = graph.sum(&flux);
        if may_jump_at(graph, flux, edge, &edges) {
            return Some(Discontinuity { equal: edge.equal, node: edge.changing[0].node, kind: Kind::Crossed });
        }
    }
    let angle = functions.iter().find_map(|function| angles(graph, *function).first().copied())?;
    Some(Discontinuity { equal: [angle, angle], node: angle, kind: Kind::Turn })
}

/// Returns whether solutions may lead across the zeros of a difference.
///
/// A factor g keeps its sign if its rate is zero, or if its rate is Lipschitz and vanishes where g does: then |g'| ≤ L·|g|. The second proof needs a g with
/// simple zeros. [`parts`] has removed all powers, and [`is_exact`] accepts only coordinates and resting factors.
fn is_crossed(graph: &mut Graph, x: &[Symbol], field: &[Id], difference: Id) -> bool {
    parts(graph, difference).into_iter().any(|part| {
        // ∇g·f + ∂g/∂t.
        let rate = diff::derivative_along(graph, x, field, part, None);
        let rate = graph.sum(&rate);
        !(vanishes(graph, rate) || vanishes_on(graph, part, rate) && is_lipschitz(graph, rate))
    })
}

/// Returns whether a rate has no jumps and no infinite slopes where it is defined. Otherwise a factor may change its sign: x' = ∛x² leads across x = 0.
fn is_lipschitz(graph: &mut Graph, rate: Id) -> bool {
    let is_steep = |id: Id| match graph.node(id) {
        Node::Power(base, exponent) => (Ratio::ZERO..Ratio::ONE).contains(exponent) && !graph.is_positive(*base),
        // Functions with an end of their domain, such as asin, and functions that are not smooth.
        Node::Call(Function::Cbrt | Function::Atan2, _) => true,
        Node::Call(..) => graph.is_partial(id),
        _ => false,
    };
    let has_steep = graph.reachable(&[rate]).into_iter().any(|id| graph.reads_any(id, moves) && is_steep(id));
    !has_steep && edges_of_jumps(graph, rate).is_empty()
}

/// Returns whether no step moves a state off the zeros of a difference, not even by rounding.
///
/// Each factor of the difference must read resting coordinates only, or must be a coordinate whose rate vanishes with it. Every method keeps a resting coordinate,
/// and a coordinate that is zero, bit by bit. One factor that rounding moves is enough to change the sign of the difference. States beside the surface are not
/// covered: a step that is much too long may lead across it. The sign of a coordinate that starts as −0 is not covered either: a sum makes +0 of it.
fn is_exact(graph: &mut Graph, x: &[Symbol], field: &[Id], difference: Id) -> bool {
    let zero = graph.zero();
    parts(graph, difference).into_iter().all(|factor| {
        let read = graph.symbols(factor);
        !read.contains(&Symbol::Time)
            && x.iter().zip(field).filter(|(symbol, _)| read.contains(symbol)).all(|(symbol, rate)| {
                let is_coordinate = *graph.node(factor) == Node::Symbol(*symbol);
                let rate = if is_coordinate { replaced(graph, *rate, *symbol, zero) } else { *rate };
                graph.is_zero(rate)
            })
    })
}

/// Returns the edges of all conditions and signs, except those that read parameters only: parameters are constant during a run.
fn edges(graph: &mut Graph, functions: &[Id]) -> Vec<Edge> {
    let mut edges: Vec<Edge> = vec![];
    for node in graph.reachable(functions) {
        let (a, b, [below, on_edge, above]) = match *graph.node(node) {
            Node::Compare(relation, a, b) => {
                let holds = match relation {
                    Relation::Less => [false, false, true],
                    Relation::LessEqual => [false, true, true],
                    Relation::Equal => [false, true, false],
                };
                (a, b, holds.map(|holds| graph.truth(holds)))
            }
            Node::Call(Function::Signum, ref args) => {
                let x = args[0];
                // The sign of +0 is 1.
                (graph.zero(), x, [-1, 1, 1].map(|sign| graph.integer(sign)))
            }
            _ => continue,
        };
        let difference = graph.sub(b, a);
        if !graph.reads_any(difference, moves) {
            continue;
        }
        let opposite = graph.neg(difference);
        let mut equal = |a: Id, b: Id| {
            let rest = graph.sub(a, b);
            vanishes(graph, rest)
        };
        if let Some(edge) = edges.iter_mut().find(|edge| equal(edge.difference, difference)) {
            edge.changing.push(Changing { node, below, on_edge, above });
        } else if let Some(edge) = edges.iter_mut().find(|edge| equal(edge.difference, opposite)) {
            edge.changing.push(Changing { node, below: above, on_edge, above: below });
        } else {
            let equal = if graph.as_number(a).is_some() { [b, a] } else { [a, b] };
            edges.push(Edge { equal, difference, changing: vec![Changing { node, below, on_edge, above }] });
        }
    }
    edges
}

/// Returns the function with one choice of the values of all conditions and signs that change at an edge, at all states.
fn continued(graph: &mut Graph, function: Id, edge: &Edge, value: impl Fn(&Changing) -> Id) -> Id {
    let mut fixed = Substitution::new(|_: &mut Graph, _| None);
    for changing in &edge.changing {
        fixed.insert(changing.node, value(changing));
    }
    fixed.apply(graph, function)
}

//! Where may a function jump on the way along a field? Its derivative does not show that.

use super::surface::vanishes_on;
use super::vanishes;
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Symbol};

/// Conditions and signs that change where two numbers are equal.
#[derive(Clone, Debug)]
pub(crate) struct Edge {
    pub(crate) equal: [Id; 2],
    pub(crate) difference: Id,
    /// Each with what it is where the difference is negative, and where it is positive.
    decided: Vec<(Id, [Id; 2])>,
}

/// Where a function may jump: there it was not proven that both its sides are equal.
pub(crate) fn edges_of_jumps(graph: &mut Graph, function: Id) -> Vec<Edge> {
    let mut edges = edges(graph, function);
    edges.retain(|edge| {
        let height = height(graph, function, edge);
        !vanishes_on(graph, edge.difference, height)
    });
    edges
}

/// What is equal where a function may jump while a field is followed; nothing if it was proven not to.
///
/// It does not jump where both its sides are equal, nor where no solution leads from one to the other.
pub(crate) fn may_jump(graph: &mut Graph, x: &[Symbol], field: &[Id], function: Id) -> Option<[Id; 2]> {
    edges_of_jumps(graph, function).into_iter().find_map(|edge| {
        let crossing = diff::derivative_along(graph, x, field, edge.difference, None);
        let crossing = graph.sum(&crossing);
        (!vanishes_on(graph, edge.difference, crossing)).then_some(edge.equal)
    })
}

/// Of all conditions and signs that read the state or time.
fn edges(graph: &mut Graph, function: Id) -> Vec<Edge> {
    let mut edges: Vec<Edge> = vec![];
    for node in graph.reachable(&[function]) {
        let ([a, b], sides) = match *graph.node(node) {
            // One that holds on the edge alone has to make no difference there, either.
            Node::Compare(_, a, b) => ([a, b], [false, true].map(|side| graph.truth(side))),
            Node::Call(Function::Signum, ref args) => {
                let x = args[0];
                ([graph.zero(), x], [-1, 1].map(|side| graph.integer(side)))
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
            edge.decided.push((node, sides));
        } else if let Some(edge) = edges.iter_mut().find(|edge| equal(edge.difference, opposite)) {
            edge.decided.push((node, [sides[1], sides[0]]));
        } else {
            let equal = if graph.as_number(a).is_some() { [b, a] } else { [a, b] };
            edges.push(Edge { equal, difference, decided: vec![(node, sides)] });
        }
    }
    edges
}

/// The function on one side of an edge, less that on the other.
fn height(graph: &mut Graph, function: Id, edge: &Edge) -> Id {
    let [below, above] = [0, 1].map(|side| {
        let mut decided = Substitution::new(|_: &mut Graph, _| None);
        for (node, sides) in &edge.decided {
            decided.insert(*node, sides[side]);
        }
        decided.apply(graph, function)
    });
    graph.sub(above, below)
}

//! Lagrangians with a kink: momenta jump there, and no velocity belongs to what is between.

use super::mass::is_velocity;
use crate::analyze::{self, conditions, decided, vanishes};
use crate::diff;
use crate::ir::substitute::replaced;
use crate::ir::{Graph, Id, Node, Symbol};

/// Whether a momentum jumps where a condition changes that is affine in a velocity.
pub(super) fn jumps(graph: &mut Graph, momentum: Id) -> bool {
    let conditions = conditions(graph, momentum);
    conditions.into_iter().any(|condition| {
        let Node::Compare(_, a, b) = *graph.node(condition) else { return false };
        let difference = graph.sub(a, b);
        let symbols = graph.symbols(difference);
        symbols
            .into_iter()
            .filter(|symbol| is_velocity(*symbol))
            .any(|v| height(graph, momentum, (condition, difference), v).is_some_and(|h| !vanishes(graph, h)))
    })
}

/// What a node jumps by where a difference vanishes that is affine in this velocity, and with it a condition changes.
fn height(graph: &mut Graph, node: Id, (condition, difference): (Id, Id), v: Symbol) -> Option<Id> {
    let slope = diff::partial(graph, difference, v);
    if !analyze::is_polynomial_in(graph, &[difference], 1, |symbol| symbol == v) || graph.is_zero(slope) {
        return None;
    }
    let (own, away) = (graph.symbol(v), graph.div(difference, slope));
    let edge = graph.sub(own, away);
    let [yes, no] = [true, false].map(|holds| decided(graph, node, condition, holds));
    let height = graph.sub(yes, no);
    Some(replaced(graph, height, v, edge))
}

//! Detects Lagrangians with a kink. Momenta jump at a kink, and no velocity belongs to the momenta in between.

use super::is_velocity;
use crate::analyze::{self, conditions, jump_of, vanishes};
use crate::diff;
use crate::ir::substitute::replaced;
use crate::ir::{Graph, Id, Node, Symbol};

/// Returns whether a momentum jumps where a condition changes that is affine in a velocity.
pub(super) fn jumps(graph: &mut Graph, momentum: Id) -> bool {
    let conditions = conditions(graph, momentum);
    conditions.into_iter().any(|condition| {
        let Node::Compare(_, a, b) = *graph.node(condition) else { return false };
        let difference = graph.sub(a, b);
        let mut velocities = graph.symbols(difference);
        velocities.retain(|symbol| is_velocity(*symbol));
        velocities
            .into_iter()
            .any(|v| height(graph, momentum, condition, difference, v).is_some_and(|h| !vanishes(graph, h)))
    })
}

/// Returns the jump of a node at the zero of the difference that a condition compares. The difference must be affine in the velocity `v`.
fn height(graph: &mut Graph, node: Id, condition: Id, difference: Id, v: Symbol) -> Option<Id> {
    let slope = diff::partial_derivative(graph, difference, v);
    if !analyze::is_polynomial_in(graph, &[difference], 1, |symbol| symbol == v) || graph.is_zero(slope) {
        return None;
    }
    let (own, away) = (graph.symbol(v), graph.div(difference, slope));
    let edge = graph.sub(own, away);
    let height = jump_of(graph, node, condition);
    Some(replaced(graph, height, v, edge))
}

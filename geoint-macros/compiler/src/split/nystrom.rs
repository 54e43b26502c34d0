//! The condition under which tables of Runge–Kutta–Nyström type keep their order for two pieces.

use super::flow::Piece;
use crate::analyze;
use crate::diff;
use crate::ir::{Graph, Id};

/// Returns whether there are two pieces, A and B, with {B, {B, {B, A}}} = 0.
pub(super) fn is_nystrom(graph: &mut Graph, pieces: &[Piece], degrees: u32) -> bool {
    let [a, b] = pieces else { return false };
    let nested = (0..3).fold(a.energy, |nested, _| bracket(graph, b.energy, nested, degrees));
    analyze::identity(graph, nested).is_zero()
}

/// Reverses two pieces if only the reversed order satisfies the condition. Returns whether the condition holds for the final order.
pub(super) fn put_in_nystrom_order(graph: &mut Graph, pieces: &mut [Piece], degrees: u32) -> bool {
    for _ in 0..2 {
        if is_nystrom(graph, pieces, degrees) {
            return true;
        }
        pieces.reverse();
    }
    false
}

/// Returns the Poisson bracket {f, g} = ∂f/∂q·∂g/∂p − ∂f/∂p·∂g/∂q.
fn bracket(graph: &mut Graph, f: Id, g: Id, degrees: u32) -> Id {
    let [f, g] = [f, g].map(|root| diff::gradient(graph, root, degrees));
    let mut sum = graph.zero();
    for i in 0..degrees as usize {
        let straight = graph.mul(f.q[i], g.p[i]);
        let crossed = graph.mul(f.p[i], g.q[i]);
        let term = graph.sub(straight, crossed);
        sum = graph.add(sum, term);
    }
    sum
}

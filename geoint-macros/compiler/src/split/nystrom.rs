//! Do tables of Runge–Kutta–Nyström type keep their order for two pieces?

use super::flow::Piece;
use crate::analyze;
use crate::diff;
use crate::ir::{Graph, Id};

/// Whether these are two, A and B, with {B, {B, {B, A}}} = 0.
pub(super) fn is_nystrom(graph: &mut Graph, pieces: &[Piece], degrees: u32) -> bool {
    let [a, b] = pieces else { return false };
    let mut nested = a.energy;
    for _ in 0..3 {
        nested = bracket(graph, b.energy, nested, degrees);
    }
    analyze::identity(graph, nested).is_zero()
}

/// The same; in the other order, if that is the one.
pub(super) fn in_order_of_nystrom(graph: &mut Graph, pieces: &mut [Piece], degrees: u32) -> bool {
    if is_nystrom(graph, pieces, degrees) {
        return true;
    }
    pieces.reverse();
    let reversed = is_nystrom(graph, pieces, degrees);
    if !reversed {
        pieces.reverse();
    }
    reversed
}

/// {f, g} = ∂f/∂q·∂g/∂p − ∂f/∂p·∂g/∂q.
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

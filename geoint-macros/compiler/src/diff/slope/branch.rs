//! The discrete gradient of an `if`: the gradient of a branch if both ends of the step are in it, and a secant between two branches otherwise.
//!
//! Only the ends are compared. A step that leaves a branch and returns counts as inside.

use super::super::sweep::{self, Entries};
use super::ends::{Slopes, coordinate_increment};
use crate::ir::{Graph, Id, Node, Ratio};

impl Slopes {
    /// The slopes of an `if`, or of a whole chain of `else if`. Each piece is swept separately, and stays a branch.
    ///
    /// One secant serves all pairs of pieces. A secant for each condition would contain the rest of the chain, and the code would grow quadratically with
    /// the number of conditions.
    pub(super) fn branch(&mut self, graph: &mut Graph, id: Id) -> Entries {
        let mut pieces = vec![];
        let mut rest = id;
        while let Node::Select(condition, value, next) = *graph.node(rest) {
            pieces.push((condition, value));
            rest = next;
        }
        let (mut inside, mut same) = (self.gradient(graph, rest), graph.truth(true));
        for (condition, value) in pieces.into_iter().rev() {
            let value = self.gradient(graph, value);
            inside = sweep::select(graph, condition, &value, &inside);
            let at_end = self.end(graph, condition);
            same = same_piece(graph, [condition, at_end], same);
        }
        if matches!(graph.node(same), Node::Truth(true)) {
            return inside;
        }
        let across = self.secant(graph, id);
        sweep::select(graph, same, &inside, &across)
    }

    /// m + ((Δf − m·d)/(d·d)) d with the mean m of the gradients at both ends. Each branch is evaluated at its own end, and so in its own domain.
    ///
    /// O. Gonzalez, J. Nonlinear Sci. 6 (1996) 449, eq. 2.8.
    fn secant(&mut self, graph: &mut Graph, id: Id) -> Entries {
        let gradient = sweep::gradient(graph, id);
        let (mut along, mut squares, mut means) = (vec![], vec![], vec![]);
        for symbol in graph.symbols(id) {
            let Some(increment) = coordinate_increment(graph, symbol) else { continue };
            let slope = gradient.get(&symbol).copied().unwrap_or_else(|| graph.zero());
            let mean = self.mean(graph, slope);
            along.push(graph.mul(mean, increment));
            squares.push(graph.pow(increment, Ratio::integer(2)));
            means.push((symbol, mean, increment));
        }
        let (along, squares) = (graph.sum(&along), graph.sum(&squares));
        let end = self.end(graph, id);
        let correction = graph.build((end - id - along) / squares);
        means
            .into_iter()
            .map(|(symbol, mean, increment)| (symbol, graph.build(mean + correction * increment)))
            .collect()
    }
}

/// A condition that is true if another condition holds at both ends of a step, or fails at both ends and `rest` is true.
fn same_piece(graph: &mut Graph, [start, end]: [Id; 2], rest: Id) -> Id {
    // The condition reads no coordinate.
    if start == end {
        return graph.or(start, rest);
    }
    let both = graph.and(start, end);
    let fails = [graph.not(start), graph.not(end)];
    let neither = graph.and(fails[0], fails[1]);
    let neither = graph.and(neither, rest);
    graph.or(both, neither)
}

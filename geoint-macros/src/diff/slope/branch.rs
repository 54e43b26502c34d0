//! An `if`: the slope of a branch while the step stays in it, and what bridges both where it does not.

use super::super::sweep::{self, Entries};
use super::ends::{Slopes, coordinate_increment};
use crate::ir::{Graph, Id, Ratio};

impl Slopes {
    /// The slopes of `if condition { first } else { second }`. Each branch is swept on its own, and stays a branch.
    pub(super) fn branch(&mut self, graph: &mut Graph, id: Id, condition: Id, first: Id, second: Id) -> Entries {
        let (first, second) = (self.gradient(graph, first), self.gradient(graph, second));
        let inside = sweep::select(graph, condition, &first, &second);
        let at_end = self.end(graph, condition);
        if at_end == condition {
            return inside;
        }
        let same = same(graph, condition, at_end);
        let across = self.secant(graph, id);
        sweep::select(graph, same, &inside, &across)
    }

    /// m + ((Δf − m·d)/(d·d)) d with the mean m of the gradients at both ends: what a step from one branch to another
    /// needs keeps to the domains of both. O. Gonzalez, J. Nonlinear Sci. 6 (1996) 449, eq. 2.8.
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
        let change = graph.sub(end, id);
        let missing = graph.sub(change, along);
        let correction = graph.div(missing, squares);
        let entry = |(symbol, mean, increment)| {
            let part = graph.mul(correction, increment);
            (symbol, graph.add(mean, part))
        };
        means.into_iter().map(entry).collect()
    }
}

/// Whether two conditions agree.
fn same(graph: &mut Graph, a: Id, b: Id) -> Id {
    let (not_a, not_b) = (graph.not(a), graph.not(b));
    let (both, neither) = (graph.and(a, b), graph.and(not_a, not_b));
    graph.or(both, neither)
}

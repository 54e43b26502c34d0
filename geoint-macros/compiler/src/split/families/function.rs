//! Family "function of a piece": F(A) for an energy A with a known flow. A is constant, and F(A) moves as A does, but F'(A) times as fast.

use super::super::flow::{Flow, Group, Rules};
use super::super::polynomial::{is_free, reads};
use crate::diff;
use crate::ir::substitute::{Substitution, replaced};
use crate::ir::{Graph, Id, Node, Symbol};

/// Returns the flow of A of length h·F'(A), for the largest A whose flow `rules` know.
pub(super) fn solve(graph: &mut Graph, group: &Group, rules: Rules<'_>) -> Option<Flow> {
    if !group.clock.is_steady(graph, group.energy) {
        return None;
    }
    let mut inner = group.energy;
    while let Some(next) = only_operand(graph, inner) {
        inner = next;
        if matches!(graph.node(inner), Node::Symbol(_)) {
            return None;
        }
        // If F is linear, the energy is a multiple of A, and A needs the same rules as the energy.
        let Some(speed) = speed(graph, group.energy, inner) else { continue };
        if let Some(flow) = rules(graph, &Group { energy: inner, ..*group }) {
            let h = graph.symbol(Symbol::StepLength);
            let length = graph.mul(h, speed);
            let mut ends = Substitution::new(|_, symbol| (symbol == Symbol::StepLength).then_some(length));
            let mut moved = |all: &[Id]| all.iter().map(|end| ends.apply(graph, *end)).collect::<Vec<_>>();
            let (q, p) = (moved(&flow.q), moved(&flow.p));
            return Some(Flow { q, p, s: flow.s });
        }
    }
    None
}

/// Returns the operand of a node that reads coordinates, if exactly one operand does.
fn only_operand(graph: &Graph, id: Id) -> Option<Id> {
    let mut reading =
        graph.node(id).children().into_iter().filter(|child| !is_free(graph, *child, &Symbol::is_coordinate));
    let first = reading.next()?;
    reading.all(|other| other == first).then_some(first)
}

/// Returns F'(A) for `whole` = F(A), unless F is linear.
fn speed(graph: &mut Graph, whole: Id, inner: Id) -> Option<Id> {
    // `ActionIncrement` stands for A.
    let name = graph.symbol(Symbol::ActionIncrement);
    let mut named = Substitution::new(|_, _| None);
    named.insert(inner, name);
    let function = named.apply(graph, whole);
    let slope = diff::partial_derivative(graph, function, Symbol::ActionIncrement);
    if !reads(graph, slope, Symbol::ActionIncrement) {
        return None;
    }
    Some(replaced(graph, slope, Symbol::ActionIncrement, inner))
}

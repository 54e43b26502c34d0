//! Functions of an energy with a known flow: F(A) moves as A does, F'(A) times as fast, and A stays.

use super::super::flow::{Flow, Group, Rules};
use super::super::polynomial::is_free;
use super::super::time::Clock;
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Node, Symbol};

/// The flow of A over h·F'(A), for the largest A of which `rules` know it.
pub(super) fn solve(graph: &mut Graph, group: &Group, rules: Rules<'_>) -> Option<Flow> {
    if group.clock == Clock::Own && !is_free(graph, group.energy, &|symbol| symbol == Symbol::Time) {
        return None;
    }
    let mut inner = group.energy;
    while let Some(next) = only_operand(graph, inner) {
        inner = next;
        if matches!(graph.node(inner), Node::Symbol(_)) {
            return None;
        }
        // A multiple of A would be A again.
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

/// The only operand by which a node reads coordinates.
fn only_operand(graph: &Graph, id: Id) -> Option<Id> {
    let mut reading =
        graph.node(id).children().into_iter().filter(|child| !is_free(graph, *child, &Symbol::is_coordinate));
    let first = reading.next()?;
    reading.all(|other| other == first).then_some(first)
}

/// F'(A) where `whole` is F(A); nothing if that is free of A.
fn speed(graph: &mut Graph, whole: Id, inner: Id) -> Option<Id> {
    let name = graph.symbol(Symbol::ActionIncrement);
    let mut named = Substitution::new(|_, _| None);
    named.insert(inner, name);
    let function = named.apply(graph, whole);
    let slope = diff::partial(graph, function, Symbol::ActionIncrement);
    if is_free(graph, slope, &|symbol| symbol == Symbol::ActionIncrement) {
        return None;
    }
    Some(Substitution::new(|_, symbol| (symbol == Symbol::ActionIncrement).then_some(inner)).apply(graph, slope))
}

//! Degrees of freedom that know nothing of each other: each moves as if it were alone.

use super::super::flow::{Flow, Group, Rules};
use crate::analyze;
use crate::ir::{Graph, Id, Symbol};
use std::collections::BTreeSet;

/// Σ Aᵢ of energies that have no coordinate in common, if `rules` know the flow of each.
pub(super) fn solve(graph: &mut Graph, group: &Group, rules: Rules<'_>) -> Option<Flow> {
    let parts = parts(graph, group.energy);
    if parts.len() < 2 {
        return None;
    }
    let mut flow = Flow::rest(graph, group.degrees);
    for part in parts {
        let energy = graph.sum(&part.terms);
        let own = rules(graph, &Group { energy, ..*group })?;
        for i in part.degrees.into_iter().map(|i| i as usize) {
            (flow.q[i], flow.p[i]) = (own.q[i], own.p[i]);
        }
    }
    Some(flow)
}

/// Terms, and the degrees of freedom that they read.
struct Part {
    degrees: BTreeSet<u32>,
    terms: Vec<Id>,
}

/// The terms of an energy, those together that are connected by degrees of freedom; without those that move nothing.
fn parts(graph: &mut Graph, energy: Id) -> Vec<Part> {
    let mut parts: Vec<Part> = vec![];
    for term in analyze::single_terms(graph, energy) {
        let degree = |symbol: &Symbol| match symbol {
            Symbol::Q(i) | Symbol::P(i) => Some(*i),
            _ => None,
        };
        let mut whole = Part { degrees: graph.symbols(term).iter().filter_map(degree).collect(), terms: vec![term] };
        if whole.degrees.is_empty() {
            continue;
        }
        for part in parts.extract_if(.., |part| !part.degrees.is_disjoint(&whole.degrees)).collect::<Vec<_>>() {
            whole.degrees.extend(part.degrees);
            whole.terms.splice(0..0, part.terms);
        }
        parts.push(whole);
    }
    parts
}

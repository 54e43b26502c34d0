//! Family "independent parts": a sum of energies without a common degree of freedom.
//!
//! The flows of the parts commute, and each part moves its own degrees of freedom only. Thus the flow of the sum consists of the flows of
//! the parts.

use super::super::flow::{Flow, Group, Rules};
use super::super::polynomial::degree_of_freedom;
use crate::analyze;
use crate::ir::{Graph, Id};
use std::collections::BTreeSet;

/// Returns the flow of a sum of energies without a common degree of freedom.
///
/// Returns `None` if the energy is one part only, or if `rules` find no flow of a part. Limit: a sum that separates only in other coordinates,
/// such as normal modes, is one part here. Only systems without an action use the family, so the result keeps s.
pub(super) fn solve(graph: &mut Graph, group: &Group, rules: Rules<'_>) -> Option<Flow> {
    let parts = parts(graph, group.energy);
    if parts.len() < 2 {
        return None;
    }
    let mut flow = Flow::rest(graph, group.degrees);
    for part in parts {
        let energy = graph.sum(&part.terms);
        // The part keeps the degrees of the group, so that indices of coordinates stay. Its flow leaves the coordinates of other parts at rest.
        let own = rules(graph, &Group { energy, ..*group })?;
        for i in part.degrees.into_iter().map(|i| i as usize) {
            (flow.q[i], flow.p[i]) = (own.q[i], own.p[i]);
        }
    }
    Some(flow)
}

/// A part of the energy.
struct Part {
    /// The degrees of freedom whose position or momentum a term reads.
    degrees: BTreeSet<u32>,
    /// The terms, whose sum is the energy of the part.
    terms: Vec<Id>,
}

/// Splits an energy into as many parts as possible without a common degree of freedom.
///
/// Terms belong to one part if a chain of terms connects them, in which neighbours share a degree of freedom. Terms without coordinates move
/// nothing and are left out.
fn parts(graph: &mut Graph, energy: Id) -> Vec<Part> {
    let mut parts: Vec<Part> = vec![];
    for term in analyze::single_terms(graph, energy) {
        let degrees = graph.symbols(term).into_iter().filter_map(degree_of_freedom).collect();
        let mut merged = Part { degrees, terms: vec![term] };
        if merged.degrees.is_empty() {
            continue;
        }
        // The term merges all parts with which it shares a degree of freedom.
        for part in parts.extract_if(.., |part| !part.degrees.is_disjoint(&merged.degrees)).collect::<Vec<_>>() {
            merged.degrees.extend(part.degrees);
            // Earlier terms of the energy stay before the new one.
            merged.terms.splice(0..0, part.terms);
        }
        parts.push(merged);
    }
    parts
}

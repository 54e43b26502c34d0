//! Fields x' = S(x) ∇H as sums of parts with known flows: one part for each group of terms of H, or for each plane.

mod linear;
mod solve;
mod poisson;
mod planar;

pub(crate) use planar::{planes, solved_planes};
pub(crate) use poisson::parts;

use super::time::Clock;
use crate::diff::field::Field;
use crate::ir::{Graph, Id, Symbol};
use std::collections::BTreeSet;

/// A rule for the flow of one kind of fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Rule {
    /// The name in reports.
    pub(crate) name: &'static str,
    /// The fields.
    pub(crate) fields: &'static str,
}

/// A part of a field.
#[derive(Debug)]
pub(crate) struct Part {
    /// The terms of H, or a velocity in the plane.
    pub(crate) formula: Id,
    pub(crate) rules: Vec<Rule>,
    pub(crate) clock: Clock,
    pub(crate) motion: Motion,
}

/// The motion of the coordinates that a part moves.
#[derive(Debug)]
pub(crate) enum Motion {
    /// The end of a flow of length h.
    Closed(Vec<(Symbol, Id)>),
    /// The mean velocity of a step in a plane, with its derivative by the increments.
    Solved([Symbol; 2], Field),
}

/// The reason why parts do not exist.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NoPart {
    /// The term or velocity without a flow.
    pub(crate) formula: Id,
    /// Two coordinates that the term reads and that are not in involution, or the coordinates of the plane.
    pub(crate) pair: Option<[Symbol; 2]>,
}

/// Returns the indices of the coordinates that a node reads.
fn read(graph: &Graph, id: Id) -> BTreeSet<u32> {
    graph.symbols(id).into_iter().filter_map(index).collect()
}

/// Returns the index of a coordinate.
fn index(symbol: Symbol) -> Option<u32> {
    if let Symbol::Position(i) = symbol { Some(i) } else { None }
}

/// Returns the clock of a part: if a rate reads time, time is frozen in the middle of a step.
fn clock(graph: &Graph, rates: &[(Symbol, Id)]) -> Clock {
    if rates.iter().any(|(_, rate)| graph.reads(*rate).t) { Clock::Stage } else { Clock::Own }
}

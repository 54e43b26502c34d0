//! Fields x' = S(x) ∇H as sums of pieces whose flows are known: by terms of H, or by planes.

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

/// What is known of a kind of fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Rule {
    /// What it is called in reports.
    pub(crate) name: &'static str,
    /// The fields.
    pub(crate) fields: &'static str,
}

/// A part of a field.
#[derive(Debug)]
pub(crate) struct Part {
    /// The term of H; of a plane, a velocity in it.
    pub(crate) formula: Id,
    pub(crate) rules: Vec<Rule>,
    pub(crate) clock: Clock,
    pub(crate) motion: Motion,
}

/// How a part moves what it moves.
#[derive(Debug)]
pub(crate) enum Motion {
    /// Where a flow of length h ends.
    Closed(Vec<(Symbol, Id)>),
    /// The mean velocity of a symmetric step of order 2, with its derivative by the increments.
    Solved([Symbol; 2], Field),
}

/// Why there are no such parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NoPart {
    /// The term, or a velocity, without a flow.
    pub(crate) formula: Id,
    /// Two coordinates: of a term, that it reads and that are not in involution; or those of the plane.
    pub(crate) pair: Option<[Symbol; 2]>,
}

/// Which coordinates a node reads.
fn read(graph: &Graph, id: Id) -> BTreeSet<u32> {
    let place = |symbol: &Symbol| if let Symbol::Position(i) = symbol { Some(*i) } else { None };
    graph.symbols(id).iter().filter_map(place).collect()
}

/// Frozen in the middle of a step, unless nothing reads time.
fn clock(graph: &Graph, rates: &[(Symbol, Id)]) -> Clock {
    if rates.iter().any(|(_, rate)| graph.reads(*rate).t) { Clock::Stage } else { Clock::Own }
}

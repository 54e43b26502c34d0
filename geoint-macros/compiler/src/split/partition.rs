//! The search for the best partition of an energy into pieces with known flows.

use super::atoms::atoms;
use super::families::{FAMILIES, piece};
use super::flow::{Piece, Space};
use super::linear_motion::hidden_linear_motion;
use super::nystrom::{is_nystrom, put_in_nystrom_order};
use super::powers::powers_of_forms;
use crate::analyze::{Split, Structure};
use crate::ir::{Graph, Id};
use crate::lower::Place;
use std::collections::BTreeMap;

/// The latency of a flow, in units of one sum. A flow starts after the preceding flow has ended.
const LATENCY: usize = 4;

/// The pieces, or a term that belongs to no piece.
pub(crate) type Pieces = Result<Partition, Id>;

/// H as a sum of pieces.
#[derive(Clone, Debug, Default)]
pub(crate) struct Partition {
    /// The pieces in the order of the first half of a step. The second half has the reverse order.
    pub(crate) pieces: Vec<Piece>,
    /// The estimated cost of a step, in units of one sum.
    pub(crate) cost: usize,
    /// Whether a flow may end before its full length.
    ends_early: bool,
    /// Whether there are two pieces, A and B, with {B, {B, {B, A}}} = 0.
    pub(crate) nystrom: bool,
    /// Whether the partition was chosen because A contains all linear motion, and not for its cost.
    pub(crate) linear: bool,
    /// The other partitions that were found.
    pub(crate) rejected: Vec<Rejected>,
}

/// A partition that was found but not chosen.
#[derive(Clone, Debug)]
pub(crate) struct Rejected {
    pub(crate) energies: Vec<Id>,
    pub(crate) cost: usize,
}

/// Splits H into pieces. If the user gave `groups`, each group becomes a piece.
///
/// With an action, the partition with the fewest pieces is chosen. Without an action, the order of preference is:
/// 1. one piece, if its flow is known;
/// 2. all linear motion as A and the rest as B, if tables of Runge–Kutta–Nyström type apply;
/// 3. pieces whose flows never end early, such as shears; flows of qᵏpⁿ may end early;
/// 4. the cheapest pieces, which need not be the fewest.
pub(crate) fn pieces(graph: &mut Graph, energy: Id, space: Space, groups: Option<&[(Id, Place)]>) -> Pieces {
    if let Some(groups) = groups {
        // The user's order stays: it determines the piece in the middle of a step.
        let pieces: Result<Vec<Piece>, Id> =
            groups.iter().map(|(group, _)| piece(graph, *group, space).ok_or(*group)).collect();
        let mut given = Partition::of(graph, pieces?);
        given.nystrom = !space.action && is_nystrom(graph, &given.pieces, space.degrees);
        return Ok(given);
    }
    let whole = atoms(graph, energy, space)?;
    let mut search = Search::new(&whole, space);
    let fewest = search.best(graph, energy, Measure::Fewest)?;
    let mut found = vec![ordered(graph, fewest, Middle::Kick)];
    if !space.action {
        let cheapest = search.best(graph, energy, Measure::Cheapest)?;
        found.push(ordered(graph, cheapest, Middle::Kick));
        let powers = powers_of_forms(graph, &whole, space)
            .and_then(|atoms| Search::new(&atoms, space).best(graph, energy, Measure::Cheapest).ok());
        found.extend(powers.map(|pieces| ordered(graph, pieces, Middle::Mixed)));
    }
    let mut found: Vec<Partition> = found.into_iter().map(|pieces| Partition::of(graph, pieces)).collect();
    // One piece comes first even if it ends early: it has no splitting error, and its flow ends only where the motion ends.
    found.sort_by_key(|partition| {
        let pieces = partition.pieces.len();
        (pieces > 1, partition.ends_early, partition.cost, pieces)
    });
    found.dedup_by_key(|partition| partition.energies());
    let around = if found[0].pieces.len() > 1 { around_linear_motion(graph, energy, space) } else { None };
    let mut best = around.unwrap_or_else(|| {
        let mut cheapest = found.remove(0);
        cheapest.nystrom = !space.action && put_in_nystrom_order(graph, &mut cheapest.pieces, space.degrees);
        cheapest
    });
    best.rejected = found.iter().map(|other| Rejected { energies: other.energies(), cost: other.cost }).collect();
    Ok(best)
}

/// Returns all linear motion as A and the rest as B, if the cheapest partition would separate linear terms.
///
/// If pieces share a motion of frequency ω, the error is of size (hω)ⁿ, however small the rest is. Around linear motion, the error is
/// proportional to the rest, at almost the same cost.
fn around_linear_motion(graph: &mut Graph, energy: Id, space: Space) -> Option<Partition> {
    if space.action {
        return None;
    }
    let parts = hidden_linear_motion(graph, energy, space)?;
    let pieces: Option<Vec<Piece>> = parts.into_iter().map(|energy| piece(graph, energy, space)).collect();
    let mut partition = Partition::of(graph, pieces?);
    partition.linear = true;
    partition.nystrom = is_nystrom(graph, &partition.pieces, space.degrees);
    (partition.nystrom && !partition.ends_early).then_some(partition)
}

/// Returns the pieces of H(q, p, t) if kick and drift do not exist or if the user gave other groups.
pub(crate) fn coupled_pieces(
    graph: &mut Graph,
    structure: &Structure,
    degrees: u32,
    groups: Option<&[(Id, Place)]>,
) -> Option<Pieces> {
    let asked = matches!(structure.split, Split::Coupled(_)) || groups.is_some();
    let whole = asked && structure.conservative();
    whole.then(|| pieces(graph, structure.energy, Space { degrees, action: false }, groups))
}

impl Partition {
    fn of(graph: &mut Graph, pieces: Vec<Piece>) -> Partition {
        let costs: Vec<usize> = pieces.iter().map(|piece| LATENCY + piece.cost(graph)).collect();
        // A step applies each flow twice, except for the last flow. Its first flow merges with the last flow of the preceding step.
        let ends = [costs.first(), costs.last()].into_iter().flatten().sum::<usize>();
        let cost = if costs.len() > 1 { 2 * costs.iter().sum::<usize>() - ends } else { ends / 2 };
        let ends_early = pieces.iter().any(|piece| piece.flow.ends_early(graph));
        Partition { pieces, cost, ends_early, nystrom: false, linear: false, rejected: vec![] }
    }

    fn energies(&self) -> Vec<Id> {
        self.pieces.iter().map(|piece| piece.energy).collect()
    }
}

/// The preferred piece in the middle of a step.
#[derive(Clone, Copy)]
enum Middle {
    /// A kick, because it gives the smallest error. Without a kick, the most expensive piece, because the middle flow is applied once.
    Kick,
    /// A piece that reads positions and momenta. Drifts surround it, and kicks surround the drifts. This rule gives the four smallest errors among
    /// all orders of four shears.
    Mixed,
}

/// Sorts pieces into the order of half a step. Among pieces of equal rank, the cheapest is first.
fn ordered(graph: &mut Graph, mut pieces: Vec<Piece>, middle: Middle) -> Vec<Piece> {
    pieces.sort_by_cached_key(|piece| {
        let reads = graph.reads(piece.energy);
        let rank = match middle {
            Middle::Kick => usize::from(reads.q && reads.kinds() == 1),
            Middle::Mixed => reads.kinds() + usize::from(reads.p),
        };
        (rank, piece.cost(graph))
    });
    pieces
}

/// A criterion for the better of two partitions.
#[derive(Clone, Copy)]
enum Measure {
    /// Fewer pieces. For equal numbers, families earlier in the list.
    Fewest,
    /// A lower cost of the flows. For equal costs, fewer pieces, then families earlier in the list.
    Cheapest,
}

/// A partition of some atoms. A set of atoms is a number: bit i stands for atom i.
#[derive(Clone, Debug, Default)]
struct Choice {
    cost: usize,
    groups: Vec<usize>,
    /// The positions of the groups' families in the list, in ascending order.
    ranks: Vec<usize>,
}

impl Choice {
    fn with(&self, group: usize, rank: usize, cost: usize) -> Choice {
        let mut ranks = [&self.ranks[..], &[rank]].concat();
        ranks.sort_unstable();
        Choice { cost: self.cost + cost, groups: [&self.groups[..], &[group]].concat(), ranks }
    }

    fn is_better_than(&self, other: &Choice, measure: Measure) -> bool {
        let key = |choice: &Choice| match measure {
            Measure::Fewest => (0, choice.groups.len()),
            Measure::Cheapest => (choice.cost, choice.groups.len()),
        };
        (key(self), &self.ranks) < (key(other), &other.ranks)
    }
}

/// A search over all sets of atoms. Caches the piece of each set with its cost.
struct Search<'a> {
    atoms: &'a [Id],
    space: Space,
    known: BTreeMap<usize, Option<(Piece, usize)>>,
}

impl<'a> Search<'a> {
    fn new(atoms: &'a [Id], space: Space) -> Search<'a> {
        Search { atoms, space, known: BTreeMap::new() }
    }

    /// Returns the piece of a set of atoms with its cost, if a family knows its flow. With an action, costs are not compared and are zero.
    fn attempt(&mut self, graph: &mut Graph, set: usize) -> Option<(Piece, usize)> {
        let Search { atoms, space, known } = self;
        let found = known.entry(set).or_insert_with(|| {
            let terms: Vec<Id> = (0..atoms.len()).filter(|i| set >> i & 1 == 1).map(|i| atoms[i]).collect();
            let energy = graph.sum(&terms);
            let piece = piece(graph, energy, *space)?;
            let cost = if space.action { 0 } else { piece.cost(graph) };
            Some((piece, cost))
        });
        found.clone()
    }

    /// Returns the first atom that is not a piece by itself.
    fn first_without_flow(&mut self, graph: &mut Graph) -> Option<Id> {
        (0..self.atoms.len()).find(|i| self.attempt(graph, 1 << i).is_none()).map(|i| self.atoms[i])
    }

    /// Returns the best partition, or a term that belongs to no piece, by dynamic programming over all sets of atoms.
    fn best(&mut self, graph: &mut Graph, energy: Id, measure: Measure) -> Result<Vec<Piece>, Id> {
        // Without an action, a term without a flow of its own belongs to no family.
        if !self.space.action
            && let Some(term) = self.first_without_flow(graph)
        {
            return Err(term);
        }
        let whole = (1_usize << self.atoms.len()) - 1;
        // The best choice for every set of atoms.
        let mut best: Vec<Option<Choice>> = vec![Some(Choice::default())];
        for set in 1..=whole {
            // Exactly one group contains the lowest atom.
            let lowest = set & set.wrapping_neg();
            let mut choice: Option<Choice> = None;
            for others in subsets(set ^ lowest) {
                let group = others | lowest;
                let Some(rest) = &best[set ^ group] else { continue };
                if let Some((piece, cost)) = self.attempt(graph, group) {
                    let new = rest.with(group, rank(&piece), cost);
                    if choice.as_ref().is_none_or(|choice| new.is_better_than(choice, measure)) {
                        choice = Some(new);
                    }
                }
            }
            best.push(choice);
        }
        let Some(Choice { groups, .. }) = &best[whole] else {
            return Err(self.first_without_flow(graph).unwrap_or(energy));
        };
        Ok(groups.iter().filter_map(|group| self.attempt(graph, *group)).map(|(piece, _)| piece).collect())
    }
}

/// Returns all subsets of a set of bits. The full set comes first.
fn subsets(set: usize) -> impl Iterator<Item = usize> {
    std::iter::successors(Some(set), move |subset| (*subset != 0).then(|| (subset - 1) & set))
}

/// Returns the position of the piece's family in the list.
fn rank(piece: &Piece) -> usize {
    FAMILIES.iter().position(|family| family.name == piece.family.name).unwrap_or(FAMILIES.len())
}

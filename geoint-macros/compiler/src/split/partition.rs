//! Which terms go together.

use super::atoms::atoms;
use super::families::{FAMILIES, piece};
use super::flow::{Piece, Space};
use super::linear_motion::hidden_linear_motion;
use super::nystrom::{in_order_of_nystrom, is_nystrom};
use super::powers::powers_of_forms;
use crate::analyze::{Split, Structure};
use crate::ir::{Graph, Id};
use crate::lower::Place;
use crate::schedule::{Kernel, Routine};
use std::collections::BTreeMap;

/// A flow waits for the one before it: some sums long.
const WAIT: usize = 4;

/// The pieces; or a term that is in no piece.
pub(crate) type Pieces = Result<Partition, Id>;

/// H as a sum of pieces.
#[derive(Clone, Debug, Default)]
pub(crate) struct Partition {
    /// In the order in which a step goes through them and back.
    pub(crate) pieces: Vec<Piece>,
    /// What their flows cost a step, in units of one sum.
    pub(crate) cost: usize,
    /// Whether some flow is not defined for every length.
    ends_early: bool,
    /// Whether these are two, A and B, with {B, {B, {B, A}}} = 0.
    pub(crate) nystrom: bool,
    /// Whether it was taken because all linear motion is in A, and not for what it costs.
    pub(crate) linear: bool,
    /// What else was found.
    pub(crate) rejected: Vec<Rejected>,
}

/// Pieces that were found and not taken.
#[derive(Clone, Debug)]
pub(crate) struct Rejected {
    pub(crate) energies: Vec<Id>,
    pub(crate) cost: usize,
}

/// Splits H; into the groups that the user wants, if there are any.
///
/// With an action into the fewest pieces. Without one as a whole, where its flow is known; else into those whose flows never end, as shears,
/// rather than such as qᵏpⁿ have; then into those whose flows cost least, which need not be the fewest. Before all that comes linear motion as a
/// whole beside a rest, if both are an A and a B for tables of Runge–Kutta–Nyström type.
pub(crate) fn pieces(graph: &mut Graph, energy: Id, space: Space, groups: Option<&[(Id, Place)]>) -> Pieces {
    if let Some(groups) = groups {
        // In the order given: who groups by hand knows what is to be in the middle.
        let pieces: Result<Vec<Piece>, Id> =
            groups.iter().map(|(group, _)| piece(graph, *group, space).ok_or(*group)).collect();
        let mut given = Partition::of(graph, pieces?);
        // Who groups by hand says what is to be in the middle.
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
    // One piece has no error, and where its flow ends the motion does.
    found.sort_by_key(|partition| {
        let pieces = partition.pieces.len();
        (pieces > 1, partition.ends_early, partition.cost, pieces)
    });
    found.dedup_by_key(|partition| partition.energies());
    let around = if found[0].pieces.len() > 1 { around_linear_motion(graph, energy, space) } else { None };
    let mut best = around.unwrap_or_else(|| {
        let mut cheapest = found.remove(0);
        cheapest.nystrom = !space.action && in_order_of_nystrom(graph, &mut cheapest.pieces, space.degrees);
        cheapest
    });
    best.rejected = found.iter().map(|other| Rejected { energies: other.energies(), cost: other.cost }).collect();
    Ok(best)
}

/// All linear motion as one piece and the rest as another, where less of it would be one otherwise.
///
/// The error of pieces that share a motion of frequency ω is as large as (hω)ⁿ allows, however small the motion; around linear motion it is as
/// small as the rest, for a flow that costs hardly more. Measured: a charge in a field that grows takes 0.58 of the time that two shears take,
/// and oscillators of which nothing is small 1.4 at most.
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

/// The pieces of H(q, p, t) where kick and drift are none, or not the pieces that the user wants.
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
        let costs: Vec<usize> = pieces.iter().map(|piece| WAIT + cost(graph, piece)).collect();
        // Twice a step, but the last one; the first one is merged with that of the step before.
        let ends = [costs.first(), costs.last()].into_iter().flatten().sum::<usize>();
        let cost = if costs.len() > 1 { 2 * costs.iter().sum::<usize>() - ends } else { ends / 2 };
        let ends_early = pieces.iter().any(|piece| piece.flow.ends_early(graph));
        Partition { pieces, cost, ends_early, nystrom: false, linear: false, rejected: vec![] }
    }

    fn energies(&self) -> Vec<Id> {
        self.pieces.iter().map(|piece| piece.energy).collect()
    }
}

/// What is in the middle of a step.
#[derive(Clone, Copy)]
enum Middle {
    /// A kick: it leaves the smallest error. Else the most expensive piece, which is best gone through once.
    Kick,
    /// What reads positions and momenta, around it drifts, around these kicks: of all orders of four shears the best four are such.
    Mixed,
}

/// Pieces in the order of half a step.
fn ordered(graph: &mut Graph, found: Vec<Piece>, middle: Middle) -> Vec<Piece> {
    let mut pieces: Vec<((usize, usize), Piece)> = vec![];
    for piece in found {
        let reads = graph.reads(piece.energy);
        let rank = match middle {
            Middle::Kick => usize::from(reads.q && reads.kinds() == 1),
            Middle::Mixed => reads.kinds() + usize::from(reads.p),
        };
        pieces.push(((rank, cost(graph, &piece)), piece));
    }
    pieces.sort_by_key(|(rank, _)| *rank);
    pieces.into_iter().map(|(_, piece)| piece).collect()
}

/// Which of two partitions is better.
#[derive(Clone, Copy)]
enum Measure {
    /// That with fewer pieces; of equal numbers, that whose rules come first.
    Fewest,
    /// That whose flows cost less; of equal costs, that with fewer pieces.
    Cheapest,
}

/// A partition of some atoms, by sets of their numbers as bits.
#[derive(Clone, Debug, Default)]
struct Choice {
    cost: usize,
    groups: Vec<usize>,
    /// Of the rules behind the groups, in order.
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

/// All sets of atoms, with the pieces that they are and what these cost.
struct Search<'a> {
    atoms: &'a [Id],
    space: Space,
    known: BTreeMap<usize, Option<(Piece, usize)>>,
}

impl<'a> Search<'a> {
    fn new(atoms: &'a [Id], space: Space) -> Search<'a> {
        Search { atoms, space, known: BTreeMap::new() }
    }

    fn attempt(&mut self, graph: &mut Graph, set: usize) -> Option<(Piece, usize)> {
        let Search { atoms, space, known } = self;
        let found = known.entry(set).or_insert_with(|| {
            let terms: Vec<Id> = (0..atoms.len()).filter(|i| set >> i & 1 == 1).map(|i| atoms[i]).collect();
            let energy = graph.sum(&terms);
            let piece = piece(graph, energy, *space)?;
            let cost = if space.action { 0 } else { cost(graph, &piece) };
            Some((piece, cost))
        });
        found.clone()
    }

    /// The best partition; or a term that is in no piece.
    fn best(&mut self, graph: &mut Graph, energy: Id, measure: Measure) -> Result<Vec<Piece>, Id> {
        // Without an action no family needs a term that has no flow of its own.
        if !self.space.action
            && let Some(alone) = (0..self.atoms.len()).find(|i| self.attempt(graph, 1 << i).is_none())
        {
            return Err(self.atoms[alone]);
        }
        let whole = (1_usize << self.atoms.len()) - 1;
        // The best choice for every set of atoms.
        let mut best: Vec<Option<Choice>> = vec![Some(Choice::default())];
        for set in 1..=whole {
            // One piece has the lowest atom; that alone, or with others.
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
        match &best[whole] {
            Some(Choice { groups, .. }) => {
                Ok(groups.iter().filter_map(|group| self.attempt(graph, *group)).map(|(piece, _)| piece).collect())
            }
            None => {
                let alone = (0..self.atoms.len()).find(|i| self.attempt(graph, 1 << i).is_none());
                Err(alone.map_or(energy, |i| self.atoms[i]))
            }
        }
    }
}

/// All subsets of a set of bits, the set itself first.
fn subsets(set: usize) -> impl Iterator<Item = usize> {
    std::iter::successors(Some(set), move |subset| (*subset != 0).then(|| (subset - 1) & set))
}

fn rank(piece: &Piece) -> usize {
    FAMILIES.iter().position(|family| std::ptr::eq(family, piece.family)).unwrap_or(FAMILIES.len())
}

/// What a flow costs wherever it is applied, after what is computed once a step: its operations, and one for each coordinate that it
/// changes, so that two kicks are dearer than one.
fn cost(graph: &mut Graph, piece: &Piece) -> usize {
    let ends: Vec<Id> = piece.flow.changed(graph).into_iter().map(|(_, end)| end).collect();
    let count = ends.len();
    let mut kernel = Kernel::new(piece.levels(), vec![Routine::row("end", ends)]);
    kernel.schedule(graph);
    count + kernel.operations().weight()
}

//! Which terms go together.

use super::families::{FAMILIES, piece};
use super::flow::Piece;
use crate::analyze::{self, Reads};
use crate::ir::{Graph, Id, Node, Ratio};
use crate::lower::Place;
use crate::schedule::Kernel;
use std::collections::BTreeMap;

/// The pieces in the order in which a step goes through them and back, the most expensive one last; or a term that is in no
/// piece.
pub(crate) type Pieces = Result<Vec<Piece>, Id>;

/// With more terms than this those that read the same parts of phase space stay together: all subsets are looked at.
const MAX_ATOMS: usize = 7;

/// Splits H; into the groups that the user wants, if there are any.
pub(crate) fn pieces(graph: &mut Graph, energy: Id, degrees: u32, groups: Option<&[(Id, Place)]>) -> Pieces {
    if let Some(groups) = groups {
        // In the order given: who groups by hand knows what is to be in the middle.
        return groups.iter().map(|(group, _)| piece(graph, *group, degrees).ok_or(*group)).collect();
    }
    let found = fewest(graph, energy, degrees)?;
    // A kick in the middle leaves the smallest error; of other pieces the most expensive one is best looked at once.
    let mut pieces: Vec<((bool, usize), Piece)> = vec![];
    for piece in found {
        let reads = analyze::reads(graph, piece.energy);
        pieces.push(((reads.q && reads.kinds() == 1, cost(graph, &piece)), piece));
    }
    pieces.sort_by_key(|(rank, _)| *rank);
    Ok(pieces.into_iter().map(|(_, piece)| piece).collect())
}

/// A partition of some atoms, by sets of their numbers as bits.
#[derive(Clone, Debug, Default)]
struct Choice {
    groups: Vec<usize>,
    /// Of the rules behind the groups, in order.
    ranks: Vec<usize>,
}

impl Choice {
    fn with(&self, group: usize, rank: usize) -> Choice {
        let mut ranks = [&self.ranks[..], &[rank]].concat();
        ranks.sort_unstable();
        Choice { groups: [&self.groups[..], &[group]].concat(), ranks }
    }

    /// Fewer pieces, or rules that come first.
    fn is_better_than(&self, other: &Choice) -> bool {
        (self.groups.len(), &self.ranks) < (other.groups.len(), &other.ranks)
    }
}

/// The smallest number of pieces; of equal numbers, the one whose rules come first.
fn fewest(graph: &mut Graph, energy: Id, degrees: u32) -> Pieces {
    let atoms = atoms(graph, energy, degrees);
    let whole = (1_usize << atoms.len()) - 1;
    let mut known: BTreeMap<usize, Option<Piece>> = BTreeMap::new();
    let mut attempt = |graph: &mut Graph, set: usize| {
        let found = known.entry(set).or_insert_with(|| {
            let terms: Vec<Id> = (0..atoms.len()).filter(|i| set >> i & 1 == 1).map(|i| atoms[i]).collect();
            let energy = graph.sum(&terms);
            piece(graph, energy, degrees)
        });
        found.clone()
    };
    // The best choice for every set of atoms.
    let mut best: Vec<Option<Choice>> = vec![Some(Choice::default())];
    for set in 1..=whole {
        // One piece has the lowest atom; that alone, or with others.
        let lowest = set & set.wrapping_neg();
        let mut choice: Option<Choice> = None;
        for others in subsets(set ^ lowest) {
            let group = others | lowest;
            if let (Some(piece), Some(rest)) = (attempt(graph, group), &best[set ^ group]) {
                let new = rest.with(group, rank(&piece));
                if choice.as_ref().is_none_or(|choice| new.is_better_than(choice)) {
                    choice = Some(new);
                }
            }
        }
        best.push(choice);
    }
    match &best[whole] {
        Some(Choice { groups, .. }) => Ok(groups.iter().filter_map(|group| attempt(graph, *group)).collect()),
        None => {
            let alone = (0..atoms.len()).find(|i| attempt(graph, 1 << i).is_none());
            Err(alone.map_or(energy, |i| atoms[i]))
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

/// The terms of H. Those that read positions alone, momenta alone or the action alone are never parted.
fn atoms(graph: &mut Graph, energy: Id, degrees: u32) -> Vec<Id> {
    let mut open = analyze::terms(graph, energy);
    open.reverse();
    // What each class reads, and its terms.
    let mut classes: Vec<(Reads, Vec<Id>)> = vec![];
    while let Some(term) = open.pop() {
        let reads = Reads { t: false, ..analyze::reads(graph, term) };
        if reads.kinds() > 1
            && piece(graph, term, degrees).is_none()
            && let Some(parts) = distributed(graph, term)
        {
            open.extend(parts);
            continue;
        }
        let class = match classes.iter().position(|(other, _)| *other == reads) {
            Some(class) => class,
            None => {
                classes.push((reads, vec![]));
                classes.len() - 1
            }
        };
        // What powers of sums were taken apart into meets again.
        let (_, terms) = &mut classes[class];
        match terms.iter_mut().find(|other| graph.coefficient(**other).1 == graph.coefficient(term).1) {
            Some(other) => *other = graph.add(*other, term),
            None => terms.push(term),
        }
    }
    let apart: usize = classes.iter().map(|(reads, terms)| if reads.kinds() > 1 { terms.len() } else { 1 }).sum();
    let mut atoms = vec![];
    for (reads, terms) in classes {
        if reads.kinds() > 1 && apart <= MAX_ATOMS {
            atoms.extend(terms);
        } else {
            let together = graph.sum(&terms);
            // What reads one kind alone stays together, unless no rule knows the sum.
            if apart <= MAX_ATOMS && piece(graph, together, degrees).is_none() {
                atoms.extend(terms);
            } else {
                atoms.push(together);
            }
        }
    }
    atoms
}

/// A product with a sum that couples, or a power of one, as a sum of products.
fn distributed(graph: &mut Graph, term: Id) -> Option<Vec<Id>> {
    let (c, rest) = graph.coefficient(term);
    let factors = graph.factors(rest);
    let is_coupling_sum = |(base, exponent): &(Id, Ratio)| {
        exponent.is_integer()
            && (1..=MAX_POWER).contains(&exponent.numerator)
            && matches!(graph.node(*base), Node::Linear(..))
            && analyze::reads(graph, *base).kinds() > 1
    };
    let sum = factors.iter().position(is_coupling_sum)?;
    let mut others = graph.number(c);
    for (base, exponent) in factors.iter().enumerate().filter(|(i, _)| *i != sum).map(|(_, factor)| *factor) {
        let factor = graph.pow(base, exponent);
        others = graph.mul(others, factor);
    }
    let (base, exponent) = factors[sum];
    let terms = analyze::terms(graph, base);
    let mut products = vec![others];
    for _ in 0..exponent.numerator {
        let pairs = products.iter().flat_map(|product| terms.iter().map(move |term| (*product, *term)));
        products = pairs.collect::<Vec<_>>().into_iter().map(|(product, term)| graph.mul(product, term)).collect();
    }
    Some(products)
}

/// Sums that couple are taken apart up to this power.
const MAX_POWER: i128 = 4;

/// What a flow costs wherever it is applied, after what is computed once a step.
fn cost(graph: &mut Graph, piece: &Piece) -> usize {
    let ends = piece.flow.changed(graph).into_iter().map(|(_, end)| end).collect();
    Kernel::new(piece.levels(), ends).plan(graph).operations().weight()
}

//! Which sums are computed side by side?
//!
//! A sum over coefficients of lower orders waits for none of its own order. So all sums of one kind may stand side by side, whatever
//! depends on whatever: in arrays of four coefficients an order, which the optimiser makes vectors of.

use super::{Factor, Jet, Rule, Source};
use crate::ir::HashMap;
use std::collections::HashSet;

/// Sums side by side.
pub(crate) const LANES: usize = 4;

/// With fewer sums there is less to gain than it costs to bring coefficients together.
const FEWEST: usize = 8;

/// Coefficients uⱼ, or j·uⱼ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Operand {
    pub(crate) source: Source,
    pub(crate) weighted: bool,
}

impl Operand {
    fn plain(source: Source) -> Operand {
        Operand { source, weighted: false }
    }

    fn weighted(source: Source) -> Operand {
        Operand { source, weighted: true }
    }
}

/// What is multiplied with uⱼwₙ₋ⱼ in a sum over 0 < j < n.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Weight {
    One,
    /// 1, where both are the same: terms j and n − j are equal.
    Square,
    /// j(α + 1) − n.
    Power(Factor),
}

/// A sum over 0 < j < n.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Sum {
    pub(crate) operands: [Operand; 2],
    pub(crate) weight: Weight,
}

impl Sum {
    fn new(u: Operand, w: Operand) -> Sum {
        Sum { operands: [u, w], weight: if u == w { Weight::Square } else { Weight::One } }
    }
}

/// The sums in the coefficient of a series.
pub(crate) fn sums(rule: &Rule, own: Source) -> Vec<Sum> {
    let [plain, weighted] = [Operand::plain, Operand::weighted];
    match *rule {
        Rule::State(_)
        | Rule::Affine(_)
        | Rule::Linear(_)
        | Rule::Shift { .. }
        | Rule::Wave { .. }
        | Rule::Select(..) => vec![],
        Rule::Product(a, b) => vec![Sum::new(plain(a), plain(b))],
        Rule::Square(a) => vec![Sum::new(plain(a), plain(a))],
        Rule::Quotient(_, w) | Rule::Reciprocal(w) => vec![Sum::new(plain(w), plain(own))],
        Rule::Root(_) => vec![Sum::new(plain(own), plain(own))],
        Rule::Power(u, exponent) => {
            vec![Sum { operands: [plain(u), plain(own)], weight: Weight::Power(exponent) }]
        }
        Rule::Integral { by, of, .. } => vec![Sum::new(weighted(of), plain(by))],
        Rule::Quadrature { over, .. } => vec![Sum::new(weighted(own), plain(over))],
        Rule::Angle { y, x, square } => vec![
            Sum::new(weighted(y), plain(x)),
            Sum::new(weighted(x), plain(y)),
            Sum::new(weighted(own), plain(square)),
        ],
    }
}

/// Sums of one kind side by side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Group {
    /// The places of both operands among the arrays.
    pub(crate) operands: [usize; 2],
    pub(crate) weight: Weight,
}

/// All sums of a program in groups.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lanes {
    pub(crate) arrays: Vec<[Operand; LANES]>,
    pub(crate) groups: Vec<Group>,
    /// Sums that would be alone in a group.
    alone: Vec<Sum>,
    known: HashMap<[Operand; LANES], usize>,
    /// Of every sum the group and the place in it.
    places: HashMap<Sum, (usize, usize)>,
}

impl Lanes {
    /// The groups, if there are enough sums.
    pub(crate) fn of(jet: &Jet) -> Option<Lanes> {
        let mut kinds: Vec<(Weight, Vec<Sum>)> = vec![(Weight::One, vec![])];
        let mut known: HashSet<Sum> = HashSet::new();
        // In the order in which they are read: then those of a group are read, and their operands known, at nearly the same time.
        for own in jet.order.iter().copied() {
            for sum in sums(&jet.series[own].rule, own).into_iter().filter(|sum| known.insert(*sum)) {
                match kinds.iter_mut().find(|(weight, _)| *weight == sum.weight) {
                    Some((_, kind)) => kind.push(sum),
                    None => kinds.push((sum.weight, vec![sum])),
                }
            }
        }
        if known.len() < FEWEST {
            return None;
        }
        let mut lanes = Lanes::default();
        let mut common = std::mem::take(&mut kinds[0].1);
        for (weight, kind) in kinds {
            let (whole, rest) = kind.split_at(kind.len() - kind.len() % LANES);
            whole.chunks(LANES).for_each(|group| lanes.push(weight, group));
            let free = common.len().next_multiple_of(LANES) - common.len();
            match (weight, rest.len()) {
                // Few squares fill lanes of others.
                (Weight::Square, 1) if free > 0 => common.extend(rest),
                (Weight::Square, 2..LANES) if rest.len() < LANES - 1 => common.extend(rest),
                (_, 0) => {}
                _ => lanes.push(weight, rest),
            }
        }
        common.chunks(LANES).for_each(|group| lanes.push(Weight::One, group));
        Some(lanes)
    }

    fn push(&mut self, weight: Weight, sums: &[Sum]) {
        if let [sum] = sums {
            self.alone.push(*sum);
            return;
        }
        let place = self.groups.len();
        self.places.extend(sums.iter().enumerate().map(|(lane, sum)| (*sum, (place, lane))));
        // Lanes that nothing needs repeat the last.
        let lane = |lane: usize| sums[lane.min(sums.len() - 1)];
        let operands = [0, 1].map(|k| self.array(std::array::from_fn(|i| lane(i).operands[k])));
        self.groups.push(Group { operands, weight });
    }

    fn array(&mut self, operands: [Operand; LANES]) -> usize {
        let next = self.arrays.len();
        *self.known.entry(operands).or_insert_with(|| {
            self.arrays.push(operands);
            next
        })
    }

    /// Whether an operand is read in a sum that is alone.
    pub(crate) fn is_read_alone(&self, operand: Operand) -> bool {
        self.alone.iter().any(|sum| sum.operands.contains(&operand))
    }

    /// The group of a sum, and the place in it.
    pub(crate) fn place(&self, sum: Sum) -> Option<(usize, usize)> {
        self.places.get(&sum).copied()
    }
}

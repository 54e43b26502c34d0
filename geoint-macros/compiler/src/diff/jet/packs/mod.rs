//! Packs: up to four sums over coefficients that are computed side by side.
//!
//! A sum over coefficients of lower orders waits for no coefficient of its own order. All sums of one kind may therefore be packed, in arrays of four
//! coefficients for every order. The optimiser turns operations on such arrays into vector instructions.

mod central;
mod sums;

pub(crate) use central::Central;
pub(crate) use sums::{Operand, Sum, Weight, sums};

use super::{Jet, Source};
use crate::ir::HashMap;
use std::collections::{HashSet, VecDeque};

/// Sums in a pack.
pub(crate) const LANES: usize = 4;

/// With fewer sums, packing coefficients costs more than it gains. Three or four packed sums take a fifth longer (a free body, Kepler).
const FEWEST: usize = 7;

/// A group: a pack of sums of one kind.
#[derive(Clone, Debug)]
pub(crate) struct Group {
    /// The operands as indices into `Packs::arrays`.
    pub(crate) operands: Vec<usize>,
    pub(crate) weight: Weight,
    /// The series whose coefficients follow from these sums. Present if all follow by the same operations at the same time, and so stay packed.
    pub(crate) series: Option<[Source; LANES]>,
}

/// All sums of a program in packs.
#[derive(Clone, Debug, Default)]
pub(crate) struct Packs {
    /// Operands that are read side by side.
    pub(crate) arrays: Vec<[Operand; LANES]>,
    pub(crate) groups: Vec<Group>,
    pub(crate) central: Vec<Central>,
    /// Sums without a group.
    alone: Vec<Sum>,
    /// The index of every array.
    known: HashMap<[Operand; LANES], usize>,
    /// The group and the lane of every sum.
    places: HashMap<Sum, (usize, usize)>,
    /// The group from which each packed series follows.
    groups_of: HashMap<Source, usize>,
    /// The index in `central` of every group in it.
    central_of: HashMap<usize, usize>,
    /// The arrays that groups in `central` read.
    held: HashSet<usize>,
}

impl Packs {
    /// Packs the sums of a program, if there are enough.
    pub(crate) fn of(jet: &Jet) -> Option<Packs> {
        let mut known: HashSet<Sum> = HashSet::new();
        // In the order of evaluation, so that the operands of a group become known at nearly the same time.
        let all = jet.order.iter().flat_map(|own| sums(&jet.series[*own].rule, *own));
        let all: Vec<Sum> = all.filter(|sum| known.insert(sum.clone())).collect();
        if all.len() < FEWEST {
            return None;
        }
        let mut packs = Packs::default();
        packs.pack_powers(&all);
        let (mut common, mut kinds): (Vec<Sum>, Vec<Vec<Sum>>) = (vec![], vec![]);
        for sum in all.into_iter().filter(|sum| !packs.places.contains_key(sum)) {
            match kinds.iter_mut().find(|kind| kind[0].is_like(&sum)) {
                _ if sum.weight == Weight::One => common.push(sum),
                Some(kind) => kind.push(sum),
                None => kinds.push(vec![sum]),
            }
        }
        let mut alone: Vec<Sum> = vec![];
        for kind in kinds {
            let (weight, single) = (kind[0].weight, kind[0].operands.len() == 1);
            let (whole, rest) = kind.split_at(kind.len() - kind.len() % LANES);
            whole.chunks(LANES).for_each(|group| packs.push(weight, group));
            let free = common.len().next_multiple_of(LANES) - common.len();
            match rest.len() {
                0 => {}
                // Too few powers for a group, and too few squares, fill free lanes of other groups.
                1 | 2 if matches!(weight, Weight::Power(_)) => {
                    for part in rest.iter().flat_map(Sum::parts) {
                        if !common.contains(&part) {
                            common.push(part);
                        }
                    }
                }
                1 if !single => alone.push(rest[0].clone()),
                1 if single && free > 0 => common.extend_from_slice(rest),
                2..LANES if single && rest.len() < LANES - 1 => common.extend_from_slice(rest),
                _ => packs.push(weight, rest),
            }
        }
        for sum in alone {
            let parts = sum.parts();
            if parts.len() <= common.len().next_multiple_of(LANES) - common.len() {
                common.extend(parts);
            } else {
                packs.push(sum.weight, &[sum]);
            }
        }
        common.chunks(LANES).for_each(|group| packs.push(Weight::One, group));
        packs.find_series(jet);
        packs.find_central();
        Some(packs)
    }

    /// Finds the series that follow from every group.
    fn find_series(&mut self, jet: &Jet) {
        let mut depths = vec![0; jet.series.len()];
        let mut reading: Vec<Vec<(usize, Source)>> = vec![vec![]; self.groups.len()];
        for own in &jet.order {
            let rule = &jet.series[*own].rule;
            depths[*own] = rule.now().into_iter().map(|read| depths[read] + 1).max().unwrap_or(0);
            for sum in sums(rule, *own) {
                if let Some((group, lane)) = self.place(&sum) {
                    reading[group].push((lane, *own));
                }
            }
        }
        // The parts of a sum also fill lanes, but no series reads them alone. Such groups have fewer readers than lanes.
        let mut filled = vec![0; self.groups.len()];
        self.places.values().for_each(|(group, _)| filled[*group] += 1);
        for (place, (group, mut reading)) in self.groups.iter_mut().zip(reading).enumerate() {
            reading.sort_unstable();
            let rule = |(_, source): (usize, Source)| &jet.series[source].rule;
            let alike = |(lane, read): (usize, &(usize, Source))| {
                // Series of one depth do not wait for each other.
                read.0 == lane && rule(*read).is_like(rule(reading[0])) && depths[read.1] == depths[reading[0].1]
            };
            if reading.len() + 1 >= LANES && reading.len() == filled[place] && reading.iter().enumerate().all(alike) {
                group.series = Some(std::array::from_fn(|lane| reading[lane.min(reading.len() - 1)].1));
                self.groups_of.extend(reading.iter().map(|(_, source)| (*source, place)));
            }
        }
    }

    /// Packs powers first, for example powers of the distances of bodies. Then packs the products with these powers in the same lanes, and the squares of
    /// their factors. An array of operands thus serves all sums that read it, and the results of sums stay in their lanes.
    fn pack_powers(&mut self, all: &[Sum]) {
        let mut reading: HashMap<Operand, Vec<Sum>> = HashMap::default();
        for sum in all {
            for operand in &sum.operands {
                reading.entry(*operand).or_default().push(sum.clone());
            }
        }
        let powers: Vec<Sum> = all.iter().filter(|sum| matches!(sum.weight, Weight::Power(_))).cloned().collect();
        let mut open: VecDeque<Vec<Operand>> = VecDeque::new();
        let alike = powers.chunk_by(|a, b| a.weight == b.weight).flat_map(|alike| alike.chunks(LANES));
        for group in alike.filter(|group| group.len() + 1 >= LANES) {
            self.push(group[0].weight, group);
            open.push_back(group.iter().map(|sum| sum.operands[1]).collect());
        }
        while let Some(operands) = open.pop_front() {
            for weight in [Weight::One, Weight::Square] {
                while let Some(sums) = self.next_of_each(weight, &operands, &reading) {
                    if weight == Weight::Square {
                        self.push(weight, &sums);
                        continue;
                    }
                    let others: Vec<Operand> =
                        sums.iter().zip(&operands).map(|(sum, operand)| sum.other(*operand)).collect();
                    self.group(weight, &sums, &[others.clone(), operands.clone()]);
                    open.push_back(others);
                }
            }
        }
    }

    /// For each operand, one sum that reads it and is in no group. Returns `None` if an operand has none.
    fn next_of_each(
        &self,
        weight: Weight,
        operands: &[Operand],
        reading: &HashMap<Operand, Vec<Sum>>,
    ) -> Option<Vec<Sum>> {
        let mut found: Vec<Sum> = vec![];
        for operand in operands {
            let free = |sum: &&Sum| sum.weight == weight && !self.places.contains_key(*sum) && !found.contains(sum);
            found.push(reading.get(operand)?.iter().find(free)?.clone());
        }
        found.iter().all(|sum| sum.is_like(&found[0])).then_some(found)
    }

    /// Adds a group, or notes a single sum.
    fn push(&mut self, weight: Weight, sums: &[Sum]) {
        if let [sum] = sums {
            self.alone.push(sum.clone());
            return;
        }
        let number = if weight == Weight::Square { sums[0].operands.len() } else { 2 };
        let operands: Vec<Vec<_>> = (0..number).map(|k| sums.iter().map(|sum| sum.factor(k)).collect()).collect();
        self.group(weight, sums, &operands);
    }

    /// Adds a group of sums with the given factors.
    fn group(&mut self, weight: Weight, sums: &[Sum], operands: &[Vec<Operand>]) {
        let place = self.groups.len();
        self.places.extend(sums.iter().enumerate().map(|(lane, sum)| (sum.clone(), (place, lane))));
        // Free lanes repeat the last operand.
        let last = sums.len() - 1;
        let operands =
            operands.iter().map(|operands| self.array(std::array::from_fn(|lane| operands[lane.min(last)]))).collect();
        self.groups.push(Group { operands, weight, series: None });
    }

    /// The group from which a packed series follows, and all series of that group.
    pub(crate) fn group_of(&self, source: Source) -> Option<(usize, [Source; LANES])> {
        let group = *self.groups_of.get(&source)?;
        Some((group, self.groups[group].series?))
    }

    /// The array of the coefficients of the given series.
    pub(crate) fn array_of(&self, series: &[Source; LANES]) -> Option<usize> {
        self.known.get(&series.map(Operand::plain)).copied().filter(|array| !self.is_central(*array))
    }

    /// The index of an array, which is added if it is new.
    fn array(&mut self, operands: [Operand; LANES]) -> usize {
        let next = self.arrays.len();
        *self.known.entry(operands).or_insert_with(|| {
            self.arrays.push(operands);
            next
        })
    }

    /// Returns whether a sum without a group reads an operand.
    pub(crate) fn is_read_alone(&self, operand: Operand) -> bool {
        self.alone.iter().any(|sum| sum.operands.contains(&operand))
    }

    /// The group and the lane of a sum.
    pub(crate) fn place(&self, sum: &Sum) -> Option<(usize, usize)> {
        self.places.get(sum).copied()
    }
}

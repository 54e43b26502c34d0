//! Which sums are computed side by side?
//!
//! A sum over coefficients of lower orders waits for none of its own order. So all sums of one kind may stand side by side, whatever
//! depends on whatever: in arrays of four coefficients an order, which the optimiser makes vectors of.

mod central;

pub(crate) use central::Central;

use super::{Factor, Jet, Rule, Source};
use crate::ir::HashMap;
use std::collections::{HashSet, VecDeque};

/// Sums side by side.
pub(crate) const LANES: usize = 4;

/// With fewer sums there is less to gain than it costs to bring coefficients together: three or four of them take a fifth longer (a free body, Kepler).
const FEWEST: usize = 7;

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
    /// 1, where both are the same: terms j and n − j are equal. Of several operands the squares are added.
    Square,
    /// j(α + 1) − n.
    Power(Factor),
}

/// A sum over 0 < j < n.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Sum {
    /// Both factors, or all that are squared.
    pub(crate) operands: Vec<Operand>,
    pub(crate) weight: Weight,
}

impl Sum {
    fn new(u: Operand, w: Operand) -> Sum {
        if u == w { Sum::of_squares(vec![u]) } else { Sum { operands: vec![u, w], weight: Weight::One } }
    }

    fn of_squares(operands: Vec<Operand>) -> Sum {
        Sum { operands, weight: Weight::Square }
    }

    /// What an operand is multiplied with.
    fn other(&self, operand: Operand) -> Operand {
        self.operands[usize::from(self.operands[0] == operand)]
    }

    /// One of the factors of a product, which a square is too.
    fn factor(&self, k: usize) -> Operand {
        self.operands[k.min(self.operands.len() - 1)]
    }

    /// Sums of one kind from which this one follows: each square, or those of j·uⱼyₙ₋ⱼ and uⱼyₙ₋ⱼ where it has j(α + 1) − n.
    pub(crate) fn parts(&self) -> Vec<Sum> {
        match (self.weight, &self.operands[..]) {
            (Weight::Square, all) => all.iter().map(|operand| Sum::of_squares(vec![*operand])).collect(),
            (Weight::Power(_), [u, y]) => vec![Sum::new(Operand::weighted(u.source), *y), Sum::new(*u, *y)],
            _ => vec![self.clone()],
        }
    }

    /// Whether sums of both kinds are computed by the same operations.
    fn is_like(&self, other: &Sum) -> bool {
        self.weight == other.weight && self.operands.len() == other.operands.len()
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
        Rule::Squares(ref all) => vec![Sum::of_squares(all.iter().copied().map(plain).collect())],
        Rule::Quotient(_, w) | Rule::Reciprocal(w) => vec![Sum::new(plain(w), plain(own))],
        Rule::Root(_) => vec![Sum::new(plain(own), plain(own))],
        Rule::Power(u, exponent) => {
            vec![Sum { operands: vec![plain(u), plain(own)], weight: Weight::Power(exponent) }]
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
#[derive(Clone, Debug)]
pub(crate) struct Group {
    /// The places of the operands among the arrays.
    pub(crate) operands: Vec<usize>,
    pub(crate) weight: Weight,
    /// The series whose coefficients have these sums, if all follow from them by the same operations and are known at the same time: then they
    /// stay side by side.
    pub(crate) series: Option<[Source; LANES]>,
}

/// All sums of a program in groups.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lanes {
    pub(crate) arrays: Vec<[Operand; LANES]>,
    pub(crate) groups: Vec<Group>,
    pub(crate) central: Vec<Central>,
    /// Sums that would be alone in a group.
    alone: Vec<Sum>,
    known: HashMap<[Operand; LANES], usize>,
    /// Of every sum the group and the place in it.
    places: HashMap<Sum, (usize, usize)>,
    /// Of every series the group from which it follows side by side with others.
    groups_of: HashMap<Source, usize>,
    /// The groups that are computed with others as one, by the place of these.
    central_of: HashMap<usize, usize>,
    /// Arrays in the hands of such groups.
    held: HashSet<usize>,
}

impl Lanes {
    /// The groups, if there are enough sums.
    pub(crate) fn of(jet: &Jet) -> Option<Lanes> {
        let mut known: HashSet<Sum> = HashSet::new();
        // In the order in which they are read: then those of a group are read, and their operands known, at nearly the same time.
        let all = jet.order.iter().flat_map(|own| sums(&jet.series[*own].rule, *own));
        let all: Vec<Sum> = all.filter(|sum| known.insert(sum.clone())).collect();
        if all.len() < FEWEST {
            return None;
        }
        let mut lanes = Lanes::default();
        lanes.along_powers(&all);
        let (mut common, mut kinds): (Vec<Sum>, Vec<Vec<Sum>>) = (vec![], vec![]);
        for sum in all.into_iter().filter(|sum| !lanes.places.contains_key(sum)) {
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
            whole.chunks(LANES).for_each(|group| lanes.push(weight, group));
            let free = common.len().next_multiple_of(LANES) - common.len();
            match rest.len() {
                0 => {}
                // Few powers fill lanes of others, in parts; few squares do as well.
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
                _ => lanes.push(weight, rest),
            }
        }
        for sum in alone {
            let parts = sum.parts();
            if parts.len() <= common.len().next_multiple_of(LANES) - common.len() {
                common.extend(parts);
            } else {
                lanes.push(sum.weight, &[sum]);
            }
        }
        common.chunks(LANES).for_each(|group| lanes.push(Weight::One, group));
        lanes.find_series(jet);
        lanes.find_central();
        Some(lanes)
    }

    /// Of every group the series that follow from it.
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
        // Parts of sums are read by none as a whole.
        let mut filled = vec![0; self.groups.len()];
        self.places.values().for_each(|(group, _)| filled[*group] += 1);
        for (place, (group, mut reading)) in self.groups.iter_mut().zip(reading).enumerate() {
            reading.sort_unstable();
            let rule = |(_, source): (usize, Source)| &jet.series[source].rule;
            let alike = |(lane, read): (usize, &(usize, Source))| {
                // Series of one depth do not wait for each other, whatever else stands side by side.
                read.0 == lane && rule(*read).is_like(rule(reading[0])) && depths[read.1] == depths[reading[0].1]
            };
            if reading.len() + 1 >= LANES && reading.len() == filled[place] && reading.iter().enumerate().all(alike) {
                group.series = Some(std::array::from_fn(|lane| reading[lane.min(reading.len() - 1)].1));
                self.groups_of.extend(reading.iter().map(|(_, source)| (*source, place)));
            }
        }
    }

    /// Powers side by side, as those of the distances of bodies; then all that they are multiplied with, in the same lanes, and squares of that. So an
    /// array of operands serves all sums in which they are, and what follows from sums stays in its lane.
    fn along_powers(&mut self, all: &[Sum]) {
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

    /// A sum with each of the operands that is in no group.
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

    fn push(&mut self, weight: Weight, sums: &[Sum]) {
        if let [sum] = sums {
            self.alone.push(sum.clone());
            return;
        }
        let number = if weight == Weight::Square { sums[0].operands.len() } else { 2 };
        let operands: Vec<Vec<_>> = (0..number).map(|k| sums.iter().map(|sum| sum.factor(k)).collect()).collect();
        self.group(weight, sums, &operands);
    }

    /// A group of sums with these operands.
    fn group(&mut self, weight: Weight, sums: &[Sum], operands: &[Vec<Operand>]) {
        let place = self.groups.len();
        self.places.extend(sums.iter().enumerate().map(|(lane, sum)| (sum.clone(), (place, lane))));
        // Lanes that nothing needs repeat the last.
        let last = sums.len() - 1;
        let operands =
            operands.iter().map(|operands| self.array(std::array::from_fn(|lane| operands[lane.min(last)]))).collect();
        self.groups.push(Group { operands, weight, series: None });
    }

    /// The group from which a series follows side by side with others, and all of these.
    pub(crate) fn group_of(&self, source: Source) -> Option<(usize, [Source; LANES])> {
        let group = *self.groups_of.get(&source)?;
        Some((group, self.groups[group].series?))
    }

    /// The array of the coefficients of these series.
    pub(crate) fn array_of(&self, series: &[Source; LANES]) -> Option<usize> {
        self.known.get(&series.map(Operand::plain)).copied().filter(|array| !self.is_central(*array))
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
    pub(crate) fn place(&self, sum: &Sum) -> Option<(usize, usize)> {
        self.places.get(sum).copied()
    }
}

//! Finds the groups of sums that form central forces between bodies.

use super::{Group, LANES, Operand, Packs, Source, Weight};

/// Groups of a central force, which one function of the runtime computes: squares, a power of their sum, and the products of this power with every
/// squared factor. No other group reads their arrays.
#[derive(Clone, Debug)]
pub(crate) struct Central {
    /// The arrays of the squared factors.
    pub(crate) factors: Vec<usize>,
    /// The group of the product of each factor.
    pub(crate) products: Vec<usize>,
    pub(crate) squares: usize,
    pub(crate) power: usize,
}

impl Central {
    /// All groups of the force.
    pub(crate) fn groups(&self) -> Vec<usize> {
        self.products.iter().copied().chain([self.squares, self.power]).collect()
    }
}

impl Packs {
    /// Finds all central forces.
    pub(super) fn find_central(&mut self) {
        for power in 0..self.groups.len() {
            if let Some(central) = self.central(power) {
                let all = central.groups();
                self.held.extend(all.iter().flat_map(|group| &self.groups[*group].operands));
                self.central_of.extend(all.into_iter().map(|group| (group, self.central.len())));
                self.central.push(central);
            }
        }
    }

    /// The central force with a given group of powers, if there is one.
    fn central(&self, power: usize) -> Option<Central> {
        let (Weight::Power(_), [base, own]) = (self.groups[power].weight, &self.groups[power].operands[..]) else {
            return None;
        };
        self.groups[power].series?;
        let is_base = |series: [Source; LANES]| self.arrays[*base] == series.map(Operand::plain);
        let place = |fits: &dyn Fn(&Group) -> bool| self.groups.iter().position(fits);
        let squares = place(&|group| group.weight == Weight::Square && group.series.is_some_and(is_base))?;
        let factors = self.groups[squares].operands.clone();
        let product = |factor: &usize| {
            place(&|group| group.weight == Weight::One && group.series.is_some() && group.operands == [*factor, *own])
        };
        let products = factors.iter().map(product).collect::<Option<Vec<usize>>>()?;
        let arrays: Vec<usize> = factors.iter().copied().chain([*base, *own]).collect();
        let central = Central { factors, products, squares, power };
        let all = central.groups();
        let mut others = (0..self.groups.len()).filter(|place| !all.contains(place));
        let is_read = |place: usize| self.groups[place].operands.iter().any(|array| arrays.contains(array));
        (!others.any(is_read)).then_some(central)
    }

    /// The index in `central` of the force that contains a group.
    pub(crate) fn central_of(&self, group: usize) -> Option<usize> {
        self.central_of.get(&group).copied()
    }

    /// Returns whether the groups of a central force read an array.
    pub(crate) fn is_central(&self, array: usize) -> bool {
        self.held.contains(&array)
    }
}

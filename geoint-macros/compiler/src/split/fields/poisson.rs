//! Fields x' = S(x) ∇H by the terms of H.
//!
//! If a term reads only coordinates in involution, S_ij = 0 for all i and j among them, its flow keeps these coordinates. The other
//! coordinates then mostly obey single equations or a linear field. R. I. McLachlan, Phys. Rev. Lett. 71 (1993) 3043.

use super::super::products::multiplied_out;
use super::linear::is_zero;
use super::solve::{Ends, SUMS, solve};
use super::{Motion, NoPart, Part, clock, read};
use crate::analyze;
use crate::diff;
use crate::diff::equations::times;
use crate::ir::{Graph, Id, Symbol};
use std::cmp::Reverse;
use std::collections::BTreeSet;

/// Terms that flow together.
struct Group {
    energy: Id,
    /// The coordinates that the terms read.
    reads: BTreeSet<u32>,
    /// Whether these coordinates are in involution.
    involutive: bool,
    ends: Ends,
}

impl Group {
    /// Returns the position in a step. Groups with more constant coordinates come first. Groups that move coordinates that they read come last.
    fn rank(&self) -> (bool, Reverse<usize>) {
        (!self.involutive, Reverse(if self.involutive { self.reads.len() } else { 0 }))
    }
}

/// Whether two groups are neighbours in the order of a step.
#[derive(Clone, Copy, PartialEq)]
enum Distance {
    Adjacent,
    Apart,
}

/// Returns the parts in the order of half a step.
pub(crate) fn parts(graph: &mut Graph, energy: Id, structure: &[Vec<Id>]) -> Result<Vec<Part>, NoPart> {
    let mut system = System { structure, involution: vec![vec![None; structure.len()]; structure.len()] };
    let terms = analyze::terms(graph, energy);
    let mut open = system.with_scalar_products(graph, terms);
    open.reverse();
    let mut groups: Vec<Group> = vec![];
    while let Some(term) = open.pop() {
        if read(graph, term).is_empty() {
            continue;
        }
        if let Some(group) = system.group(graph, term) {
            groups.push(group);
        } else if let Some(products) = multiplied_out(graph, term, |graph, sum| graph.reads(sum).state()) {
            open.extend(products.into_iter().rev());
        } else {
            return Err(NoPart { formula: term, pair: system.not_in_involution(graph, &read(graph, term)) });
        }
    }
    groups.sort_by(|a, b| a.rank().cmp(&b.rank()).then_with(|| a.reads.cmp(&b.reads)));
    let mut merged: Vec<Group> = vec![];
    for group in groups {
        let together = (0..merged.len()).find_map(|i| {
            let distance = if i + 1 == merged.len() { Distance::Adjacent } else { Distance::Apart };
            Some((i, system.together(graph, &merged[i], &group, distance)?))
        });
        match together {
            Some((i, together)) => merged[i] = together,
            None => merged.push(group),
        }
    }
    merged.sort_by_key(Group::rank);
    let part = |graph: &mut Graph, Group { energy, ends: Ends { ends, rules }, .. }: Group| {
        let rates = system.rates(graph, energy);
        Part { formula: energy, rules, clock: clock(graph, &rates), motion: Motion::Closed(ends) }
    };
    Ok(merged.into_iter().map(|group| part(graph, group)).collect())
}

/// A term c·xᵢxⱼ of two coordinates in involution.
struct Product {
    term: Id,
    pair: [u32; 2],
    /// c.
    strength: Id,
}

/// Three products with a flow together.
struct ScalarProduct {
    energy: Id,
    /// The terms of the second and third product.
    others: [Id; 2],
}

/// The matrix S.
struct System<'a> {
    structure: &'a [Vec<Id>],
    /// Whether pairs of coordinates are in involution. Filled on demand.
    involution: Vec<Vec<Option<bool>>>,
}

impl System<'_> {
    /// Returns the nonzero entries of S ∇H.
    fn rates(&self, graph: &mut Graph, energy: Id) -> Vec<(Symbol, Id)> {
        let slopes = diff::gradient(graph, energy, self.structure.len() as u32).q;
        let field = times(graph, self.structure, &slopes);
        let rates = (0..).map(Symbol::Position).zip(field);
        rates.filter(|(_, rate)| !graph.is_zero(*rate)).collect()
    }

    /// Returns an energy as a group, if its flow has a closed form.
    fn group(&mut self, graph: &mut Graph, energy: Id) -> Option<Group> {
        let rates = self.rates(graph, energy);
        let clock = clock(graph, &rates);
        let ends = solve(graph, &rates, clock)?;
        let reads = read(graph, energy);
        let involutive = self.not_in_involution(graph, &reads).is_none();
        Some(Group { energy, reads, involutive, ends })
    }

    /// Joins three products x₁y₁, x₂y₂ and x₃y₃ if the flow of their sum is known. The sum rotates both vectors about x + y. One product alone
    /// rotates each vector by itself.
    fn with_scalar_products(&mut self, graph: &mut Graph, terms: Vec<Id>) -> Vec<Id> {
        let mut products: Vec<Product> = vec![];
        let mut whole = vec![];
        for term in &terms {
            match self.product(graph, *term) {
                Some(product) => products.push(product),
                None => whole.push(*term),
            }
        }
        let mut found = false;
        while let Some(first) = products.pop() {
            match self.scalar_product(graph, &first, &products) {
                Some(ScalarProduct { energy, others }) => {
                    found = true;
                    products.retain(|product| !others.contains(&product.term));
                    whole.push(energy);
                }
                None => whole.push(first.term),
            }
        }
        if found { whole } else { terms }
    }

    /// Returns a term as a product of two coordinates in involution.
    fn product(&mut self, graph: &mut Graph, term: Id) -> Option<Product> {
        let [i, j] = read(graph, term).into_iter().collect::<Vec<_>>()[..] else { return None };
        let slope = diff::partial_derivative(graph, term, Symbol::Position(i));
        let strength = diff::partial_derivative(graph, slope, Symbol::Position(j));
        let constant = read(graph, strength).is_empty() && !graph.is_zero(strength);
        (constant && self.commute(graph, i, j)).then_some(Product { term, pair: [i, j], strength })
    }

    /// Returns the sum of a product and two others, if the sum has a flow.
    fn scalar_product(&mut self, graph: &mut Graph, first: &Product, products: &[Product]) -> Option<ScalarProduct> {
        let mut beside: Vec<&Product> = vec![];
        for other in products {
            if self.are_coupled(graph, first, other) && other.strength == first.strength {
                beside.push(other);
            }
        }
        for (n, second) in beside.iter().enumerate() {
            for third in &beside[..n] {
                let coupled = self.are_coupled(graph, second, third);
                let energy = graph.sum(&[first.term, second.term, third.term]);
                if coupled && self.group(graph, energy).is_some() {
                    return Some(ScalarProduct { energy, others: [second.term, third.term] });
                }
            }
        }
        None
    }

    /// Returns whether neither the first coordinates nor the second coordinates of two products commute.
    fn are_coupled(&mut self, graph: &mut Graph, a: &Product, b: &Product) -> bool {
        !self.commute(graph, a.pair[0], b.pair[0]) && !self.commute(graph, a.pair[1], b.pair[1])
    }

    /// Returns two groups as one, if their flows commute and the sum has a flow.
    fn together(&mut self, graph: &mut Graph, first: &Group, second: &Group, distance: Distance) -> Option<Group> {
        let commute = if first.involutive && second.involutive {
            self.not_in_involution(graph, &(&first.reads | &second.reads)).is_none()
        } else {
            // Other groups keep their places in the order, unless both are scalar products, which may be reordered.
            let products = [first, second].iter().all(|group| group.ends.rules.contains(&SUMS));
            (distance == Distance::Adjacent || products)
                && first.reads.is_disjoint(&second.reads)
                && first.reads.iter().all(|i| second.reads.iter().all(|j| self.commute(graph, *i, *j)))
        };
        if !commute {
            return None;
        }
        let energy = graph.add(first.energy, second.energy);
        self.group(graph, energy)
    }

    /// Returns whether S_ij is proven to be zero.
    fn commute(&mut self, graph: &mut Graph, i: u32, j: u32) -> bool {
        let (i, j) = (i.min(j) as usize, i.max(j) as usize);
        let entry = self.structure[i][j];
        *self.involution[i][j].get_or_insert_with(|| is_zero(graph, entry))
    }

    /// Returns the first two coordinates that are not in involution.
    fn not_in_involution(&mut self, graph: &mut Graph, reads: &BTreeSet<u32>) -> Option<[Symbol; 2]> {
        let mut pairs = reads.iter().flat_map(|i| reads.range(i + 1..).map(move |j| [*i, *j]));
        pairs.find(|[i, j]| !self.commute(graph, *i, *j)).map(|pair| pair.map(Symbol::Position))
    }
}

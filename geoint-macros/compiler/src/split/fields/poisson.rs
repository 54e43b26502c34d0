//! x' = S(x) ∇H by the terms of H.
//!
//! A term that reads only coordinates in involution, S_ij = 0 for i and j among them, leaves these where they are: they are constants of
//! its flow, and what they move mostly obeys single equations, or a linear field. R. I. McLachlan, Phys. Rev. Lett. 71 (1993) 3043.

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

/// Some terms that flow together.
struct Group {
    energy: Id,
    reads: BTreeSet<u32>,
    /// Whether these are in involution.
    involutive: bool,
    ends: Ends,
}

impl Group {
    /// What a step goes through first: more coordinates that stand still; last what moves what it reads.
    fn rank(&self) -> (bool, Reverse<usize>) {
        (!self.involutive, Reverse(if self.involutive { self.reads.len() } else { 0 }))
    }
}

/// The parts in the order of half a step.
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
        match system.group(graph, term) {
            Some(group) => groups.push(group),
            None => match multiplied_out(graph, term, |graph, sum| graph.reads(sum).state()) {
                Some(products) => open.extend(products.into_iter().rev()),
                None => {
                    return Err(NoPart { formula: term, pair: system.not_in_involution(graph, &read(graph, term)) });
                }
            },
        }
    }
    groups.sort_by(|a, b| a.rank().cmp(&b.rank()).then_with(|| a.reads.cmp(&b.reads)));
    let mut merged: Vec<Group> = vec![];
    for group in groups {
        let all = merged.len();
        let together = (0..all).find_map(|i| Some((i, system.together(graph, &merged[i], &group, i + 1 == all)?)));
        match together {
            Some((i, together)) => merged[i] = together,
            None => merged.push(group),
        }
    }
    merged.sort_by_key(Group::rank);
    let part = |graph: &mut Graph, Group { energy, ends: (ends, rules), .. }: Group| {
        let rates = system.rates(graph, energy);
        Part { formula: energy, rules, clock: clock(graph, &rates), motion: Motion::Closed(ends) }
    };
    Ok(merged.into_iter().map(|group| part(graph, group)).collect())
}

/// S, and which coordinates are known to be in involution.
struct System<'a> {
    structure: &'a [Vec<Id>],
    involution: Vec<Vec<Option<bool>>>,
}

impl System<'_> {
    /// What S ∇H moves.
    fn rates(&self, graph: &mut Graph, energy: Id) -> Vec<(Symbol, Id)> {
        let slopes = diff::gradient(graph, energy, self.structure.len() as u32).q;
        let field = times(graph, self.structure, &slopes);
        let rates = (0..).map(Symbol::Position).zip(field);
        rates.filter(|(_, rate)| !graph.is_zero(*rate)).collect()
    }

    /// Terms with a flow in closed form.
    fn group(&mut self, graph: &mut Graph, energy: Id) -> Option<Group> {
        let rates = self.rates(graph, energy);
        let clock = clock(graph, &rates);
        let ends = solve(graph, &rates, clock)?;
        let reads = read(graph, energy);
        let involutive = self.not_in_involution(graph, &reads).is_none();
        Some(Group { energy, reads, involutive, ends })
    }

    /// The terms, three products x₁y₁, x₂y₂ and x₃y₃ that have a flow together as one: each turns two vectors by itself, and all of
    /// them turn both about their sum.
    fn with_scalar_products(&mut self, graph: &mut Graph, terms: Vec<Id>) -> Vec<Id> {
        let mut products: Vec<(Id, [u32; 2], Id)> = vec![];
        let mut whole = vec![];
        let mut found = false;
        for term in &terms {
            let coordinates: Vec<u32> = read(graph, *term).into_iter().collect();
            let second = match coordinates[..] {
                [i, j] => {
                    let slope = diff::partial(graph, *term, Symbol::Position(i));
                    diff::partial(graph, slope, Symbol::Position(j))
                }
                _ => graph.zero(),
            };
            let constant = read(graph, second).is_empty() && !graph.is_zero(second);
            match coordinates[..] {
                [i, j] if constant && self.commute(graph, i, j) => products.push((*term, [i, j], second)),
                _ => whole.push(*term),
            }
        }
        while let Some(first) = products.pop() {
            match self.scalar_product(graph, first, &products) {
                Some((together, others)) => {
                    found = true;
                    products.retain(|(term, ..)| !others.contains(term));
                    whole.push(together);
                }
                None => whole.push(first.0),
            }
        }
        if found { whole } else { terms }
    }

    /// The sum of a product and two of the others, and these, if together they have a flow.
    fn scalar_product(
        &mut self,
        graph: &mut Graph,
        (term, own, strength): (Id, [u32; 2], Id),
        products: &[(Id, [u32; 2], Id)],
    ) -> Option<(Id, [Id; 2])> {
        let mut beside: Vec<(Id, [u32; 2])> = vec![];
        for (other, [i, j], of_other) in products {
            let apart = !self.commute(graph, own[0], *i) && !self.commute(graph, own[1], *j);
            if apart && *of_other == strength {
                beside.push((*other, [*i, *j]));
            }
        }
        for (n, (second, [i, j])) in beside.iter().enumerate() {
            for (third, [k, l]) in &beside[..n] {
                let apart = !self.commute(graph, *i, *k) && !self.commute(graph, *j, *l);
                let sum = graph.sum(&[term, *second, *third]);
                if apart && self.group(graph, sum).is_some() {
                    return Some((sum, [*second, *third]));
                }
            }
        }
        None
    }

    /// Two groups as one, if nothing depends on which of them flows first. `next`: the second follows the first.
    fn together(&mut self, graph: &mut Graph, first: &Group, second: &Group, next: bool) -> Option<Group> {
        let commute = if first.involutive && second.involutive {
            self.not_in_involution(graph, &(&first.reads | &second.reads)).is_none()
        } else {
            // What moves what it reads stays where it is in the order, unless both are scalar products: these may follow each other in any
            // order.
            let products = [first, second].iter().all(|group| group.ends.1.contains(&SUMS));
            (next || products)
                && first.reads.is_disjoint(&second.reads)
                && first.reads.iter().all(|i| second.reads.iter().all(|j| self.commute(graph, *i, *j)))
        };
        if !commute {
            return None;
        }
        let energy = graph.add(first.energy, second.energy);
        self.group(graph, energy)
    }

    fn commute(&mut self, graph: &mut Graph, i: u32, j: u32) -> bool {
        let (i, j) = (i.min(j) as usize, i.max(j) as usize);
        let entry = self.structure[i][j];
        *self.involution[i][j].get_or_insert_with(|| is_zero(graph, entry))
    }

    /// The first two coordinates, if any, that are not in involution.
    fn not_in_involution(&mut self, graph: &mut Graph, reads: &BTreeSet<u32>) -> Option<[Symbol; 2]> {
        let pairs = reads.iter().flat_map(|i| reads.iter().map(move |j| [*i, *j])).filter(|[i, j]| i < j);
        let pairs: Vec<[u32; 2]> = pairs.collect();
        pairs.into_iter().find(|[i, j]| !self.commute(graph, *i, *j)).map(|pair| pair.map(Symbol::Position))
    }
}

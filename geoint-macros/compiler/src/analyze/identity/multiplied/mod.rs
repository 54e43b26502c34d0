//! Proof of an identity by multiplying out over exact ratios, with functions and roots as unknowns of their own.
//!
//! Every combination of the conditions that are read is a case. No number is rounded, and nothing is left to chance.

mod atoms;
mod condition;
mod expand;
mod functions;
mod inequalities;
mod normal;
mod powers;

use super::{OpenBoundaries, Remainder};
use crate::ir::{Graph, Id, Ratio};
use atoms::{Atoms, Formula, Kind};
use condition::Assumptions;
use expand::{Expansion, Stop};
pub(super) use normal::{Atom, Normal, Powers, multiplied as product_of_powers};

/// What multiplying out says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    Zero,
    Left(Remainder),
    /// It has too many terms, too many conditions, or numbers that are too long.
    TooLong,
}

/// Several nodes, multiplied out over the same atoms.
pub(super) struct Sums {
    pub(super) sums: Vec<Normal>,
    atoms: Atoms,
}

impl Sums {
    /// `None` if that is too long, or depends on conditions.
    pub(super) fn of(graph: &Graph, roots: &[Id], products: usize) -> Option<Sums> {
        let assumptions = Assumptions::default();
        let mut expansion = Expansion::new(graph, &assumptions, products);
        let sums: Result<Vec<Normal>, Stop> =
            roots.iter().map(|root| expansion.normal(*root).map(|sum| (*sum).clone())).collect();
        Some(Sums { sums: sums.ok()?, atoms: expansion.atoms })
    }

    /// The atom that a symbol is.
    pub(super) fn symbol(&mut self, id: Id) -> Atom {
        self.atoms.of(Kind::Symbol(id))
    }

    /// The terms of one of the sums, as nodes.
    pub(super) fn terms(&self, graph: &mut Graph, sum: usize) -> Vec<Id> {
        self.sums[sum].terms().map(|(powers, coefficient)| self.product(graph, powers, coefficient)).collect()
    }

    /// A number times powers of atoms, as a node.
    pub(super) fn product(&self, graph: &mut Graph, powers: &Powers, coefficient: Ratio) -> Id {
        Formula { atoms: self.atoms.clone(), normal: Normal::term(powers.clone(), coefficient) }.build(graph)
    }

    /// The symbol that an atom is, if it is one.
    pub(super) fn as_symbol(&self, atom: Atom) -> Option<Id> {
        match self.atoms.kind(atom) {
            Kind::Symbol(id) => Some(*id),
            _ => None,
        }
    }
}

/// More conditions than this are not combined.
const MAX_CONDITIONS: usize = 8;

/// Decides whether a node is zero off the open boundaries, with so many products of two terms in each case at most.
pub(super) fn multiplied(graph: &mut Graph, root: Id, open_boundaries: &OpenBoundaries, products: usize) -> Verdict {
    // Cases that are open; each is divided at the first condition that it leaves undecided.
    let (mut open, mut zeros, mut left) = (vec![Assumptions::default()], false, vec![]);
    while let Some(case) = open.pop() {
        let mut expansion = Expansion::new(graph, &case, products);
        match expansion.normal(root).and_then(|normal| Ok((expansion.is_zero(&normal)?, normal))) {
            Ok((true, _)) => zeros = true,
            Ok((false, normal)) => {
                let certain = expansion.is_plain(&normal);
                let rest = expansion.formula(&normal).build(graph);
                left.push(Remainder { rest, case: case.conditions(), certain });
            }
            Err(Stop::Undecided(comparison)) if case.len() < MAX_CONDITIONS => {
                let atoms = expansion.atoms;
                let is_open = open_boundaries.contains(&comparison.id);
                let cases = [false, true].map(|holds| case.with(&comparison, holds, is_open, &atoms));
                open.extend(cases.into_iter().filter(|case| !case.is_void()));
            }
            Err(_) => return Verdict::TooLong,
        }
    }
    // What is left in every case is left whatever the conditions are.
    let same = !zeros && left.windows(2).all(|pair| pair[0].rest == pair[1].rest);
    match left.into_iter().next() {
        Some(first) if same => Verdict::Left(Remainder { case: vec![], ..first }),
        Some(first) => Verdict::Left(first),
        None => Verdict::Zero,
    }
}

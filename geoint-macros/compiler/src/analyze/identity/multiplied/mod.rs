//! Proof of an identity by multiplying out over exact ratios, with functions and roots as independent unknowns.
//!
//! Conditions divide the states into cases, and each case is multiplied out. No number is rounded, and no step is random.

mod atoms;
mod condition;
mod expand;
mod functions;
mod inequalities;
mod normal;
mod powers;

use super::{OpenBoundaries, Remainder};
use crate::ir::{Graph, HashMap, Id, Ratio};
use atoms::{Atoms, Kind};
use condition::Assumptions;
use expand::{Expansion, Stop};
pub(super) use normal::{Atom, Monomial, Normal, product_of_monomials};
use std::rc::Rc;

/// The result of multiplying out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    Zero,
    Left(Remainder),
    /// There are too many terms or conditions, or numbers are too long.
    TooLong,
}

/// Normal forms of several nodes with common atoms.
pub(super) struct Sums {
    normals: HashMap<Id, Rc<Normal>>,
    atoms: Atoms,
}

impl Sums {
    /// Multiplies out `roots`, with at most `products` products of two terms. `None` if more are needed, or the nodes have conditions.
    pub(super) fn of(graph: &Graph, roots: &[Id], products: usize) -> Option<Sums> {
        let assumptions = Assumptions::default();
        let mut expansion = Expansion::new(graph, &assumptions, products);
        let normals = roots.iter().map(|root| Some((*root, expansion.normal(*root).ok()?))).collect::<Option<_>>()?;
        Some(Sums { normals, atoms: expansion.atoms })
    }

    /// The normal form of a node. Precondition: the node is one of the roots.
    pub(super) fn normal(&self, root: Id) -> &Normal {
        &self.normals[&root]
    }

    /// The terms of the normal form of a root, as nodes.
    pub(super) fn terms(&self, graph: &mut Graph, root: Id) -> Vec<Id> {
        self.normal(root).terms().map(|(monomial, coefficient)| self.term(graph, monomial, coefficient)).collect()
    }

    /// The node coefficient·monomial.
    pub(super) fn term(&self, graph: &mut Graph, monomial: &Monomial, coefficient: Ratio) -> Id {
        self.atoms.build(graph, &Normal::term(monomial.clone(), coefficient))
    }

    /// Returns the atom of the node of a symbol. Adds it if necessary.
    pub(super) fn atom_of_symbol(&mut self, symbol: Id) -> Atom {
        self.atoms.of(Kind::Symbol(symbol))
    }

    /// The node of the symbol that an atom stands for; `None` for other atoms.
    pub(super) fn as_symbol(&self, atom: Atom) -> Option<Id> {
        match self.atoms.kind(atom) {
            Kind::Symbol(id) => Some(*id),
            _ => None,
        }
    }
}

/// The largest number of conditions that are combined.
const MAX_CONDITIONS: usize = 8;

/// Decides whether a node is zero off the open boundaries, with at most `products` products of two terms in each case.
pub(super) fn multiplied(graph: &mut Graph, root: Id, open_boundaries: &OpenBoundaries, products: usize) -> Verdict {
    // Each case is divided at the first condition that it leaves undecided.
    let (mut cases, mut some_case_is_zero, mut left) = (vec![Assumptions::default()], false, vec![]);
    while let Some(case) = cases.pop() {
        let mut expansion = Expansion::new(graph, &case, products);
        let result = expansion.normal(root).and_then(|normal| Ok((expansion.is_zero(&normal)?, normal)));
        let atoms = expansion.atoms;
        match result {
            Ok((true, _)) => some_case_is_zero = true,
            Ok((false, normal)) => {
                let rest = atoms.build(graph, &normal);
                left.push(Remainder { rest, case: case.conditions, certain: atoms.is_certain(&normal) });
            }
            Err(Stop::Undecided(comparison)) if case.conditions.len() < MAX_CONDITIONS => {
                let is_open = open_boundaries.contains(&comparison.id);
                let divided = [false, true].map(|holds| case.with(&comparison, holds, is_open, &atoms));
                cases.extend(divided.into_iter().filter(|case| !case.is_void()));
            }
            Err(_) => return Verdict::TooLong,
        }
    }
    // A remainder that is equal in all cases does not depend on the conditions.
    let is_common = !some_case_is_zero && left.windows(2).all(|pair| pair[0].rest == pair[1].rest);
    match left.into_iter().next() {
        Some(first) if is_common => Verdict::Left(Remainder { case: vec![], ..first }),
        Some(first) => Verdict::Left(first),
        None => Verdict::Zero,
    }
}

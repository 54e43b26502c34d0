//! Proof of an identity by multiplying out over exact ratios, with functions and roots as unknowns of their own.
//!
//! Every combination of the conditions that are read is a case. No number is rounded, and nothing is left to chance.

mod atoms;
mod condition;
mod expand;
mod functions;
mod normal;
mod powers;

use super::Remainder;
use crate::ir::{Graph, Id};
use condition::Assumptions;
use expand::{Expansion, Stop};

/// What multiplying out says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    Zero,
    Left(Remainder),
    /// It has too many terms, too many conditions, or numbers that are too long.
    TooLong,
}

/// More conditions than this are not combined.
const MAX_CONDITIONS: usize = 8;

/// Decides whether a node is zero, with so many products of two terms in each case at most.
pub(super) fn multiplied(graph: &mut Graph, root: Id, products: usize) -> Verdict {
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
                open.extend([false, true].map(|holds| case.with(&comparison, holds, &atoms)));
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

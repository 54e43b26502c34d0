//! Is a node zero, whatever the values of its symbols are?
//!
//! It is multiplied out over exact ratios, with functions and roots as unknowns of their own; every combination of the conditions that
//! it reads is a case. "Zero" is proven: it holds wherever the node is defined, in every case, and no number was rounded. What is
//! left is either no identity, or rests on a relation between functions that is not known here. No value is ever tried.
//!
//! Other ways to prove an identity (evaluation over a finite field, for what is too long to be multiplied out) belong behind
//! [`identity`], in place of [`Identity::TooLong`].

mod atoms;
mod condition;
mod expand;
mod functions;
mod normal;
mod powers;

use crate::ir::{Graph, Id};
use condition::Assumptions;
use expand::{Expansion, Stop};

/// What is known of a node.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Identity {
    /// It is zero wherever it is defined.
    Zero,
    /// It was not proven to be zero.
    Left(Remainder),
    /// It has too many terms, too many conditions, or numbers that are too long.
    TooLong,
}

/// What is left of a node.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Remainder {
    /// The terms that do not cancel.
    pub(crate) rest: Id,
    /// The conditions of the case in which they are left, and whether each holds.
    pub(crate) case: Vec<(Id, bool)>,
    /// Whether the rest is certainly not zero.
    pub(crate) certain: bool,
}

/// More conditions than this are not combined.
const MAX_CONDITIONS: usize = 8;

/// Decides whether a node is zero.
pub(crate) fn identity(graph: &mut Graph, root: Id) -> Identity {
    // Cases that are open; each is divided at the first condition that it leaves undecided.
    let (mut open, mut zeros, mut left) = (vec![Assumptions::default()], false, vec![]);
    while let Some(case) = open.pop() {
        let mut expansion = Expansion::new(graph, &case);
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
            Err(_) => return Identity::TooLong,
        }
    }
    // What is left in every case is left whatever the conditions are.
    let same = !zeros && left.windows(2).all(|pair| pair[0].rest == pair[1].rest);
    match left.into_iter().next() {
        Some(first) if same => Identity::Left(Remainder { case: vec![], ..first }),
        Some(first) => Identity::Left(first),
        None => Identity::Zero,
    }
}

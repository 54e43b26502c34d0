//! Alike statements as arrays: what a chain of many masses does for each of its springs is written once, in a loop.

mod arrange;
mod find;

use super::block::{Block, Instruction, Operand, Register, Statement};
use crate::ir::{HashMap, Symbol};
use find::Finder;
use std::collections::BTreeMap;

/// Fewer alike statements than this are written one by one: what is small stays in registers.
const FEWEST: usize = 16;

/// A block is written with loops if at most one of so many statements is left alone.
const MOST_ALONE: usize = 4;

/// Where something is in an array that the routine is given: the number of the array, and indices, the last one first.
pub(crate) type Place = (usize, Indices);
pub(crate) type Indices = [i32; 3];

/// What values are read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Source {
    /// One operand, by a number: the same for all.
    One(usize),
    /// An array that the routine is given, by its number.
    Given(usize),
    /// What the routine of an earlier level has stored.
    Slots(usize),
    /// Another family, and which of its results.
    Family(usize, usize),
}

/// Successive values: the `i`-th is at `first + i·step`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Run {
    pub(crate) source: Source,
    pub(crate) first: Indices,
    pub(crate) step: Indices,
}

/// Values that are computed alike, as an array.
#[derive(Clone, Debug)]
pub(crate) struct Family {
    pub(crate) length: usize,
    /// What the `i`-th one reads, and what that is called in the body.
    pub(crate) reads: Vec<(Register, Run)>,
    /// What is computed, under the names that it has for the first one.
    pub(crate) body: Vec<(Vec<Register>, Instruction)>,
    pub(crate) results: Vec<Register>,
    /// Where the routine writes its results, if it does nothing else with them.
    pub(crate) target: Option<Run>,
}

/// A block whose alike statements are arrays.
#[derive(Debug)]
pub(crate) struct Families {
    /// By numbers.
    pub(crate) all: BTreeMap<usize, Family>,
    /// The family, the result and the place of each register that is read elsewhere.
    pub(crate) members: HashMap<Register, (usize, usize, usize)>,
    /// What is done, in order.
    pub(crate) items: Vec<Item>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Item {
    Statement(usize),
    Family(usize),
}

/// Alike statements of a block, if nearly all are alike, of a system with so many coordinates; results are written to `targets`, if it says
/// where.
pub(crate) fn families(
    (block, degrees): (&Block, usize),
    place: &dyn Fn(Symbol) -> Option<Place>,
    targets: impl FnOnce() -> Vec<Option<Place>>,
) -> Option<Families> {
    // The cheapest question first: most systems are small.
    if degrees.min(block.statements.len()) < FEWEST
        || !block.statements.iter().any(|statement| reads_of_many(statement, place))
    {
        return None;
    }
    let mut finder = Finder::new(block, place);
    finder.find();
    let alike: usize = finder.found.iter().map(|family| family.members.len()).sum();
    let alone = block.statements.len() - alike;
    (alike > 0 && alone * MOST_ALONE <= block.statements.len()).then(|| finder.arrange(&targets()))
}

/// Whether a statement reads an array that is long enough.
fn reads_of_many(statement: &Statement, place: &dyn Fn(Symbol) -> Option<Place>) -> bool {
    let mut found = false;
    statement.for_each_operand(&mut |operand| {
        if let Operand::Input(
            symbol @ (Symbol::Position(i)
            | Symbol::Momentum(i)
            | Symbol::Velocity(i)
            | Symbol::PositionIncrement(i)
            | Symbol::MomentumIncrement(i)),
        ) = operand
            && *i as usize + 1 >= FEWEST
        {
            let last = place(*symbol).and_then(|(_, indices)| indices.into_iter().max());
            found |= last.is_some_and(|last| last as usize + 1 >= FEWEST);
        }
    });
    found
}

//! Loops of alike statements. A chain of many masses has alike springs, and one loop computes them all.
//!
//! A loop computes an array, or writes successive entries of an array that the routine was given.

mod arrange;
mod find;

use super::block::{Block, Statement};
use super::instruction::{Operand, Register};
use super::layout::{Array, Layout, Place};
use crate::ir::Symbol;
use find::Finder;

/// The fewest members of a loop. Fewer statements are written one by one, and their values stay in registers of the processor.
const FEWEST: usize = 16;

/// A block has loops if at most one of so many statements remains outside of them.
const MOST_ALONE: usize = 4;

/// The most indices of an array that loops read.
const MOST_INDICES: usize = 3;

/// Indices of an entry, the last one first. Missing indices are 0.
pub(crate) type Indices = [i32; MOST_INDICES];

/// An array that a loop computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Computed {
    pub(crate) array: usize,
    /// The part of each entry. Nothing if entries are numbers.
    pub(crate) part: Option<usize>,
}

/// The values from which the members of a loop read. The order of the variants decides the order of members.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Source {
    /// One operand for all members, by its number.
    One(usize),
    /// An array that the routine was given, and the number of its indices.
    Given(Array, usize),
    /// The slots of an earlier level.
    Slots(usize),
    /// The array of another loop.
    Computed(Computed),
}

/// An entry of a source.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Address {
    source: Source,
    indices: Indices,
}

/// Successive entries of a source. Member i reads the entry at `first + i·step`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Run {
    pub(crate) source: Source,
    pub(crate) first: Indices,
    pub(crate) step: Indices,
}

/// A loop.
#[derive(Clone, Debug)]
pub(crate) struct Loop {
    /// The number of the array that the loop computes.
    pub(crate) array: usize,
    pub(crate) length: usize,
    /// The entries that a member reads, and the registers that hold them in the body.
    pub(crate) reads: Vec<(Register, Run)>,
    /// The statements of a member, in the registers of the first one.
    pub(crate) body: Vec<Statement>,
    /// The registers of the body that hold an entry of the array.
    pub(crate) results: Vec<Register>,
    /// The registers that other statements read, for each entry of the array.
    pub(crate) members: Vec<Vec<Register>>,
    /// The entries that the loop writes instead of an array of its own.
    pub(crate) target: Option<Run>,
}

/// Returns a block with loops that has the same results, or writes them to `targets` if there are any. Nothing if few statements are alike.
pub(super) fn with_loops(block: &Block, layout: &Layout<'_>, targets: &[Place]) -> Option<Block> {
    // Most systems are small. This test is cheap.
    if layout.coordinates.len().min(block.statements.len()) < FEWEST
        || !block.statements.iter().any(|statement| reads_of_many(statement, layout))
    {
        return None;
    }
    let mut finder = Finder::new(block, layout);
    finder.find();
    let alike: usize = finder.found.iter().map(|found| found.members.len()).sum();
    let alone = block.statements.len() - alike;
    (alike > 0 && alone * MOST_ALONE <= block.statements.len()).then(|| finder.arrange(targets))
}

/// Returns whether a statement reads a coordinate or an increment in an array that is long enough.
fn reads_of_many(statement: &Statement, layout: &Layout<'_>) -> bool {
    use Symbol::{Momentum, MomentumIncrement, Position, PositionIncrement, Velocity};
    let mut found = false;
    statement.for_each_operand(&mut |operand| {
        if let Operand::Input(
            symbol @ (Position(i) | Momentum(i) | Velocity(i) | PositionIncrement(i) | MomentumIncrement(i)),
        ) = operand
            && *i as usize + 1 >= FEWEST
        {
            let address = Address::of(&layout.place(*symbol));
            found |= address.is_some_and(|address| address.indices.into_iter().any(|i| i as usize + 1 >= FEWEST));
        }
    });
    found
}

impl Address {
    /// Returns the address of a place in an array that loops can read.
    fn of(place: &Place) -> Option<Address> {
        let rank = place.indices.len();
        if rank == 0 || rank > MOST_INDICES {
            return None;
        }
        let mut indices = Indices::default();
        for (to, from) in indices.iter_mut().zip(place.indices.iter().rev()) {
            *to = *from as i32;
        }
        Some(Address { source: Source::Given(place.array, rank), indices })
    }

    /// Returns the difference of the indices of two entries.
    fn minus(&self, other: &Address) -> Indices {
        std::array::from_fn(|i| self.indices[i] - other.indices[i])
    }
}

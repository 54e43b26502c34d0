//! Loops of alike statements. A chain of many masses has alike springs, and one loop computes all springs.
//!
//! A loop computes an array, or writes successive entries of an array of the caller.

mod arrange;
mod find;

use super::block::{Block, Statement};
use super::instruction::{Operand, Register};
use super::layout::{Array, Layout, Place};
use crate::ir::Symbol;
use find::Finder;

/// The fewest members of a loop. Fewer values stay in registers of the processor, without a loop.
const FEWEST: usize = 16;

/// A block has loops if at most a fourth of its statements stays outside of loops.
const MOST_ALONE: usize = 4;

/// The most indices of an array in a loop.
const MOST_INDICES: usize = 3;

/// Indices of an entry, the last index first. Missing indices are 0.
pub(crate) type Indices = [i32; MOST_INDICES];

/// The array of a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Computed {
    pub(crate) array: usize,
    /// The part of each entry. Nothing if entries are numbers.
    pub(crate) part: Option<usize>,
}

/// A source of operands. The order of the variants decides the order of members.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Source {
    /// The number of an operand that all members share.
    One(usize),
    /// An array of the caller, and the number of its indices.
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
pub(crate) struct Successive {
    pub(crate) source: Source,
    pub(crate) first: Indices,
    pub(crate) step: Indices,
}

/// A loop.
#[derive(Clone, Debug)]
pub(crate) struct Loop {
    /// The number of the array.
    pub(crate) array: usize,
    pub(crate) length: usize,
    /// The operands of a member, and their registers in the body.
    pub(crate) reads: Vec<(Register, Successive)>,
    /// The statements of a member, in the registers of the first member.
    pub(crate) body: Vec<Statement>,
    /// The registers of an entry in the body.
    pub(crate) results: Vec<Register>,
    /// The registers of each entry in statements after the loop.
    pub(crate) members: Vec<Vec<Register>>,
    /// The entries of an array of the caller, if the loop has no array of its own.
    pub(crate) target: Option<Successive>,
}

/// Returns the block with loops. The new block writes its results to `targets`, if there are any. Returns nothing if few statements are alike.
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

/// Returns whether a statement reads a coordinate or an increment from a long array.
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
    /// Returns the address of an entry. Returns nothing for numbers outside of arrays, and for too many indices.
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

//! Loops of alike statements. A chain of many masses has alike springs, and one loop computes all springs.
//!
//! A loop computes an array, or writes successive entries of an array of the caller.

mod arrange;
mod find;

use super::address::Address;
use super::block::{Block, Statement};
use super::instruction::Operand;
use super::layout::{Layout, Place};
use crate::ir::Symbol;
use find::Finder;

/// The fewest members of a loop. Fewer values stay in registers of the processor, without a loop.
const FEWEST: usize = 16;

/// A block has loops if at most a fourth of its statements stays outside of loops.
const MOST_ALONE: usize = 4;

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

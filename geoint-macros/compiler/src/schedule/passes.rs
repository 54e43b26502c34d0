//! Passes over the statements of a routine.

use super::block::{Block, Statement};
use super::layout::{Layout, Place};
use super::{loops, packs};

/// Returns the block for the printer. With targets, the block writes its results, and returns nothing.
///
/// Many alike statements become loops. In a block without loops, alike roots and quotients become packs.
pub(crate) fn arranged(block: Block, layout: &Layout<'_>, targets: &[Place]) -> Block {
    if let Some(block) = loops::with_loops(&block, layout, targets) {
        return block;
    }
    let mut block = packs::with_packs(&block).unwrap_or(block);
    if !targets.is_empty() {
        let results = std::mem::take(&mut block.results);
        let writes = targets.iter().zip(results).map(|(place, result)| Statement::Write(place.clone(), result));
        block.statements.extend(writes);
    }
    block
}

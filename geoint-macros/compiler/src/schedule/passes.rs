//! Passes over the statements of a routine.

use super::block::{Block, Statement};
use super::layout::{Layout, Place};
use super::{loops, packs};

/// Returns a block as it is printed. If there are targets, the block writes its results there, and returns none.
///
/// Many alike statements become loops. Otherwise, a few roots and quotients become packs.
pub(crate) fn arranged(block: &Block, layout: &Layout<'_>, targets: &[Place]) -> Block {
    if let Some(block) = loops::with_loops(block, layout, targets) {
        return block;
    }
    let mut block = packs::with_packs(block).unwrap_or_else(|| block.clone());
    if !targets.is_empty() {
        let results = std::mem::take(&mut block.results);
        let writes = targets.iter().zip(results).map(|(place, result)| Statement::Write(place.clone(), result));
        block.statements.extend(writes);
    }
    block
}

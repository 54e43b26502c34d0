//! Passes over the statements of a routine: loops, packs, and the writing of results.

use super::block::{Block, Statement};
use super::layout::{Layout, Place};
use super::{loops, packs};

/// Arranges a block for the printer.
///
/// - If nearly all statements repeat with moving indices, as along a chain of masses, they become loops: the code stays short.
/// - Otherwise square roots and quotients with the same operands become packs, four operations side by side. Only these pay for moving numbers in and out of
///   vector registers. The bodies of loops have none: rustc vectorises them.
///
/// `targets` are the places of the results in arrays. With targets, the block writes its results there and returns none. Without targets, it returns them.
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

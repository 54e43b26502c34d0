//! Passes over the statements of a routine: loops, packs, and the writing of results.

use super::block::{Block, Statement};
use super::layout::{Layout, Place};
use super::{loops, packs};

/// Arranges a block for the printer.
///
/// - If nearly all statements repeat with moving indices, as along a chain of masses, they become loops: the code stays short.
/// - Otherwise independent square roots and quotients of alike expressions become packs, four operations side by side. Cheaper operations would not repay
///   the cost of moving numbers into vector registers and out of them. Bodies of loops have no packs, because rustc vectorises loops itself.
///
/// `targets` lists one place in an array for each result, or is empty. With targets, the block writes its results there and returns none: bodies of
/// loops write their own results, and other writes come last. Without targets, the block returns its results.
pub(crate) fn arranged(block: Block, layout: &Layout<'_>, targets: &[Place]) -> Block {
    debug_assert!(targets.is_empty() || targets.len() == block.results.len());
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

//! A routine: its statements one after the other, alike ones as loops, and what becomes of its results.
//!
//! All variables of a routine are declared by one `let`. A `let` each would nest as many scopes, and thousands of those overflow the
//! stack of rustc where it writes debug information.

use super::given::Given;
use super::loops::Output;
use super::tokens::Tokens;
use super::writer::{Names, Writer};
use crate::schedule::{Block, Register, side_by_side};
use proc_macro2::TokenStream;
use quote::ToTokens;

/// The statements of a block, followed by what `finish` makes of its results.
pub(crate) fn routine<T: ToTokens>(
    block: &Block,
    names: Names<'_>,
    finish: impl FnOnce(Vec<Tokens>) -> T,
) -> TokenStream {
    let mut writer = Writer::new(names);
    let (results, alone) = writer.results(block, &[]);
    // Nothing is written by a loop where there are no targets.
    let value = |output| if let Output::Value(value) = output { value } else { Tokens::default() };
    let last = finish(results.into_iter().map(value).collect());
    writer.finished(&alone, last)
}

/// The statements of a block, and those that write its results to `targets`.
pub(crate) fn assignments(block: &Block, names: Names<'_>, targets: &[Given]) -> TokenStream {
    let mut writer = Writer::new(names);
    let (results, alone) = writer.results(block, targets);
    for (target, output) in targets.iter().zip(results) {
        match output {
            Output::Value(value) => writer.assign(target.tokens(), value),
            Output::Loop(statement) => writer.extend(statement),
            Output::Written => {}
        }
    }
    writer.finished(&alone, Tokens::default())
}

impl Writer<'_> {
    /// Writes a block, its alike statements as loops; returns its results, and the registers that are in no array.
    fn results(&mut self, block: &Block, targets: &[Given]) -> (Vec<Output>, Vec<Register>) {
        match self.families(block, targets) {
            Some(families) => self.with_loops(block, families),
            None => {
                let side_by_side = side_by_side(block);
                let block = side_by_side.as_ref().unwrap_or(block);
                (self.block(block).into_iter().map(Output::Value).collect(), block.registers())
            }
        }
    }
}

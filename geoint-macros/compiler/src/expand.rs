//! The compiler on one screen: from an annotated function to the items that are emitted beside it.

use crate::compilation::Compilation;
use crate::diagnostics::Result;
use crate::parse::Energy;
use crate::{check, emit, front};
use proc_macro2::TokenStream;

/// Returns the items that are emitted beside the function.
///
/// `front` has one file for each form: it proves facts (`analyze`), decomposes the energy (`split`), checks the user's requests (`check`), and
/// derives the routines of every method (`diff`, `derive`).
pub(crate) fn system(energy: &Energy) -> Result<TokenStream> {
    let (mut compilation, terms) = Compilation::lowered(energy)?; // Rust to nodes
    check::angles(&mut compilation, &terms)?;
    let mut derived = front::derived(&mut compilation, terms)?; // facts, and nodes for every method
    derived.system.schedule(&mut compilation); // nodes to statements
    Ok(emit::items(&compilation, &derived)) // statements to tokens
}

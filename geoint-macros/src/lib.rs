//! The attributes of `geoint-runtime`, which re-exports them: a compiler from energy functions to integrators.

mod diagnostics;
mod ir;
mod parse;
mod lower;
mod analyze;
mod check;
mod diff;
mod schedule;
mod emit;
mod expand;
#[cfg(test)]
mod tests;

use proc_macro::TokenStream;

/// Makes a system from an energy H(q, p, t).
#[proc_macro_attribute]
pub fn hamiltonian(args: TokenStream, item: TokenStream) -> TokenStream {
    expand::hamiltonian(args.into(), item.into()).into()
}

//! The compiler behind the attributes of `geoint-runtime`: from an energy function to integrators for its system.
//!
//! Each function takes the tokens of an attribute and of the item below it, and returns the tokens that replace both. The crate is a plain library, so
//! tests and other programs can call it. Errors are tokens, too: `compile_error!` at the place of the mistake.

// In reading order. No module imports a later one.
mod diagnostics;
mod messages;
mod ir;
mod parse;
mod lower;
mod compilation;
mod analyze;
mod diff;
mod schedule;
mod split;
mod legendre;
mod derive;
mod check;
mod emit;
mod link;
mod front;
mod expand;
mod attribute;
#[cfg(test)]
mod tests;

use proc_macro2::TokenStream;

/// The largest number of unknowns with a generated Newton kernel. The runtime has the same constant, so that both crates decide alike.
pub const MOST_UNKNOWNS: usize = derive::MOST_UNKNOWNS;

/// Expands `#[hamiltonian]`: an energy H(q, p), or H(q, p, t).
pub fn hamiltonian(args: TokenStream, item: TokenStream) -> TokenStream {
    attribute::expand(parse::Form::Hamiltonian, args, item)
}

/// Expands `#[vector_field]`: x' = f(x) or x' = f(x, t), with first integrals.
pub fn vector_field(args: TokenStream, item: TokenStream) -> TokenStream {
    attribute::expand(parse::Form::Field, args, item)
}

/// Expands `#[contact_hamiltonian]`: H(q, p, s) or H(q, p, s, t).
pub fn contact_hamiltonian(args: TokenStream, item: TokenStream) -> TokenStream {
    attribute::expand(parse::Form::Contact, args, item)
}

/// Expands `#[lagrangian]`: L(q, v), L(q, v, t) or L(q, v, s, t).
pub fn lagrangian(args: TokenStream, item: TokenStream) -> TokenStream {
    attribute::expand(parse::Form::Lagrangian, args, item)
}

/// Expands `#[energy_function]`: a function that energies may call.
pub fn energy_function(args: TokenStream, item: TokenStream) -> TokenStream {
    attribute::energy_function(args, item)
}

/// Asks for the text of a function. If the function is not under `#[energy_function]`, rustc prints the name of this macro as advice.
pub fn put_energy_function_above_it(input: TokenStream) -> TokenStream {
    link::put(input)
}

/// Continues an expansion with the text of a function under `#[energy_function]`.
pub fn resume(input: TokenStream) -> TokenStream {
    attribute::resume(input)
}

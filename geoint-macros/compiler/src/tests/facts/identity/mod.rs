//! Zero nodes are recognised by the expected proof, and no other node is taken for zero.

mod branches;
mod claims;
mod integrals;
mod kept;
mod liouville;
mod points;
mod search;
mod spelling;
mod systems;

use super::super::lowered;
use crate::diff::jacobian;
use crate::ir::{Graph, Id, Symbol};
use proc_macro2::TokenStream;
use quote::quote;

/// The components of several arrays in one graph. The arrays read x, an array of `n` numbers, the parameters a, b, c, d, and t.
fn arrays(n: usize, setup: &TokenStream, arrays: &[&TokenStream]) -> (Graph, Vec<Vec<Id>>) {
    // An energy has one value, so components are its derivatives by weights.
    let lengths: Vec<usize> = arrays.iter().map(|array| length(array)).collect();
    let total: usize = lengths.iter().sum();
    let mut first = 0;
    let sums = arrays.iter().zip(&lengths).map(|(array, length)| {
        let start = first;
        first += length;
        quote! { let entries = #array; for i in 0..#length { total += weight[#start + i] * entries[i]; } }
    });
    let sums: Vec<TokenStream> = sums.collect();
    let (_, mut lowered) = lowered(quote! {
        fn energy(q: [f64; #n], p: [f64; #n], t: f64, weight: [f64; #total], a: f64, b: f64, c: f64, d: f64) -> f64 {
            let x = q;
            #setup
            let mut total = 0.0;
            #(#sums)*
            total
        }
    });
    let weights: Vec<Symbol> = (0..total as u32).map(Symbol::Parameter).collect();
    let mut roots = jacobian(&mut lowered.graph, &[lowered.terms.energy], &weights).remove(0).into_iter();
    let arrays = lengths.iter().map(|length| roots.by_ref().take(*length).collect()).collect();
    (lowered.graph, arrays)
}

/// The number of entries of an array expression.
fn length(array: &TokenStream) -> usize {
    let array: syn::ExprArray = syn::parse2(array.clone()).expect("an array");
    array.elems.len()
}

/// x₀, x₁, …
fn coordinates(n: usize) -> Vec<Symbol> {
    (0..n as u32).map(Symbol::Position).collect()
}

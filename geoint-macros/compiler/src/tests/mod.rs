//! Tests of the whole compiler, and of stages that are not public.

mod agreement;
mod corpus;
mod cost;
mod jets;
mod eval;
mod facts;
mod loops;
mod flows;
mod fuzz;
mod growth;
mod precise;
mod derivatives;
mod rounding;
mod slopes;
mod edges;
mod trees;
mod schedules;
mod integrals;
mod lagrangians;
mod meaning;
mod pieces;
mod poles;
mod snapshots;

use crate::ir::Graph;
use crate::lower::{self, Lowered};
use crate::parse::{self, Energy, Form};
use proc_macro2::TokenStream;

/// Lowers a function under an attribute. Panics if the macro refuses it.
fn lowered_by(form: Form, args: TokenStream, item: TokenStream) -> (Energy, Lowered) {
    let item = syn::parse2(item).expect("a function");
    let energy = parse::energy(form, args, item).unwrap_or_else(|e| panic!("{:?}", e.messages()));
    let lowered = lower::body(&energy).unwrap_or_else(|e| panic!("{:?}", e.messages()));
    (energy, lowered)
}

/// Lowers a Hamiltonian. Panics if the macro refuses it.
fn lowered(item: TokenStream) -> (Energy, Lowered) {
    lowered_by(Form::Hamiltonian, TokenStream::new(), item)
}

/// Returns the code that is emitted for a function under an attribute, as text. It contains the report and the messages.
fn expansion(form: Form, args: TokenStream, item: TokenStream) -> String {
    crate::attribute::expand(form, args, item).to_string()
}

/// Returns the statements of an emitted scope `const _: () = { … };`.
fn hidden_statements(item: &syn::Item) -> Option<&[syn::Stmt]> {
    let syn::Item::Const(constant) = item else { return None };
    let syn::Expr::Block(block) = &*constant.expr else { return None };
    Some(&block.block.stmts)
}

/// Pseudo-random numbers, equal in every run.
struct Noise(u64);

impl Noise {
    /// Returns a number from the uniform distribution on (low, high).
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

/// Returns a graph with one symbol.
fn graph_of(symbol: crate::ir::Symbol) -> (Graph, crate::ir::Id) {
    let mut graph = Graph::default();
    let id = graph.symbol(symbol);
    (graph, id)
}

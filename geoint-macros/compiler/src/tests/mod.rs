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
use crate::{lower, parse};
use proc_macro2::TokenStream;

/// The graph of an energy, and the energy in it.
fn lowered(item: TokenStream) -> (parse::Energy, lower::Lowered) {
    let item = syn::parse2(item).expect("a function");
    let energy = parse::energy(parse::Form::Hamiltonian, TokenStream::new(), item)
        .unwrap_or_else(|e| panic!("{:?}", e.messages()));
    let lowered = lower::body(&energy).unwrap_or_else(|e| panic!("{:?}", e.messages()));
    (energy, lowered)
}

/// Numbers that look random and are the same in every run.
struct Noise(u64);

impl Noise {
    /// Uniform in (low, high).
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

/// A graph with a symbol in it.
fn graph_of(symbol: crate::ir::Symbol) -> (Graph, crate::ir::Id) {
    let mut graph = Graph::default();
    let id = graph.symbol(symbol);
    (graph, id)
}

//! The equations of implicit steps, for every contact Hamiltonian.

use super::super::implicit::{level, write_field};
use super::super::kernel::Context;
use super::super::system::self_type;
use crate::diff::contact::{Equation, discrete, midpoint};
use crate::ir::{Graph, Id, Symbol};
use crate::schedule::{self, Operations};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

type Derive = fn(&mut Graph, Id, u32) -> Equation;

/// The methods whose steps are solved.
const METHODS: [(&str, Derive); 2] = [("ContactMidpoint", midpoint), ("ContactDiscreteGradient", discrete)];

/// `impl ImplicitStep` for each method, and what an evaluation costs.
pub(super) fn steps(
    context: &Context<'_>,
    graph: &mut Graph,
    energy: Id,
    bounds: &TokenStream,
) -> (TokenStream, Vec<(&'static str, Operations)>) {
    let mut tokens = TokenStream::new();
    let costs = METHODS.map(|(method, derive)| {
        let equation = derive(graph, energy, context.energy.degrees());
        let (step, cost) = step(context, graph, method, &equation, bounds);
        tokens.extend(step);
        (method, cost)
    });
    (tokens, costs.to_vec())
}

fn step(
    context: &Context<'_>,
    graph: &mut Graph,
    method: &str,
    Equation { field, end }: &Equation,
    bounds: &TokenStream,
) -> (TokenStream, Operations) {
    let (name, method) = (self_type(context), format_ident!("{method}"));
    let (unknown, places) = (context.unknown_type(field.unknowns.len()), context.unknown_places(field.unknowns.len()));
    let degrees = context.energy.degrees();
    let before: Vec<Symbol> =
        (0..degrees).map(Symbol::Q).chain((0..degrees).map(Symbol::P)).chain([Symbol::S]).collect();

    // Φ and 1 − ∂Φ/∂d.
    let (zero, one) = (graph.zero(), graph.integer(1));
    let mut image = field.f.clone();
    for (i, row) in field.jacobian.iter().enumerate() {
        image.extend(row.iter().enumerate().map(|(j, entry)| graph.sub(if i == j { one } else { zero }, *entry)));
    }
    let plan = schedule::plan(graph, level, &[&[], &[]], &[&image, end]);
    let constants = context.planned(&plan.stores[0], (&[], ""), |values| quote!([#(#values),*]));
    let begin = context.planned(&plan.stores[1], (&before, "x"), |values| quote!([#(#values),*]));
    let image =
        context.planned(&plan.last[0], (&field.unknowns, "d"), |values| write_field(["f", "matrix"], &places, &values));
    let end = context.planned(&plan.last[1], (&field.unknowns, "d"), |values| quote!([#(#values),*]));
    let [prepared, started] = [plan.slots[0], plan.slots[1]].map(Literal::usize_unsuffixed);
    let tokens = quote! {
        impl<R: #bounds> ImplicitStep<#method, R> for #name {
            type Unknown = #unknown;
            type Constants = [R; #prepared];
            type Start = [R; #started];

            #[inline]
            fn constants(&self, h: R) -> [R; #prepared] {
                #constants
            }
            #[inline(always)]
            fn begin(&self, prepared: &[R; #prepared], t: R, x: &#unknown) -> [R; #started] {
                #begin
            }
            #[inline(always)]
            fn image(
                &self,
                prepared: &[R; #prepared],
                start: &[R; #started],
                d: &#unknown,
                f: &mut #unknown,
                matrix: &mut Square<#unknown>,
            ) {
                #image
            }
            #[inline(always)]
            fn end(&self, prepared: &[R; #prepared], start: &[R; #started], d: &#unknown) -> #unknown {
                #end
            }
        }
    };
    (tokens, plan.last[0].operations())
}

//! The exact flows of pieces; or, if some term is in no piece, an implementation that no scalar satisfies, whose message names
//! the term.

use super::super::flows::unsatisfied;
use super::super::kernel::Context;
use super::super::system::{modified_energy, self_type};
use super::mechanics::assign;
use crate::check::NO_PIECES;
use crate::ir::{Graph, Id, Symbol, print::Printer};
use crate::schedule::{self, Operations};
use crate::split::{self, Clock, Piece, Pieces, level};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The tokens, and what each flow costs.
pub(super) fn pieces(
    context: &Context<'_>,
    graph: &mut Graph,
    found: &Pieces,
    bounds: &TokenStream,
) -> (TokenStream, Vec<Operations>) {
    match found {
        Ok(pieces) => {
            let flows: Vec<Kernel> = pieces.iter().map(|piece| kernel(context, graph, piece)).collect();
            let tokens = splitting(context, graph, pieces, &flows, bounds);
            let modified = (context.energy.lift.is_none()).then(|| {
                let modified = split::modified_energy(graph, pieces, context.energy.degrees());
                let modified = context.routine(graph, &[modified], |mut values| values.remove(0));
                modified_energy(context, &modified, bounds)
            });
            (quote!(#tokens #modified), flows.iter().map(|flow| flow.operations).collect())
        }
        Err(term) => (none(context, graph, *term, bounds), vec![]),
    }
}

/// A flow as tokens.
struct Kernel {
    slots: [Literal; 2],
    prepare: TokenStream,
    freeze: TokenStream,
    body: TokenStream,
    operations: Operations,
}

fn kernel(context: &Context<'_>, graph: &mut Graph, piece: &Piece) -> Kernel {
    let lift = context.energy.lift.is_some();
    let changed: Vec<(Symbol, Id)> =
        piece.flow.changed(graph).into_iter().filter(|(symbol, _)| !(lift && matches!(symbol, Symbol::P(_)))).collect();
    let roots: Vec<Id> = changed.iter().map(|(_, end)| *end).collect();
    let plan = schedule::plan(graph, level(piece.clock), &[&[], &[]], &[&roots]);
    let [prepare, freeze] =
        [0, 1].map(|level| context.planned(&plan.stores[level], (&[], ""), |values| quote!([#(#values),*])));
    let body = context.planned(&plan.last[0], (&[], ""), |values| assign(context, &changed, &values));
    let slots = [plan.slots[0], plan.slots[1]].map(Literal::usize_unsuffixed);
    Kernel { slots, prepare, freeze, body, operations: plan.last[0].operations() }
}

fn splitting(
    context: &Context<'_>,
    graph: &Graph,
    pieces: &[Piece],
    flows: &[Kernel],
    bounds: &TokenStream,
) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let printer = Printer::new(graph, |symbol| context.user_name(symbol));
    let table = pieces.iter().map(|piece| {
        let name = printer.excerpt(piece.energy);
        let clock = match piece.clock {
            Clock::Own => quote!(Own),
            Clock::Stage => quote!(Stage),
        };
        quote!(ContactPiece { name: #name, clock: PieceClock::#clock })
    });
    let types = |level: usize| {
        let slots = flows.iter().map(|flow| &flow.slots[level]);
        quote!((#([R; #slots],)*))
    };
    let (types, frozen_types) = (types(0), types(1));
    let last = flows.len() - 1;
    let prepared = flows.iter().enumerate().map(|(i, flow)| {
        let (length, prepare) = (if i == last { quote!(last) } else { quote!(outer) }, &flow.prepare);
        quote!({ let h = #length; #prepare })
    });
    let frozen = flows.iter().enumerate().map(|(i, flow)| {
        let (i, freeze) = (Literal::usize_unsuffixed(i), &flow.freeze);
        quote!({ let prepared = &flows.#i; #freeze })
    });
    let arms = flows.iter().enumerate().map(|(i, flow)| {
        let (i, body) = (Literal::usize_unsuffixed(i), &flow.body);
        quote!(#i => { let (prepared, start) = (&flows.#i, &frozen.#i); #body })
    });
    quote! {
        impl<R: #bounds> ContactPieces<R> for #name {
            const PIECES: &'static [ContactPiece] = &[#(#table),*];
            type Flows = #types;
            type Frozen = #frozen_types;

            #[inline]
            fn prepare_flows(&self, outer: R, last: R) -> #types {
                (#(#prepared,)*)
            }
            #[inline(always)]
            fn freeze(&self, flows: &#types, t: R) -> #frozen_types {
                (#(#frozen,)*)
            }
            #[inline(always)]
            fn flow(
                &self,
                piece: usize, flows: &#types, frozen: &#frozen_types, t: R, q: &mut #array, p: &mut #array, s: &mut R,
            ) {
                match piece {
                    #(#arms)*
                    _ => {}
                }
            }
        }
    }
}

fn none(context: &Context<'_>, graph: &Graph, term: Id, bounds: &TokenStream) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let (marker, tokens) = unsatisfied(context, graph, "Splits", term, NO_PIECES);
    let never = quote!(::core::convert::Infallible);
    quote! {
        #tokens
        impl<R: #bounds + #marker> ContactPieces<R> for #name {
            const PIECES: &'static [ContactPiece] = &[];
            type Flows = #never;
            type Frozen = ();
            fn prepare_flows(&self, _: R, _: R) -> #never {
                ::core::unreachable!()
            }
            fn freeze(&self, _: &#never, _: R) {}
            fn flow(&self, _: usize, never: &#never, _: &(), _: R, _: &mut #array, _: &mut #array, _: &mut R) {
                match *never {}
            }
        }
    }
}

//! The exact flows of pieces; or, if some term is in no piece, an implementation that no scalar satisfies, whose message names
//! the term.

use super::flows::{assign, increments, unsatisfied};
use super::kernel::Context;
use super::system::self_type;
use crate::derive::{Missing, PieceKernel};
use crate::ir::{Graph, print::Printer};
use crate::schedule::Plan;
use crate::split::Clock;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// `impl ContactPieces`.
pub(super) fn pieces(
    context: &Context<'_>,
    graph: &Graph,
    found: &Result<Vec<PieceKernel<Plan>>, Missing>,
) -> TokenStream {
    match found {
        Ok(pieces) => splitting(context, graph, pieces),
        Err(missing) => none(context, graph, *missing),
    }
}

fn splitting(context: &Context<'_>, graph: &Graph, pieces: &[PieceKernel<Plan>]) -> TokenStream {
    let (name, phase, parts) = (self_type(context), context.phase(), context.parts());
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
        let slots = pieces.iter().map(|piece| Literal::usize_unsuffixed(piece.flow.kernel.slots[level]));
        quote!((#([R; #slots],)*))
    };
    let (types, frozen_types) = (types(0), types(1));
    let last = pieces.len() - 1;
    let stored = |piece: &PieceKernel<Plan>, level: usize| context.stored(&piece.flow.kernel, level);
    let prepared = pieces.iter().enumerate().map(|(i, piece)| {
        let (length, prepare) = (if i == last { quote!(last) } else { quote!(outer) }, stored(piece, 0));
        quote!({ let h = #length; #prepare })
    });
    let frozen = pieces.iter().enumerate().map(|(i, piece)| {
        let (i, freeze) = (Literal::usize_unsuffixed(i), stored(piece, 1));
        quote!({ let prepared = &flows.#i; #freeze })
    });
    let arms = pieces.iter().enumerate().map(|(i, piece)| {
        let (i, body) = (Literal::usize_unsuffixed(i), assign(context, &piece.flow));
        quote!(#i => { let (prepared, start) = (&flows.#i, &frozen.#i); #body })
    });
    let added = pieces.iter().enumerate().map(|(i, piece)| {
        let (i, body) = (Literal::usize_unsuffixed(i), increments(context, &piece.flow));
        quote!(#i => { let (prepared, start) = (&flows.#i, &frozen.#i); #body })
    });
    let per = context.per_coordinate();
    quote! {
        impl<R: Real> ContactPieces<R> for #name {
            const PIECES: &'static [ContactPiece] = &[#(#table),*];
            type Proof = ();
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
                piece: usize, flows: &#types, frozen: &#frozen_types, t: R, z: &mut #phase, s: &mut R,
            ) {
                #parts
                match piece {
                    #(#arms)*
                    _ => {}
                }
            }
            #[inline(always)]
            fn increments(&self, piece: usize, flows: &#types, frozen: &#frozen_types, t: R, x: &#per) -> #per {
                match piece {
                    #(#added)*
                    _ => PerCoordinate::nothing(),
                }
            }
        }
    }
}

fn none(context: &Context<'_>, graph: &Graph, missing: Missing) -> TokenStream {
    let (name, phase, per) = (self_type(context), context.phase(), context.per_coordinate());
    let (marker, tokens) = unsatisfied(context, graph, missing);
    let never = quote!(::core::convert::Infallible);
    quote! {
        #tokens
        impl<R: Real + #marker> ContactPieces<R> for #name {
            const PIECES: &'static [ContactPiece] = &[];
            type Proof = <R as #marker>::Proof;
            type Flows = #never;
            type Frozen = ();
            fn prepare_flows(&self, _: R, _: R) -> #never {
                ::core::unreachable!()
            }
            fn freeze(&self, _: &#never, _: R) {}
            fn flow(&self, _: usize, never: &#never, _: &(), _: R, _: &mut #phase, _: &mut R) {
                match *never {}
            }
            fn increments(&self, _: usize, never: &#never, _: &(), _: R, _: &#per) -> #per {
                match *never {}
            }
        }
    }
}

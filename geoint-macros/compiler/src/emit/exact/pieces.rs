//! The exact flows of pieces; or, if some term is in no piece, an implementation that no scalar satisfies, whose message names
//! the term.

use super::{assign, increments};
use crate::derive::{PieceKernel, PiecesOf};
use crate::emit::implementation::{Absent, Implementation, Inline, Method, Trait, Ty, absent_with, methods, ty};
use crate::emit::kernel::{Context, Values};
use crate::emit::tokens::{Tokens, element};
use crate::ir::Symbol;
use crate::split::Clock;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

const FLOW_PIECES: Trait = Trait {
    name: "FlowPieces",
    has_proof: true,
    associated: &[("Flows", Absent::Never), ("Frozen", Absent::Unit)],
    methods: methods! {
        Hint fn prepare_flows("outer": {R}, "last": {R}) -> Flows;
        Always fn freeze("flows": {&Flows}, "t": {R}) -> Frozen;
        Always fn flow("piece": {usize}, "flows": {&Flows}, "frozen": {&Frozen}, "t": {R}, "z": {&mut Phase}, "s": {&mut Action}) wide;
        Always fn increments("piece": {usize}, "flows": {&Flows}, "frozen": {&Frozen}, "t": {R}, "x": {&PerCoordinate}) -> PerCoordinate;
    },
    provided: &[],
};

/// `impl Pieces`.
pub(in crate::emit) fn pieces(context: &Context<'_>, found: &PiecesOf) -> TokenStream {
    let name = format_ident!("{}", found.splitting);
    match &found.pieces {
        Ok(pieces) => splitting(context, &name, found, pieces),
        Err(missing) => {
            let no_pieces = quote!(
                const PIECES: &'static [FlowPiece] = &[];
            );
            absent_with(context, *missing, &[&FLOW_PIECES], &quote!(#name,), &no_pieces)
        }
    }
}

fn splitting(context: &Context<'_>, splitting: &Ident, found: &PiecesOf, pieces: &[PieceKernel]) -> TokenStream {
    let parts = context.parts();
    let (symplectic, conserves_energy) = (found.symplectic, found.conserves_energy);
    let printer = context.printer();
    let table = pieces.iter().map(|piece| {
        let (solved, may_end) = (piece.solved, piece.may_end);
        let moved = || piece.flow.changes.iter().map(|symbol| printer.named(*symbol)).collect::<Vec<_>>().join(", ");
        let name = if solved { moved() } else { printer.excerpt(piece.energy) };
        let clock = match piece.clock {
            Clock::Own => quote!(Own),
            Clock::Stage => quote!(Stage),
        };
        quote!(FlowPiece { name: #name, clock: PieceClock::#clock, solved: #solved, may_end: #may_end })
    });
    let types = |level: usize| {
        let slots = pieces.iter().map(|piece| Literal::usize_unsuffixed(piece.flow.kernel.slots[level]));
        nested(slots.map(|slots| quote!([R; #slots])).collect())
    };
    let (types, frozen_types) = (types(0), types(1));
    let (count, last) = (pieces.len(), pieces.len() - 1);
    let stored = |piece: &PieceKernel, level: usize| context.stored(&piece.flow.kernel, level);
    let prepared = pieces.iter().enumerate().map(|(i, piece)| {
        let (length, prepare) = (if i == last { quote!(last) } else { quote!(outer) }, stored(piece, 0));
        quote!({ let h = #length; #prepare })
    });
    let frozen = pieces.iter().enumerate().map(|(i, piece)| {
        let (own, freeze) = (member(quote!(flows), i, count), stored(piece, 1));
        quote!({ let prepared = &#own; #freeze })
    });
    let [prepared, frozen] = [nested(prepared.collect()), nested(frozen.collect())];
    let arm = |i: usize, body: TokenStream| {
        let [flow, start] = [quote!(flows), quote!(frozen)].map(|all| member(all, i, count));
        let i = Literal::usize_unsuffixed(i);
        quote!(#i => { let (prepared, start) = (&#flow, &#start); #body })
    };
    let arms = pieces.iter().enumerate().map(|(i, piece)| {
        let body = if piece.solved { solve(context, piece, Target::State) } else { assign(context, &piece.flow) };
        arm(i, body)
    });
    let added = pieces.iter().enumerate().map(|(i, piece)| {
        let body =
            if piece.solved { solve(context, piece, Target::Increments) } else { increments(context, &piece.flow) };
        arm(i, body)
    });
    let per_piece = [("Flows", types.clone()), ("Frozen", frozen_types.clone())];
    Implementation::new(context, &FLOW_PIECES, &per_piece)
        .with_parameters(quote!(#splitting,))
        .items(quote! {
            const PIECES: &'static [FlowPiece] = &[#(#table),*];
            const SYMPLECTIC: bool = #symplectic;
            const CONSERVES_ENERGY: bool = #conserves_energy;
            type Proof = ();
            type Flows = #types;
            type Frozen = #frozen_types;
        })
        .method("prepare_flows", prepared)
        .method("freeze", frozen)
        .method("flow", quote!(#parts match piece { #(#arms)* _ => {} }))
        .method("increments", quote!(match piece { #(#added)* _ => PerCoordinate::nothing(), }))
        .finish()
}

/// How many members a tuple has at most: the standard library knows no traits of tuples of more than twelve.
const MOST_MEMBERS: usize = 12;

/// A tuple of any number of values or types, in tuples of tuples where they are many.
fn nested(mut members: Vec<TokenStream>) -> TokenStream {
    while members.len() > MOST_MEMBERS {
        members = members.chunks(MOST_MEMBERS).map(|some| quote!((#(#some,)*))).collect();
    }
    quote!((#(#members,)*))
}

/// The i-th of so many members of it.
fn member(all: TokenStream, i: usize, count: usize) -> TokenStream {
    let inner = if count > MOST_MEMBERS { member(all, i / MOST_MEMBERS, count.div_ceil(MOST_MEMBERS)) } else { all };
    let i = Literal::usize_unsuffixed(if count > MOST_MEMBERS { i % MOST_MEMBERS } else { i });
    quote!(#inner.#i)
}

/// What the step of a plane is added to.
#[derive(Clone, Copy)]
enum Target {
    State,
    Increments,
}

/// The step of a plane, added to the target.
fn solve(context: &Context<'_>, piece: &PieceKernel, target: Target) -> TokenStream {
    let coordinates = match target {
        Target::State => quote!(q),
        Target::Increments => quote!(d.z),
    };
    let [x, y] = [0, 1].map(|i| context.input(piece.flow.changes[i]));
    let places = piece.flow.changes.iter().enumerate().map(|(i, symbol)| {
        let place = match symbol {
            Symbol::Position(index) => element(coordinates.clone(), &context.coordinate(*index)),
            _ => Tokens::default(),
        };
        let i = Literal::usize_unsuffixed(i);
        quote!(#place = #place + step[#i];)
    });
    let equation = context.outputs(piece.flow.kernel.routine("equation"), |outputs| {
        let parts = outputs.iter().map(Values::listed);
        quote!((#(#parts),*))
    });
    let solved = quote! {
        let step = planar_step([#x, #y], |increment: &[R; 2]| -> ([R; 2], [[R; 2]; 2]) { #equation });
        #(#places)*
    };
    if let Target::State = target {
        return solved;
    }
    let parts = context.per_coordinate();
    quote! {
        let PerCoordinate { z: q, s } = x;
        let mut d: #parts = PerCoordinate::nothing();
        #solved
        d
    }
}

//! Flows of the pieces of an energy or a field. If a term is in no piece, no scalar satisfies the implementation, and the message names the term.

use super::{assign, increments, stepped_as};
use crate::derive::{PieceKernel, PiecesOf};
use crate::emit::context::{Context, Values};
use crate::emit::implementation::{Implementation, Leading, absent_with, flag};
use crate::emit::signature::{Absent, Trait, methods};
use crate::emit::tokens::{Tokens, element};
use crate::ir::Symbol;
use crate::split::Clock;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// The flow of each piece, by its index.
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

/// Returns `impl FlowPieces` for one splitting.
pub(in crate::emit) fn pieces(context: &Context<'_>, found: &PiecesOf) -> TokenStream {
    let name = format_ident!("{}", found.splitting);
    let leading = |items: TokenStream| Leading { parameters: quote!(#name,), items };
    let stepped = context.form.has_action().then(|| {
        let steps = quote!(PieceComposition<1, #name>);
        stepped_as(context, found.splitting, &steps, found.pieces.as_ref().err().copied())
    });
    let flows = match &found.pieces {
        Ok(pieces) => {
            let constants = [flag("SYMPLECTIC", found.symplectic), flag("CONSERVES_ENERGY", found.conserves_energy)];
            let table = table(context, pieces);
            flows(context, pieces, leading(quote!(#table #(#constants)*)))
        }
        Err(missing) => absent_with(context, *missing, &[&FLOW_PIECES], &leading(table(context, &[]))),
    };
    quote!(#flows #stepped)
}

/// Returns the constant that lists the pieces.
fn table(context: &Context<'_>, pieces: &[PieceKernel]) -> TokenStream {
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
    quote!(const PIECES: &'static [FlowPiece] = &[#(#table),*];)
}

/// Returns the implementation for a system with pieces. Each piece has numbers for a step length, and numbers for a start time.
fn flows(context: &Context<'_>, pieces: &[PieceKernel], leading: Leading) -> TokenStream {
    let types = |level: usize| {
        let slots = pieces.iter().map(|piece| Literal::usize_unsuffixed(piece.flow.kernel.slots[level]));
        nested(slots.map(|slots| quote!([R; #slots])).collect())
    };
    let count = pieces.len();
    let stored = |piece: &PieceKernel, level: usize| context.stored(&piece.flow.kernel, level);
    let prepared = pieces.iter().enumerate().map(|(i, piece)| {
        let (length, prepare) = (if i + 1 == count { quote!(last) } else { quote!(outer) }, stored(piece, 0));
        quote!({ let h = #length; #prepare })
    });
    let frozen = pieces.iter().enumerate().map(|(i, piece)| {
        let (own, freeze) = (member(quote!(flows), i, count), stored(piece, 1));
        quote!({ let prepared = &#own; #freeze })
    });
    let [prepared, frozen] = [nested(prepared.collect()), nested(frozen.collect())];
    let arms = |target: Target| {
        let arms = pieces.iter().enumerate().map(|(i, piece)| {
            let [flow, start] = [quote!(flows), quote!(frozen)].map(|all| member(all, i, count));
            let body = match target {
                _ if piece.solved => solve(context, piece, target),
                Target::State => assign(context, &piece.flow),
                Target::Increments => increments(context, &piece.flow),
            };
            let i = Literal::usize_unsuffixed(i);
            quote!(#i => { let (prepared, start) = (&#flow, &#start); #body })
        });
        arms.collect::<TokenStream>()
    };
    let (parts, moves, added) = (context.parts(), arms(Target::State), arms(Target::Increments));
    Implementation::new(context, &FLOW_PIECES, &[("Flows", types(0)), ("Frozen", types(1))])
        .leading(leading)
        .types()
        .method("prepare_flows", prepared)
        .method("freeze", frozen)
        .method("flow", quote!(#parts match piece { #moves _ => {} }))
        .method("increments", quote!(match piece { #added _ => PerCoordinate::nothing(), }))
        .finish()
}

/// The largest number of members of a tuple. The standard library implements its traits for tuples of at most twelve members.
const MOST_MEMBERS: usize = 12;

/// Returns a tuple of values or types. Many members are nested in tuples of tuples.
fn nested(mut members: Vec<TokenStream>) -> TokenStream {
    while members.len() > MOST_MEMBERS {
        members = members.chunks(MOST_MEMBERS).map(|some| quote!((#(#some,)*))).collect();
    }
    quote!((#(#members,)*))
}

/// Returns member `i` of a nested tuple with `count` members.
fn member(all: TokenStream, i: usize, count: usize) -> TokenStream {
    let inner = if count > MOST_MEMBERS { member(all, i / MOST_MEMBERS, count.div_ceil(MOST_MEMBERS)) } else { all };
    let i = Literal::usize_unsuffixed(i % MOST_MEMBERS);
    quote!(#inner.#i)
}

/// The destination of the increments of a piece.
#[derive(Clone, Copy)]
enum Target {
    /// The coordinates of the state, in place.
    State,
    /// A new point with the increments.
    Increments,
}

/// Returns the step of a piece whose equation is solved in its plane. The increments of both coordinates are added to the target.
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
    let parts = context.per_coordinate_type();
    quote! {
        let PerCoordinate { z: q, s } = x;
        let mut d: #parts = PerCoordinate::nothing();
        #solved
        d
    }
}

//! Canonical coordinates of a flow, in which collocation is symplectic.

use super::square;
use crate::emit::kernel::{Context, write};
use crate::emit::structure::self_type;
use crate::schedule::Plan;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// `impl CanonicalForm`.
pub(super) fn canonical(context: &Context<'_>, stage: &Plan) -> TokenStream {
    let (name, phase, places) = (self_type(context), context.phase(), context.coordinates());
    let squares = square(&places);
    let n = places.len();
    let constants = context.stored(stage, 0);
    let prepared = Literal::usize_unsuffixed(stage.slots[0]);
    let body = context.planned(&stage.last[0], (&[], ""), |values| {
        let (vectors, matrices) = values.split_at(2 * n);
        let vectors =
            ["value", "rate"].into_iter().zip(vectors.chunks(n)).map(|(name, entries)| write(name, &places, entries));
        let matrices = ["value_by", "rate_by"]
            .into_iter()
            .zip(matrices.chunks(n * n))
            .map(|(name, entries)| write(name, &squares, entries));
        quote!(#(#vectors)* #(#matrices)*)
    });
    let parts = context.parts();
    quote! {
        impl<R: Real> CanonicalForm<R> for #name {
            type Proof = ();
            type CanonicalConstants = [R; #prepared];

            #[inline]
            fn canonical_constants(&self) -> [R; #prepared] {
                #constants
            }
            #[inline(always)]
            fn canonical(
                &self,
                prepared: &[R; #prepared],
                t: R,
                z: &#phase,
                [value, rate]: [&mut #phase; 2],
                [value_by, rate_by]: &mut [Square<#phase>; 2],
            ) {
                #parts
                #body
            }
        }
    }
}

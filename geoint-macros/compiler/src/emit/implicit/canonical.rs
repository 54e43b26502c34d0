//! Canonical coordinates of a flow, in which collocation is symplectic.

use super::prepared::Prepared;
use super::write_derivatives;
use crate::emit::kernel::Context;
use crate::emit::structure::self_type;
use crate::schedule::Plan;
use proc_macro2::TokenStream;
use quote::quote;

/// `impl CanonicalForm`.
pub(super) fn canonical(context: &Context<'_>, stage: &Plan) -> TokenStream {
    let (name, phase, places) = (self_type(context), context.phase(), context.coordinates());
    let Prepared { types, functions, prepared, .. } =
        Prepared::for_stages(context, stage, ["CanonicalConstants", "canonical_constants"]);
    let body = context.planned(&stage.last[0], (&[], ""), |values| {
        write_derivatives(&places, (&["value", "rate"], &["value_by", "rate_by"]), &values)
    });
    let parts = context.parts();
    quote! {
        impl<R: Real> CanonicalForm<R> for #name {
            type Proof = ();
            #types

            #functions
            #[inline(always)]
            fn canonical(
                &self,
                prepared: &#prepared,
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

//! Canonical coordinates of a flow, in which collocation is symplectic.

use super::prepared::Prepared;
use crate::emit::kernel::Context;
use crate::emit::structure::self_type;
use crate::schedule::Kernel;
use proc_macro2::TokenStream;
use quote::quote;

/// `impl CanonicalForm`.
pub(super) fn canonical(context: &Context<'_>, stage: &Kernel) -> TokenStream {
    let (name, phase) = (self_type(context), context.phase());
    let Prepared { types, functions, prepared, .. } =
        Prepared::for_stages(context, stage, ["CanonicalConstants", "canonical_constants"]);
    let (parts, body) = (context.parts(), context.assigned(stage.routine("canonical")));
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

//! Canonical coordinates of a flow. Collocation is symplectic in these coordinates.

use super::prepared::Prepared;
use crate::emit::context::Context;
use crate::emit::implementation::proven;
use crate::schedule::Kernel;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns `impl CanonicalForm`.
pub(super) fn canonical(context: &Context<'_>, stage: &Kernel) -> TokenStream {
    let Prepared { types, functions, prepared, .. } =
        Prepared::for_stages(context, stage, ["CanonicalConstants", "canonical_constants"]);
    let (phase, parts, body) = (context.phase_type(), context.parts(), context.assigned(stage.routine("canonical")));
    let items = quote! {
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
    };
    proven(context, quote!(CanonicalForm<R>), items)
}

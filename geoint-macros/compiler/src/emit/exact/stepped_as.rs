//! The steps of splittings of contact systems, which constraints change.

use crate::derive::Missing;
use crate::emit::context::Context;
use crate::emit::missing::marker;
use crate::emit::structure::self_type;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns `impl SteppedAs` for a method. If the system lacks it, no scalar satisfies the implementation.
pub(in crate::emit) fn stepped_as(
    context: &Context<'_>,
    method: &str,
    steps: &TokenStream,
    missing: Option<Missing>,
) -> TokenStream {
    let (name, method) = (self_type(context), format_ident!("{method}"));
    let (bound, proof) = match missing.map(|missing| marker(context, missing)) {
        Some(marker) => (quote!(+ #marker), quote!(<R as #marker>::Proof)),
        None => (quote!(), quote!(())),
    };
    quote! {
        impl<R: Real #bound> SteppedAs<#method, R> for #name {
            type Proof = #proof;
            type Steps = #steps;
        }
    }
}

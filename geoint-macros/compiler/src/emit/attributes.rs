//! Attributes of the user's function, and of its arguments, that the struct has too.
//!
//! The struct repeats names of the function, so that what a lint says of the function it says of the struct as well. What is
//! about calls (`inline`, `must_use`, …) stays with the function.

use crate::parse::Energy;
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::punctuated::Punctuated;
use syn::{Attribute, Meta, Path, Token};

/// The attributes that are repeated, as they are written on a struct.
pub(super) fn repeated(attributes: &[Attribute]) -> impl Iterator<Item = TokenStream> {
    attributes.iter().filter_map(|attribute| {
        if attribute.path().is_ident("expect") {
            // The lint may be silent here, where nobody expects anything of it.
            let lints = &attribute.meta.require_list().ok()?.tokens;
            return Some(quote!(#[allow(#lints)]));
        }
        let same = ["doc", "deprecated", "allow", "warn", "deny", "forbid"];
        same.iter().any(|name| attribute.path().is_ident(name)).then(|| attribute.to_token_stream())
    })
}

/// Whether those who use the function, or what is made of it, are told not to.
pub(super) fn is_deprecated(energy: &Energy) -> bool {
    energy.item.attrs.iter().any(|attribute| attribute.path().is_ident("deprecated"))
}

/// Whether the user expects that nobody calls the function.
pub(super) fn expected_dead(energy: &Energy) -> bool {
    let dead = |lint: &Path| lint.is_ident("dead_code") || lint.is_ident("unused");
    energy.item.attrs.iter().filter(|attribute| attribute.path().is_ident("expect")).any(|attribute| {
        let lints = attribute.parse_args_with(Punctuated::<Meta, Token![,]>::parse_terminated);
        lints.is_ok_and(|lints| lints.iter().any(|lint| dead(lint.path())))
    })
}

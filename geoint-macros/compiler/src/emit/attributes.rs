//! Attributes of the user's function and its arguments that the struct repeats.
//!
//! The struct repeats names of the function, so lints about these names concern both. Attributes about calls (`inline`, `must_use`, …) stay with the function.

use crate::parse::Energy;
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::punctuated::Punctuated;
use syn::{Attribute, Meta, Path, Token};

/// Returns the repeated attributes in their form for a struct.
pub(super) fn repeated(attributes: &[Attribute]) -> impl Iterator<Item = TokenStream> {
    attributes.iter().filter_map(|attribute| {
        if attribute.path().is_ident("expect") {
            // The struct may not trigger the lint. An unfulfilled `expect` would be a warning.
            let lints = &attribute.meta.require_list().ok()?.tokens;
            return Some(quote!(#[allow(#lints)]));
        }
        let same = ["doc", "deprecated", "allow", "warn", "deny", "forbid"];
        same.iter().any(|name| attribute.path().is_ident(name)).then(|| attribute.to_token_stream())
    })
}

/// Returns whether the function is deprecated.
pub(super) fn is_deprecated(energy: &Energy) -> bool {
    energy.item.attrs.iter().any(|attribute| attribute.path().is_ident("deprecated"))
}

/// Returns whether the user expects the lint about unused code for the function.
pub(super) fn expected_dead(energy: &Energy) -> bool {
    let dead = |lint: &Path| lint.is_ident("dead_code") || lint.is_ident("unused");
    energy.item.attrs.iter().filter(|attribute| attribute.path().is_ident("expect")).any(|attribute| {
        let lints = attribute.parse_args_with(Punctuated::<Meta, Token![,]>::parse_terminated);
        lints.is_ok_and(|lints| lints.iter().any(|lint| dead(lint.path())))
    })
}

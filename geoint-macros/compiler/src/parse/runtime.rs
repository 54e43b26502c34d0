//! Path of the runtime in generated code.

use proc_macro_crate::FoundCrate;
use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, quote};
use syn::Ident;

/// Returns the path in `crate = path`, or the name of the runtime in the user's Cargo.toml.
pub(super) fn path_or(given: Option<&syn::Path>) -> TokenStream {
    if let Some(path) = given {
        return path.into_token_stream();
    }
    match proc_macro_crate::crate_name("geoint-runtime") {
        Ok(FoundCrate::Name(name)) => {
            let name = Ident::new(&name, Span::call_site());
            quote!(::#name)
        }
        // Tests and examples of the runtime use its public name. A crate that re-exports the runtime needs `crate = path`.
        Ok(FoundCrate::Itself) | Err(_) => quote!(::geoint_runtime),
    }
}

//! Where the runtime is, seen from the crate of the user.

use proc_macro_crate::FoundCrate;
use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, quote};
use syn::Ident;

/// The path of the runtime: the one that is given, or that of the name in Cargo.toml.
pub(super) fn path_or(given: Option<syn::Path>) -> TokenStream {
    if let Some(path) = given {
        return path.into_token_stream();
    }
    match proc_macro_crate::crate_name("geoint-runtime") {
        Ok(FoundCrate::Name(name)) => {
            let name = Ident::new(&name, Span::call_site());
            quote!(::#name)
        }
        // The tests and docs of the runtime name it as others do. Where nothing is found, another crate may re-export it:
        // that is what `crate = path` is for.
        Ok(FoundCrate::Itself) | Err(_) => quote!(::geoint_runtime),
    }
}

//! Passes the text of functions under `#[energy_function]` to other attributes. An attribute sees only its own item.
//!
//! Each such function has a macro of the same name. The macro passes the function's text to its caller. An attribute asks for the functions in its
//! `with(…)` in order. Each request carries the tokens collected so far, and each reply resumes the expansion.

use crate::diagnostics::Result;
use crate::parse::{self, Source};
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};
use syn::ext::IdentExt;
use syn::{Path, Visibility};

/// Returns the macro of an energy function, or a request for the text of the next function in its `with(…)`.
pub(crate) fn offered(source: &Source) -> Result<TokenStream> {
    let options = parse::function_options(source.args.clone())?;
    let function: syn::ItemFn = syn::parse2(source.item.clone())?;
    Ok(match options.with.get(source.used.len()) {
        Some(path) => ask(&options.runtime_path(), "energy_function", path, source),
        None => offer(&function.sig.ident, &function.vis, source),
    })
}

/// Asks the macro of a function for its text. The reply resumes the attribute of the given name.
///
/// The request goes through `put_energy_function_above_it`. If the function has no macro, rustc's message shows this name as advice.
pub(crate) fn ask(runtime: &TokenStream, attribute: &str, path: &Path, source: &Source) -> TokenStream {
    let attribute = format_ident!("{attribute}");
    quote! {
        #runtime::private::put_energy_function_above_it! { { #path } [#runtime::private::resume] #attribute #source }
    }
}

/// Rewrites `{ path } …` to `path! { … }`. The spans of `path` keep the user's place and belong to the call of this macro, so rustc's message names it.
pub(crate) fn put(input: TokenStream) -> TokenStream {
    let mut input = input.into_iter();
    let Some(TokenTree::Group(path)) = input.next() else { return TokenStream::new() };
    let path = path.stream().into_iter().map(|mut tree| {
        tree.set_span(Span::call_site().located_at(tree.span()));
        tree
    });
    let (path, rest): (TokenStream, TokenStream) = (path.collect(), input.collect());
    quote!(#path! { #rest })
}

/// Returns the macro of a function, with the name and the visibility of the function. Other crates can not use the macro.
fn offer(name: &Ident, visibility: &Visibility, source: &Source) -> TokenStream {
    let hidden = format_ident!("__energy_function_{}", name.unraw());
    let visibility = match visibility {
        Visibility::Public(_) => quote!(pub(crate)),
        other => quote!(#other),
    };
    quote! {
        #[doc(hidden)]
        #[allow(unused_macros, reason = "generated code")]
        macro_rules! #hidden {
            ([$($callback:tt)*] $($state:tt)*) => { $($callback)*! { $($state)* { #source } } };
        }
        #[doc(hidden)]
        #[allow(unused_imports, clippy::all, clippy::pedantic, clippy::nursery, reason = "generated code")]
        #visibility use #hidden as #name;
    }
}

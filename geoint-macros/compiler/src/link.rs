//! How an energy gets at a function under `#[energy_function]`: attributes see their own item alone.
//!
//! Such a function has a macro beside it, of the same name, that hands its text on to whoever asks. An attribute asks for the
//! functions that it names one after the other, with all that it knows so far, and is called back.

use crate::diagnostics::Result;
use crate::parse::{self, Source};
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};
use syn::ext::IdentExt;
use syn::{Path, Visibility};

/// The macro of a function, once the functions that it names are there; until then the question for the next one.
pub(crate) fn offered(source: &Source) -> Result<TokenStream> {
    let options = parse::function_options(source.args.clone())?;
    let function: syn::ItemFn = syn::parse2(source.item.clone())?;
    Ok(match options.with.get(source.used.len()) {
        Some(path) => ask(&options.runtime, "energy_function", path, source),
        None => offer(&function.sig.ident, &function.vis, source),
    })
}

/// Asks the macro of a function for its text; `attribute` is called back with all of it.
///
/// The question goes through a macro whose name rustc says if there is nobody to ask.
pub(crate) fn ask(runtime: &TokenStream, attribute: &str, path: &Path, source: &Source) -> TokenStream {
    let attribute = format_ident!("{attribute}");
    quote! {
        #runtime::private::put_energy_function_above_it! { { #path } [#runtime::private::resume] #attribute #source }
    }
}

/// `{ path } …` as `path! { … }`, with `path` as this macro's word.
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

/// The macro of a function, under the name of the function and as visible, but in no other crate.
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

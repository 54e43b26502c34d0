//! The compiler on one screen: from the annotated function to the code that integrates it.

use crate::diagnostics::Result;
use crate::{analyze, check, diff, emit, lower, parse};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

/// The user's function, and all that is made from it; with messages in place of that if something is wrong.
pub(crate) fn hamiltonian(args: TokenStream, item: TokenStream) -> TokenStream {
    if let Err(errors) = parse::nesting(&quote!(#args #item)) {
        let errors = errors.into_tokens();
        return quote!(#item #errors);
    }
    match syn::parse2::<syn::ItemFn>(item.clone()) {
        // The function comes first and as it is, so that rustc and editors see it whatever happens.
        Ok(function) => match parse::energy(args, function) {
            Ok(energy) => {
                let function = emit::function(&energy).unwrap_or(item);
                let derived = derive(&energy).unwrap_or_else(|errors| errors.into_tokens());
                quote!(#function #derived)
            }
            Err(errors) => {
                let errors = errors.into_tokens();
                quote!(#item #errors)
            }
        },
        Err(_) => match syn::parse2::<syn::Item>(item.clone()) {
            Ok(other) => {
                let message = syn::Error::new_spanned(other.to_token_stream(), "this attribute goes above a function");
                let message = message.into_compile_error();
                quote!(#item #message)
            }
            // Not Rust at all: rustc says it better.
            Err(_) => item,
        },
    }
}

/// From who is q, p, t to what is emitted beside the function.
fn derive(energy: &parse::Energy) -> Result<TokenStream> {
    let lower::Lowered { mut graph, energy: root, damping, places, partial, constants } = lower::body(energy)?; // Rust to graph
    let context = emit::Context { energy, constants: &constants, partial: &partial };
    let structure = analyze::structure(&mut graph, root, &energy.coordinates.shape); // facts, with witnesses
    let structure = structure.damped(&graph, damping);
    check::requests(energy, &structure, &graph, &places, |symbol| context.user_name(symbol))?; // asked for = proven?
    let derivatives = diff::derivatives(&mut graph, &structure, energy.degrees());
    Ok(emit::items(&context, &mut graph, &structure, &derivatives))
}

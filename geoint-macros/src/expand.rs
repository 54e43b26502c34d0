//! The compiler on one screen: from the annotated function to the code that integrates it.

use crate::diagnostics::Result;
use crate::parse::Form;
use crate::{analyze, check, diff, emit, lower, parse, split};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

/// The user's function, and all that is made from it; with messages in place of that if something is wrong.
pub(crate) fn expand(form: Form, args: TokenStream, item: TokenStream) -> TokenStream {
    if let Err(errors) = parse::nesting(&quote!(#args #item)) {
        let errors = errors.into_tokens();
        return quote!(#item #errors);
    }
    match syn::parse2::<syn::ItemFn>(item.clone()) {
        // The function comes first and as it is, so that rustc and editors see it whatever happens.
        Ok(function) => match parse::energy(form, args, function) {
            Ok(energy) => {
                let function = emit::function(&energy, item);
                let derived = match form {
                    Form::Hamiltonian => hamiltonian(&energy),
                    Form::Contact => contact_hamiltonian(&energy),
                };
                let derived = derived.unwrap_or_else(|errors| errors.into_tokens());
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
fn hamiltonian(energy: &parse::Energy) -> Result<TokenStream> {
    let mut lowered = lower::body(energy)?; // Rust to graph
    let (graph, context) = (&mut lowered.graph, emit::Context::new(energy, &lowered.constants, &lowered.partial));
    let structure = analyze::structure(graph, lowered.energy, &energy.coordinates.shape); // facts, with witnesses
    let structure = structure.damped(graph, lowered.damping);
    check::requests(energy, &structure, graph, &lowered.places, |symbol| context.user_name(symbol))?; // asked for = proven?
    let derivatives = diff::derivatives(graph, &structure, energy.degrees());
    Ok(emit::items(&context, graph, &structure, &derivatives))
}

/// The same with the action s.
fn contact_hamiltonian(energy: &parse::Energy) -> Result<TokenStream> {
    let mut lowered = lower::body(energy)?;
    let (graph, context) = (&mut lowered.graph, emit::Context::new(energy, &lowered.constants, &lowered.partial));
    let groups = lowered.groups.as_deref();
    let pieces = split::pieces(graph, lowered.energy, energy.degrees(), groups); // flows in closed form
    let mechanics = split::mechanics(graph, lowered.energy, energy.degrees());
    let asked = (lowered.energy, groups);
    check::pieces(energy, asked, &pieces, graph, &lowered.places, |symbol| context.user_name(symbol))?;
    Ok(emit::contact_items(&context, graph, lowered.energy, &pieces, &mechanics))
}

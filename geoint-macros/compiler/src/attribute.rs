//! What stands under an attribute, and what takes its place: the function as it is, and what the compiler makes of it (`expand.rs`).

use crate::diagnostics::Result;
use crate::parse::{Form, Source};
use crate::{emit, expand, link, parse};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};
use syn::parse::Parser;

/// The user's function, and all that is made from it; with messages in place of that if something is wrong.
pub(crate) fn expand(form: Form, args: TokenStream, item: TokenStream) -> TokenStream {
    let written = args.clone();
    if let Err(errors) = parse::nesting(&quote!(#args #item)) {
        let errors = errors.into_tokens();
        return quote!(#item #errors);
    }
    match syn::parse2::<syn::ItemFn>(item.clone()) {
        // The function comes first and as it is, so that rustc and editors see it whatever happens.
        Ok(function) => match parse::energy(form, args, function) {
            Ok(energy) => {
                let function = emit::function(&energy, item.clone());
                let read_by_attribute = energy.expressions().next().is_some() || energy.options.force.is_some();
                match derived(energy, &Source { args: written, item: item.clone(), used: vec![] }) {
                    Ok(derived) => quote!(#function #derived),
                    Err(errors) => {
                        // Without the expressions of the attribute, of which rustc would say the same again.
                        let unread = read_by_attribute.then(|| quote!(#[allow(unused_variables)]));
                        let errors = errors.into_tokens();
                        quote!(#unread #item #errors)
                    }
                }
            }
            Err(errors) => {
                let errors = errors.into_tokens();
                quote!(#item #errors)
            }
        },
        Err(_) => no_function(item),
    }
}

/// What stands under an attribute and is no function, with a message.
fn no_function(item: TokenStream) -> TokenStream {
    match syn::parse2::<syn::Item>(item.clone()) {
        Ok(other) => {
            let message = syn::Error::new_spanned(other.to_token_stream(), "this attribute goes above a function");
            let message = message.into_compile_error();
            quote!(#item #message)
        }
        // Not Rust at all: rustc says it better.
        Err(_) => item,
    }
}

/// What is made from an energy, once the functions that it names are there; until then the question for the next one.
fn derived(energy: parse::Energy, source: &Source) -> Result<TokenStream> {
    if let Some(path) = energy.options.with.get(source.used.len()) {
        return Ok(link::ask(&energy.runtime, energy.form.attribute(), path, source));
    }
    let energy = energy.with_functions(&source.used)?;
    expand::system(&energy)
}

/// A function that energies may name, and the macro that hands it on.
pub(crate) fn energy_function(args: TokenStream, item: TokenStream) -> TokenStream {
    if let Err(errors) = parse::nesting(&quote!(#args #item)) {
        let errors = errors.into_tokens();
        return quote!(#item #errors);
    }
    let Ok(function) = syn::parse2::<syn::ItemFn>(item.clone()) else { return no_function(item) };
    let source = Source { args, item: item.clone(), used: vec![] };
    let offered = parse::energy_function(&function).and_then(|()| link::offered(&source));
    let assertions = parse::function_options(source.args).map(|options| options.outside.assertions());
    let offered = offered.unwrap_or_else(|errors| errors.into_tokens());
    let assertions = assertions.unwrap_or_default();
    quote!(#item #assertions #offered)
}

/// Goes on where [`link::ask`] stopped.
pub(crate) fn resume(input: TokenStream) -> TokenStream {
    let parser = |input: syn::parse::ParseStream<'_>| Ok((input.parse::<Ident>()?, input.parse::<Source>()?));
    let resumed = parser.parse2(input).map_err(Into::into).and_then(|(attribute, source)| {
        let Some(form) = Form::of_attribute(&attribute.to_string()) else { return link::offered(&source) };
        derived(parse::energy(form, source.args.clone(), syn::parse2(source.item.clone())?)?, &source)
    });
    resumed.unwrap_or_else(|errors| errors.into_tokens())
}

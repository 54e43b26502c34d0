//! The compiler on one screen: from the annotated function to the code that integrates it.

use crate::diagnostics::Result;
use crate::parse::{Form, Source};
use crate::{analyze, check, diff, emit, link, lower, parse, split};
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
                let derived = derived(energy, &Source { args: written, item, used: vec![] });
                let derived = derived.unwrap_or_else(|errors| errors.into_tokens());
                quote!(#function #derived)
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
    if let Some(path) = energy.with.get(source.used.len()) {
        return Ok(link::ask(&energy.runtime, energy.form.attribute(), path, source));
    }
    let energy = energy.with_functions(&source.used)?;
    match energy.form {
        Form::Hamiltonian => hamiltonian(&energy),
        Form::Contact => contact_hamiltonian(&energy),
    }
}

/// A function that energies may name, and the macro that hands it on.
pub(crate) fn energy_function(args: TokenStream, item: TokenStream) -> TokenStream {
    if let Err(errors) = parse::nesting(&quote!(#args #item)) {
        let errors = errors.into_tokens();
        return quote!(#item #errors);
    }
    let Ok(function) = syn::parse2::<syn::ItemFn>(item.clone()) else { return no_function(item) };
    let source = Source { args, item: item.clone(), used: vec![] };
    let offered = parse::energy_function(&function).and_then(|()| offered(&source));
    let assertions = parse::function_options(source.args).map(|options| options.outside.assertions());
    let offered = offered.unwrap_or_else(|errors| errors.into_tokens());
    let assertions = assertions.unwrap_or_default();
    quote!(#item #assertions #offered)
}

/// The macro of a function, once the functions that it names are there.
fn offered(source: &Source) -> Result<TokenStream> {
    let options = parse::function_options(source.args.clone())?;
    let function: syn::ItemFn = syn::parse2(source.item.clone())?;
    Ok(match options.with.get(source.used.len()) {
        Some(path) => link::ask(&options.runtime, "energy_function", path, source),
        None => link::offer(&function.sig.ident, &function.vis, source),
    })
}

/// Goes on where [`link::ask`] stopped.
pub(crate) fn resume(input: TokenStream) -> TokenStream {
    let parser = |input: syn::parse::ParseStream<'_>| Ok((input.parse::<Ident>()?, input.parse::<Source>()?));
    let resumed = parser.parse2(input).map_err(Into::into).and_then(|(attribute, source)| {
        let form = match attribute.to_string().as_str() {
            "hamiltonian" => Form::Hamiltonian,
            "contact_hamiltonian" => Form::Contact,
            _ => return offered(&source),
        };
        derived(parse::energy(form, source.args.clone(), syn::parse2(source.item.clone())?)?, &source)
    });
    resumed.unwrap_or_else(|errors| errors.into_tokens())
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

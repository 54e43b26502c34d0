//! Entry points of the attributes. The output is the user's function, followed by the generated code or by messages. [`resume`] continues an expansion whose
//! function is out already.

use crate::diagnostics::{Diagnostics, Result};
use crate::parse::{Form, Source};
use crate::{emit, expand, link, parse};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::ItemFn;
use syn::parse::Parser;

/// Expands an attribute that defines a system. The function comes first in the output, so rustc and editors always see it.
pub(crate) fn expand(form: Form, args: TokenStream, item: TokenStream) -> TokenStream {
    let energy = match function(&args, &item).and_then(|function| parse::energy(form, args.clone(), function)) {
        Ok(energy) => energy,
        Err(errors) => return with_messages(&item, errors),
    };
    let function = emit::function(&energy, item.clone());
    let has_expressions = energy.expressions().next().is_some() || energy.expressions_of_velocities().next().is_some();
    match system_or_request(energy, &Source { args, item: item.clone(), used: vec![] }) {
        Ok(system) => quote!(#function #system),
        Err(errors) => {
            // This output omits the expressions of the attribute, because rustc would report their mistakes again.
            let unused = has_expressions.then(|| quote!(#[allow(unused_variables)]));
            with_messages(&quote!(#unused #item), errors)
        }
    }
}

/// Expands `#[energy_function]`: the function, and the macro that passes its text on.
pub(crate) fn energy_function(args: TokenStream, item: TokenStream) -> TokenStream {
    let function = match function(&args, &item) {
        Ok(function) => function,
        Err(errors) => return with_messages(&item, errors),
    };
    let source = Source { args, item: item.clone(), used: vec![] };
    let offered = parse::energy_function(&function).and_then(|()| link::offered(&source));
    let offered = offered.unwrap_or_else(Diagnostics::into_tokens);
    let assertions = parse::function_options(source.args).map(|options| options.outside.assertions());
    let assertions = assertions.unwrap_or_default();
    quote!(#item #assertions #offered)
}

/// Continues an expansion that [`link::ask`] interrupted.
pub(crate) fn resume(input: TokenStream) -> TokenStream {
    let parser = |input: syn::parse::ParseStream<'_>| Ok((input.parse::<Ident>()?, input.parse::<Source>()?));
    let resumed = parser.parse2(input).map_err(Into::into).and_then(|(attribute, source)| {
        let Some(form) = Form::of_attribute(&attribute.to_string()) else { return link::offered(&source) };
        let function = syn::parse2(source.item.clone())?;
        system_or_request(parse::energy(form, source.args.clone(), function)?, &source)
    });
    resumed.unwrap_or_else(Diagnostics::into_tokens)
}

/// Parses the function under an attribute.
fn function(args: &TokenStream, item: &TokenStream) -> Result<ItemFn> {
    parse::nesting(&quote!(#args #item))?;
    syn::parse2(item.clone()).map_err(|_| match syn::parse2::<syn::Item>(item.clone()) {
        Ok(other) => syn::Error::new_spanned(other, "this attribute goes above a function").into(),
        // The item is not Rust. The message of rustc is better.
        Err(_) => Diagnostics::default(),
    })
}

fn with_messages(item: &TokenStream, errors: Diagnostics) -> TokenStream {
    let errors = errors.into_tokens();
    quote!(#item #errors)
}

/// Returns the generated code of an energy, or a request for the text of the next function in `with(…)`.
fn system_or_request(energy: parse::Energy, source: &Source) -> Result<TokenStream> {
    match energy.options.with.get(source.used.len()) {
        Some(path) => Ok(link::ask(&energy.runtime, energy.form.attribute(), path, source)),
        None => expand::system(&energy.with_functions(&source.used)?),
    }
}

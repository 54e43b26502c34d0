//! Functions under `#[energy_function]`, and the form in which macros pass them on.

use super::options::Options;
use super::{Form, Outside};
use crate::diagnostics::{Diagnostics, Result};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use std::rc::Rc;
use syn::parse::{Parse, ParseStream, Parser};
use syn::{ItemFn, Path, braced};

/// A function under an attribute, with the functions in its `with(…)` collected so far.
///
/// Its tokens are `{arguments} {function} {…} {…}`, with one further group for each collected function. Each group is a `Source` again.
pub(crate) struct Source {
    pub(crate) args: TokenStream,
    pub(crate) item: TokenStream,
    pub(crate) used: Vec<TokenStream>,
}

impl Parse for Source {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let group = |input: ParseStream<'_>| {
            let inner;
            braced!(inner in input);
            inner.parse::<TokenStream>()
        };
        let (args, item) = (group(input)?, group(input)?);
        let mut used = vec![];
        while !input.is_empty() {
            used.push(group(input)?);
        }
        Ok(Source { args, item, used })
    }
}

impl ToTokens for Source {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        let Source { args, item, used } = self;
        tokens.extend(quote!({ #args } { #item } #({ #used })*));
    }
}

/// A function under `#[energy_function]`, with the functions in its `with(…)`.
#[derive(Clone)]
pub(crate) struct Function {
    /// Path of the function in the `with(…)` of its caller. Calls use the same path.
    pub(crate) path: String,
    pub(crate) item: ItemFn,
    /// Constants and aliases of the user's module. The macro cannot see them, so the attribute of the function states them again.
    pub(crate) outside: Rc<Outside>,
    pub(crate) used: Vec<Function>,
}

/// Parses the arguments of `#[energy_function]`.
pub(crate) fn function_options(args: TokenStream) -> Result<Options> {
    Ok((|input: ParseStream<'_>| Options::parse(None, input)).parse2(args)?)
}

/// Refuses methods and async functions. Each energy that calls the function checks the rest.
pub(crate) fn energy_function(item: &ItemFn) -> Result<()> {
    let mut errors = Diagnostics::default();
    if let Some(receiver) = item.sig.receiver() {
        errors.at(receiver, "an energy function cannot have a receiver: make every quantity an argument");
    }
    if let Some(token) = &item.sig.asyncness {
        errors.at(token, "an energy function cannot be async: it is a plain function of numbers");
    }
    errors.or(())
}

/// Parses the functions in a `with(…)` from their sources. `link` has collected one source for each path, in the same order.
pub(super) fn functions(with: &[Path], sources: &[TokenStream]) -> Result<Vec<Function>> {
    with.iter().zip(sources).map(|(path, source)| function(plain_path(path), source.clone())).collect()
}

fn function(path: String, source: TokenStream) -> Result<Function> {
    let Source { args, item, used } = syn::parse2(source)?;
    let Options { with, outside, .. } = function_options(args)?;
    let mut item: ItemFn = syn::parse2(item)?;
    // An energy can serve as a function of another energy. Attributes of this crate do not change the value of their function.
    item.attrs.retain(|attribute| !is_ours(attribute.path()));
    Ok(Function { path, item, outside, used: functions(&with, &used)? })
}

/// Returns whether a path names an attribute of this crate.
fn is_ours(path: &Path) -> bool {
    let last = path.segments.last().map(|segment| segment.ident.to_string());
    last.is_some_and(|name| Form::of_attribute(&name).is_some() || name == "energy_function")
}

/// Returns a path without spaces between its tokens.
pub(crate) fn plain_path(path: &Path) -> String {
    path.to_token_stream().to_string().replace(' ', "")
}

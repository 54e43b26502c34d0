//! Functions from outside of an energy: what stands under `#[energy_function]`.

use super::options::Options;
use super::{Form, Outside};
use crate::diagnostics::{Diagnostics, Result};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use std::rc::Rc;
use syn::parse::{Parse, ParseStream, Parser};
use syn::{ItemFn, Path, braced};

/// A function under an attribute, with the functions that the attribute names, as far as they are there.
///
/// Macros hand it on as `{arguments} {function} {…} {…}`: a group for every function that is named, of the same form.
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

/// What the arguments of `#[energy_function]` say.
pub(crate) struct FunctionOptions {
    pub(crate) runtime: TokenStream,
    /// The functions that this one uses.
    pub(crate) with: Vec<Path>,
    pub(crate) outside: Rc<Outside>,
}

/// A function that an energy may call, with those that it may call.
#[derive(Clone)]
pub(crate) struct Function {
    /// The path by which it is named, and called.
    pub(crate) path: String,
    pub(crate) item: ItemFn,
    /// What its attribute repeats of its file.
    pub(crate) outside: Rc<Outside>,
    pub(crate) used: Vec<Function>,
}

/// Reads the arguments of `#[energy_function]`.
pub(crate) fn function_options(args: TokenStream) -> Result<FunctionOptions> {
    let options = (|input: ParseStream<'_>| Options::parse(None, input)).parse2(args)?;
    let Options { runtime, with, outside, .. } = options;
    Ok(FunctionOptions { runtime: super::runtime::path_or(runtime), with, outside })
}

/// Refuses what is no plain function. (The rest is looked at where it is used.)
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

/// The functions that an attribute names, from what was handed on of them.
pub(super) fn functions(with: &[Path], used: &[TokenStream]) -> Result<Vec<Function>> {
    with.iter().zip(used).map(|(path, source)| function(plain_path(path), source.clone())).collect()
}

fn function(path: String, source: TokenStream) -> Result<Function> {
    let Source { args, item, used } = syn::parse2(source)?;
    let FunctionOptions { with, outside, .. } = function_options(args)?;
    let mut item: ItemFn = syn::parse2(item)?;
    // An energy may be a part of another one.
    item.attrs.retain(|attribute| !is_ours(attribute.path()));
    Ok(Function { path, item, outside, used: functions(&with, &used)? })
}

/// Whether an attribute leaves its function as it is, and is one of these here.
fn is_ours(path: &Path) -> bool {
    let last = path.segments.last().map(|segment| segment.ident.to_string());
    last.is_some_and(|name| Form::of_attribute(&name).is_some() || name == "energy_function")
}

/// A path as one writes it.
pub(crate) fn plain_path(path: &Path) -> String {
    path.to_token_stream().to_string().replace(' ', "")
}

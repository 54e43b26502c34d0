//! Messages: collected while a stage goes on, reported together at its end.

use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use std::fmt::Display;

/// The messages of a stage.
#[derive(Debug, Default)]
pub(crate) struct Diagnostics(Vec<syn::Error>);

/// The result of a stage.
pub(crate) type Result<T> = std::result::Result<T, Diagnostics>;

impl Diagnostics {
    /// A message that points at some syntax.
    pub(crate) fn at(&mut self, syntax: &impl ToTokens, message: impl Display) {
        self.0.push(syn::Error::new_spanned(syntax, message));
    }

    /// A message that points at everything from one token to another.
    pub(crate) fn at_place(&mut self, (first, last): (Span, Span), message: impl Display) {
        let mut tokens = quote::quote_spanned!(first=> x);
        tokens.extend(quote::quote_spanned!(last=> x));
        self.at(&tokens, message);
    }

    /// A message that was made elsewhere.
    pub(crate) fn extend(&mut self, error: syn::Error) {
        self.0.extend(error);
    }

    /// How much has been said.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// `value` if nothing was said.
    pub(crate) fn or<T>(self, value: T) -> Result<T> {
        if self.0.is_empty() { Ok(value) } else { Err(self) }
    }

    /// The messages as `compile_error!`s, each once.
    pub(crate) fn into_tokens(self) -> TokenStream {
        let mut said: Vec<String> = vec![];
        let mut tokens = TokenStream::new();
        for error in self.0 {
            // Unrolled loops say the same at the same place many times.
            let key = format!("{:?}: {error}", error.span());
            if !said.contains(&key) {
                said.push(key);
                tokens.extend(error.into_compile_error());
            }
        }
        tokens
    }

    #[cfg(test)]
    pub(crate) fn messages(&self) -> Vec<String> {
        self.0.iter().map(ToString::to_string).collect()
    }
}

impl From<syn::Error> for Diagnostics {
    fn from(error: syn::Error) -> Self {
        Diagnostics(error.into_iter().collect())
    }
}

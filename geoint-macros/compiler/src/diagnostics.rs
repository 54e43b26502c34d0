//! Collects the messages of a stage. The end of the stage reports them together.

use proc_macro2::{Span, TokenStream};
use quote::ToTokens;
use std::fmt::Display;

/// Messages of a stage in the order of their reports.
#[derive(Debug, Default)]
pub(crate) struct Diagnostics(Vec<syn::Error>);

/// Result of a stage: a value, or its messages.
pub(crate) type Result<T> = std::result::Result<T, Diagnostics>;

impl Diagnostics {
    /// Adds a message that points at syntax.
    pub(crate) fn at(&mut self, syntax: &impl ToTokens, message: impl Display) {
        self.0.push(syn::Error::new_spanned(syntax, message));
    }

    /// Adds a message that points at the source between two tokens.
    pub(crate) fn at_place(&mut self, (first, last): (Span, Span), message: impl Display) {
        let mut tokens = quote::quote_spanned!(first=> x);
        tokens.extend(quote::quote_spanned!(last=> x));
        self.at(&tokens, message);
    }

    /// Adds the messages of a parser.
    pub(crate) fn extend(&mut self, error: syn::Error) {
        self.0.extend(error);
    }

    /// Returns the number of messages.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Returns `value` if there is no message.
    pub(crate) fn or<T>(self, value: T) -> Result<T> {
        if self.0.is_empty() { Ok(value) } else { Err(self) }
    }

    /// Returns the messages as `compile_error!`s without duplicates.
    pub(crate) fn into_tokens(self) -> TokenStream {
        let mut reported: Vec<String> = vec![];
        let mut tokens = TokenStream::new();
        for error in self.0 {
            // Each round of an unrolled loop reports the same message at the same position.
            let key = format!("{:?}: {error}", error.span());
            if !reported.contains(&key) {
                reported.push(key);
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

//! Lists of tokens that are quoted often.
//!
//! A `TokenStream` belongs to rustc. Each copy of it, and each quotation, asks rustc for all of its tokens. Most of the time of an
//! emission was spent in rustc. A list of tokens is quoted by a push of each token.

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::ToTokens;

/// A list of tokens.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tokens(Vec<TokenTree>);

impl Tokens {
    /// Returns `base.field`.
    pub(super) fn field(base: &str, field: &Ident) -> Tokens {
        let mut tokens = Tokens::from(base);
        tokens.0.push(Punct::new('.', Spacing::Alone).into());
        tokens.0.push(field.clone().into());
        tokens
    }

    /// Returns `self[i][j]…`.
    pub(super) fn at(mut self, indices: &[usize]) -> Tokens {
        for index in indices {
            let index = TokenTree::Literal(Literal::usize_unsuffixed(*index));
            self.0.push(Group::new(Delimiter::Bracket, index.into()).into());
        }
        self
    }

    /// Appends all tokens.
    pub(super) fn push_to(self, tokens: &mut Vec<TokenTree>) {
        tokens.extend(self.0);
    }
}

/// An identifier.
impl From<&str> for Tokens {
    fn from(word: &str) -> Tokens {
        Tokens(vec![Ident::new(word, Span::call_site()).into()])
    }
}

impl From<Vec<TokenTree>> for Tokens {
    fn from(tokens: Vec<TokenTree>) -> Tokens {
        Tokens(tokens)
    }
}

impl From<TokenStream> for Tokens {
    fn from(tokens: TokenStream) -> Tokens {
        Tokens(tokens.into_iter().collect())
    }
}

impl ToTokens for Tokens {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.extend(self.0.iter().cloned());
    }
}

/// Returns `base[i][j]…`.
pub(crate) fn element(base: impl Into<Tokens>, indices: &[usize]) -> Tokens {
    base.into().at(indices)
}

/// Returns `[of]` as one token.
pub(super) fn bracketed(of: TokenStream) -> TokenTree {
    Group::new(Delimiter::Bracket, of).into()
}

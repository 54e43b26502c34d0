//! Few tokens, which are quoted often.
//!
//! A `TokenStream` belongs to rustc, which is asked for every copy of it, and for all tokens before it where it is quoted: most of the
//! time of an emission was that. A list is quoted by pushing its tokens.

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::ToTokens;

#[derive(Clone, Debug, Default)]
pub(crate) struct Tokens(Vec<TokenTree>);

impl Tokens {
    /// `base.field`
    pub(super) fn field(base: &str, field: &Ident) -> Tokens {
        let mut tokens = Tokens::from(base);
        tokens.0.push(Punct::new('.', Spacing::Alone).into());
        tokens.0.push(field.clone().into());
        tokens
    }

    /// `self[i][j]…`
    pub(super) fn at(mut self, indices: &[usize]) -> Tokens {
        for index in indices {
            let index = TokenTree::Literal(Literal::usize_unsuffixed(*index));
            self.0.push(Group::new(Delimiter::Bracket, index.into()).into());
        }
        self
    }

    pub(super) fn push_to(self, tokens: &mut Vec<TokenTree>) {
        tokens.extend(self.0);
    }
}

/// A word.
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

/// `[of]`: one token.
pub(super) fn bracketed(of: TokenStream) -> TokenTree {
    Group::new(Delimiter::Bracket, of).into()
}

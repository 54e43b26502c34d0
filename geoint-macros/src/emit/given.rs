//! What routines are given: variables, and entries of arrays.

use proc_macro2::{Delimiter, Group, Literal, TokenStream, TokenTree};
use quote::ToTokens;

/// `base[i][j]…`
pub(crate) fn element(base: TokenStream, indices: &[usize]) -> TokenStream {
    let indices = indices.iter().map(|i| TokenTree::Literal(Literal::usize_unsuffixed(*i)));
    let indices = indices.map(|i| TokenTree::Group(Group::new(Delimiter::Bracket, i.into())));
    base.into_iter().chain(indices).collect()
}

/// What a routine is given: a variable, or an entry of an array.
pub(crate) struct Given {
    /// Entries of one array have one number.
    pub(super) array: usize,
    pub(super) base: TokenStream,
    pub(super) indices: Vec<usize>,
}

impl Given {
    pub(super) fn entry(array: usize, base: TokenStream, indices: Vec<usize>) -> Self {
        Given { array, base, indices }
    }

    pub(super) fn alone(base: TokenStream) -> Self {
        Given { array: 0, base, indices: vec![] }
    }
}

impl ToTokens for Given {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.extend(element(self.base.clone(), &self.indices));
    }
}

/// Numbers of arrays that routines are given; those of parameters follow.
pub(super) mod array {
    pub(in crate::emit) const POSITIONS: usize = 0;
    pub(in crate::emit) const MOMENTA: usize = 1;
    pub(in crate::emit) const VELOCITIES: usize = 2;
    pub(in crate::emit) const KICKS: usize = 3;
    pub(in crate::emit) const UNKNOWNS: usize = 4;
    pub(in crate::emit) const INCREMENTS: usize = 5;
    pub(in crate::emit) const PARAMETERS: usize = 6;
}

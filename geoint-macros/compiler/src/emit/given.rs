//! What routines are given: variables, and entries of arrays.

use super::tokens::Tokens;
use proc_macro2::TokenStream;
use quote::ToTokens;

/// `base[i][j]…`
pub(crate) fn element(base: impl Into<Tokens>, indices: &[usize]) -> Tokens {
    base.into().at(indices)
}

/// What a routine is given: a variable, or an entry of an array.
pub(crate) struct Given {
    /// Entries of one array have one number.
    pub(super) array: usize,
    pub(super) base: Tokens,
    pub(super) indices: Vec<usize>,
}

impl Given {
    pub(super) fn entry(array: usize, base: impl Into<Tokens>, indices: Vec<usize>) -> Self {
        Given { array, base: base.into(), indices }
    }

    pub(super) fn alone(base: impl Into<Tokens>) -> Self {
        Given { array: 0, base: base.into(), indices: vec![] }
    }

    pub(super) fn tokens(&self) -> Tokens {
        self.base.clone().at(&self.indices)
    }
}

impl ToTokens for Given {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.tokens().to_tokens(tokens);
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

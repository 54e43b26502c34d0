//! Arrays of unknowns and of coordinates.

use crate::ir::Symbol;

/// Symbols in order, and the extents of the array that holds them.
#[derive(Clone, Debug)]
pub(crate) struct Space {
    pub(crate) symbols: Vec<Symbol>,
    /// From outside in: `[5, 3]` for `[[R; 3]; 5]`.
    pub(crate) extents: Vec<usize>,
}

impl Space {
    /// Arranges unknowns in an array by their number. One array of positions has the extents `positions`, positions with momenta are two of them, and
    /// any other unknowns form a row.
    pub(crate) fn of_unknowns(symbols: Vec<Symbol>, positions: &[usize]) -> Space {
        let degrees: usize = positions.iter().product();
        let extents = match symbols.len() {
            count if count == degrees => positions.to_vec(),
            count if count == 2 * degrees => phase(positions),
            count => vec![count],
        };
        Space { symbols, extents }
    }

    /// Returns the number of symbols.
    pub(crate) fn len(&self) -> usize {
        self.symbols.len()
    }

    /// Returns the symbols with their indices.
    pub(crate) fn places(&self) -> Vec<(Symbol, Vec<usize>)> {
        self.symbols.iter().enumerate().map(|(i, symbol)| (*symbol, indices(&self.extents, i))).collect()
    }
}

/// Returns the extents of the array of positions and momenta.
pub(crate) fn phase(positions: &[usize]) -> Vec<usize> {
    [&[2], positions].concat()
}

/// Returns the indices of the `i`-th number of an array.
pub(super) fn indices(extents: &[usize], mut i: usize) -> Vec<usize> {
    let mut indices = vec![0; extents.len()];
    for (index, extent) in indices.iter_mut().zip(extents).rev() {
        *index = i % extent;
        i /= extent;
    }
    indices
}

/// An array that a routine reads in addition to coordinates and parameters.
#[derive(Clone, Debug)]
pub(crate) struct Argument {
    pub(crate) name: &'static str,
    pub(crate) space: Space,
}

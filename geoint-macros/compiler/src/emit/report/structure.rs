//! A skew matrix S of x' = S ∇H, entry by entry, in words.

use super::super::kernel::Context;
use crate::ir::{
    Graph, Id, Symbol,
    print::{Naming, Printer},
};
use std::fmt::{Result as Written, Write};

/// {xᵢ, xⱼ} for i < j, where that is not zero.
pub(super) fn brackets(text: &mut String, context: &Context<'_>, printer: &Printer<'_>, matrix: &[Vec<Id>]) -> Written {
    let name = |i: usize| context.name(Symbol::Position(i as u32));
    entries(printer.graph(), matrix)
        .into_iter()
        .try_for_each(|[i, j]| writeln!(text, "- {{{}, {}}} = {}", name(i), name(j), printer.excerpt(matrix[i][j])))
}

/// The indices i < j of all entries that are not zero.
pub(super) fn entries(graph: &Graph, matrix: &[Vec<Id>]) -> Vec<[usize; 2]> {
    let pairs = (0..matrix.len()).flat_map(|i| (i + 1..matrix.len()).map(move |j| [i, j]));
    pairs.filter(|[i, j]| !graph.is_zero(matrix[*i][*j])).collect()
}

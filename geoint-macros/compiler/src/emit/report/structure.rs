//! A skew matrix S of x' = S ∇H in words, entry by entry.

use super::Report;
use crate::ir::{Graph, Id, Symbol};

/// {xᵢ, xⱼ} for i < j, if it is not zero.
pub(super) fn brackets(report: &mut Report<'_>, matrix: &[Vec<Id>]) {
    for [i, j] in entries(report.graph(), matrix) {
        let [a, b] = [i, j].map(|i| report.named(Symbol::Position(i as u32)));
        writeln!(report, "- {{{a}, {b}}} = {}", report.excerpt(matrix[i][j]));
    }
}

/// The indices i < j of all entries that are not zero.
pub(super) fn entries(graph: &Graph, matrix: &[Vec<Id>]) -> Vec<[usize; 2]> {
    let pairs = (0..matrix.len()).flat_map(|i| (i + 1..matrix.len()).map(move |j| [i, j]));
    pairs.filter(|[i, j]| !graph.is_zero(matrix[*i][*j])).collect()
}

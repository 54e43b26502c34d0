//! Cholesky's factor of a symmetric matrix of nodes, and the equations that it solves. Zeros of the matrix cost nothing.

use crate::ir::formula::pow;
use crate::ir::{Graph, Id, Ratio};

/// The lower triangular C with C Cᵀ = M. Its diagonal is NaN or zero if M is not positive definite.
pub(super) struct Cholesky(Vec<Vec<Id>>);

impl Cholesky {
    /// Factors the matrix, whose entries above the diagonal are not read.
    pub(super) fn of(graph: &mut Graph, matrix: &[Vec<Id>]) -> Cholesky {
        let mut factor: Vec<Vec<Id>> = vec![];
        for (i, row) in matrix.iter().enumerate() {
            let mut entries: Vec<Id> = vec![];
            for j in 0..=i {
                let other = if i == j { &entries[..] } else { &factor[j][..j] };
                let known = graph.dot(&entries[..j], &other[..j]);
                let rest = graph.sub(row[j], known);
                entries.push(if i == j { graph.build(pow(rest, Ratio::HALF)) } else { graph.div(rest, factor[j][j]) });
            }
            factor.push(entries);
        }
        Cholesky(factor)
    }

    /// The diagonal entry of a row.
    pub(super) fn diagonal(&self, k: usize) -> Id {
        self.0[k][k]
    }

    /// C x.
    pub(super) fn times(&self, graph: &mut Graph, x: &[Id]) -> Vec<Id> {
        self.0.iter().map(|row| graph.dot(row, &x[..row.len()])).collect()
    }

    /// The solution y of Cᵀ y = x.
    pub(super) fn solve_transposed(&self, graph: &mut Graph, x: &[Id]) -> Vec<Id> {
        let mut solution = x.to_vec();
        for i in (0..self.0.len()).rev() {
            let column: Vec<Id> = self.0[i + 1..].iter().map(|row| row[i]).collect();
            let known = graph.dot(&column, &solution[i + 1..]);
            solution[i] = graph.build((x[i] - known) / self.0[i][i]);
        }
        solution
    }
}

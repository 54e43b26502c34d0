//! Small systems of linear equations whose matrices are nodes. Zeros of a matrix cost nothing.

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
                let other = if i == j { entries.clone() } else { factor[j][..j].to_vec() };
                let known = graph.dot(&entries[..j], &other);
                let rest = graph.sub(row[j], known);
                entries.push(if i == j { graph.build(pow(rest, Ratio::HALF)) } else { graph.div(rest, factor[j][j]) });
            }
            factor.push(entries);
        }
        Cholesky(factor)
    }

    /// C Bᵀ for the factor B of another matrix.
    pub(super) fn times_transposed(&self, graph: &mut Graph, other: &Cholesky) -> Vec<Vec<Id>> {
        let mut entry = |a: &[Id], b: &[Id]| {
            let common = a.len().min(b.len());
            graph.dot(&a[..common], &b[..common])
        };
        self.0.iter().map(|a| other.0.iter().map(|b| entry(a, b)).collect()).collect()
    }

    /// Cᵀ x.
    pub(super) fn transposed_times(&self, graph: &mut Graph, x: &[Id]) -> Vec<Id> {
        (0..x.len()).map(|i| graph.dot(&self.column(i), &x[i..])).collect()
    }

    /// The solution y of C y = x.
    pub(super) fn solve(&self, graph: &mut Graph, x: &[Id]) -> Vec<Id> {
        let mut solution: Vec<Id> = vec![];
        for (i, row) in self.0.iter().enumerate() {
            let known = graph.dot(&row[..i], &solution);
            solution.push(graph.build((x[i] - known) / row[i]));
        }
        solution
    }

    /// The solution y of Cᵀ y = x.
    pub(super) fn solve_transposed(&self, graph: &mut Graph, x: &[Id]) -> Vec<Id> {
        let mut solution = x.to_vec();
        for i in (0..x.len()).rev() {
            let column = self.column(i);
            let known = graph.dot(&column[1..], &solution[i + 1..]);
            solution[i] = graph.build((x[i] - known) / column[0]);
        }
        solution
    }

    /// The entries of a column from the diagonal downwards.
    fn column(&self, i: usize) -> Vec<Id> {
        self.0[i..].iter().map(|row| row[i]).collect()
    }
}

/// The solution x of M x = `rhs`, by elimination without exchanges of rows. It is accurate for matrices near symmetric positive definite ones.
pub(super) fn solve(graph: &mut Graph, mut matrix: Vec<Vec<Id>>, mut rhs: Vec<Id>) -> Vec<Id> {
    for k in 0..rhs.len() {
        for i in k + 1..rhs.len() {
            let factor = graph.div(matrix[i][k], matrix[k][k]);
            for j in k + 1..rhs.len() {
                matrix[i][j] = graph.build(matrix[i][j] - factor * matrix[k][j]);
            }
            rhs[i] = graph.build(rhs[i] - factor * rhs[k]);
        }
    }
    for i in (0..rhs.len()).rev() {
        let known = graph.dot(&matrix[i][i + 1..], &rhs[i + 1..]);
        rhs[i] = graph.build((rhs[i] - known) / matrix[i][i]);
    }
    rhs
}

//! Small systems of linear equations whose matrices are nodes. Zeros of a matrix cost nothing.

use crate::ir::formula::pow;
use crate::ir::{Graph, Id, Ratio};

/// M = L D Lᵀ of a symmetric M, with a diagonal D and a lower triangular L with ones on its diagonal.
pub(super) struct Factors {
    /// The entries of L before the diagonal.
    lower: Vec<Vec<Id>>,
    diagonal: Vec<Id>,
}

impl Factors {
    /// Factors the matrix, whose entries above the diagonal are not read.
    pub(super) fn of(graph: &mut Graph, matrix: &[Vec<Id>]) -> Factors {
        let (mut lower, mut diagonal): (Vec<Vec<Id>>, Vec<Id>) = (vec![], vec![]);
        for (i, row) in matrix.iter().enumerate() {
            // The entries of L D.
            let mut scaled: Vec<Id> = vec![];
            for j in 0..i {
                let known = graph.dot(&scaled, &lower[j]);
                scaled.push(graph.sub(row[j], known));
            }
            let entries: Vec<Id> = scaled.iter().zip(&diagonal).map(|(entry, d)| graph.div(*entry, *d)).collect();
            let known = graph.dot(&scaled, &entries);
            diagonal.push(graph.sub(row[i], known));
            lower.push(entries);
        }
        Factors { lower, diagonal }
    }

    /// The diagonal √(D'/D), with D' of other factors. It has no unit, so its rounding is that of any units.
    pub(super) fn ratios(&self, graph: &mut Graph, other: &Factors) -> Vec<Id> {
        let pairs = self.diagonal.iter().zip(&other.diagonal);
        pairs.map(|(d, other)| graph.build(pow(*other / *d, Ratio::HALF))).collect()
    }

    /// L D S L'ᵀ with a diagonal S, and L' of other factors.
    pub(super) fn product(&self, graph: &mut Graph, s: &[Id], other: &Factors) -> Vec<Vec<Id>> {
        let s: Vec<Id> = s.iter().zip(&self.diagonal).map(|(s, d)| graph.mul(*s, *d)).collect();
        let mut rows = vec![];
        for (i, a) in self.lower.iter().enumerate() {
            let mut row = vec![];
            for (j, b) in other.lower.iter().enumerate() {
                let mut terms = vec![];
                for k in 0..=i.min(j) {
                    let [a, b] = [(i, a), (j, b)].map(|(i, entries)| if k < i { entries[k] } else { graph.integer(1) });
                    terms.push(graph.product(&[a, s[k], b]));
                }
                row.push(graph.sum(&terms));
            }
            rows.push(row);
        }
        rows
    }

    /// Lᵀ x.
    pub(super) fn transposed_times(&self, graph: &mut Graph, x: &[Id]) -> Vec<Id> {
        (0..x.len()).map(|i| self.add_later(graph, i, x, x[i])).collect()
    }

    /// The solution y of Lᵀ y = x.
    pub(super) fn solve_transposed(&self, graph: &mut Graph, x: &[Id]) -> Vec<Id> {
        let mut solution = x.to_vec();
        for i in (0..x.len()).rev() {
            let zero = graph.zero();
            let known = self.add_later(graph, i, &solution, zero);
            solution[i] = graph.sub(solution[i], known);
        }
        solution
    }

    /// The solution y of M y = x.
    pub(super) fn solve(&self, graph: &mut Graph, x: &[Id]) -> Vec<Id> {
        let mut solution: Vec<Id> = vec![];
        for (entries, x) in self.lower.iter().zip(x) {
            let known = graph.dot(entries, &solution);
            solution.push(graph.sub(*x, known));
        }
        for (y, d) in solution.iter_mut().zip(&self.diagonal) {
            *y = graph.div(*y, *d);
        }
        self.solve_transposed(graph, &solution)
    }

    /// `start` + Σ Lₖᵢ xₖ over the rows k after i.
    fn add_later(&self, graph: &mut Graph, i: usize, x: &[Id], start: Id) -> Id {
        let later = self.lower.iter().zip(x).skip(i + 1);
        let products: Vec<Id> = later.map(|(entries, x)| graph.mul(entries[i], *x)).collect();
        graph.sum(&[&[start], &products[..]].concat())
    }
}

/// The solution x of M x = `rhs`, by elimination without exchanges of rows. It is accurate for matrices near symmetric definite ones.
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

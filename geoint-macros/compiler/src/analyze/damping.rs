//! The damping matrix C of p' = −∂H/∂q − C ∂H/∂p, or the friction M of x' = L ∇E + M ∇S, as far as it is known at compile time.

use crate::ir::{Graph, Id, Number, Ratio, Reads};

/// A damping matrix with an entry that is not zero.
#[derive(Debug)]
pub(crate) struct Damping {
    /// The name of the argument, `damping` or `friction`.
    pub(crate) name: &'static str,
    /// The rows of C.
    pub(crate) matrix: Vec<Vec<Id>>,
    /// The kinds of coordinates that entries read.
    pub(crate) reads: Reads,
    /// Whether all entries off the diagonal are zero.
    pub(crate) diagonal: bool,
    /// Whether generated code must check that C is positive semidefinite.
    pub(crate) open: bool,
    /// The reason why C is not positive semidefinite at any state, if so.
    pub(crate) flaw: Option<Flaw>,
}

/// The reason why a matrix is not a damping matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flaw {
    /// Cᵢⱼ and Cⱼᵢ are different expressions.
    NotSymmetric(usize, usize),
    /// Cᵢᵢ is a negative number.
    Negative(usize),
    /// C is a matrix of numbers that accelerates the motion in some direction.
    Indefinite,
}

impl Damping {
    /// Classifies a matrix. `None` if all entries are zero.
    pub(super) fn of(graph: &Graph, matrix: Vec<Vec<Id>>) -> Option<Damping> {
        let entries = || (0..matrix.len()).flat_map(|i| (0..matrix.len()).map(move |j| (i, j)));
        if entries().all(|(i, j)| graph.is_zero(matrix[i][j])) {
            return None;
        }
        let reads = entries().fold(Reads::default(), |reads, (i, j)| reads.or(graph.reads(matrix[i][j])));
        let diagonal = entries().all(|(i, j)| i == j || graph.is_zero(matrix[i][j]));
        let semidefinite = is_semidefinite(graph, &matrix);
        let open = !diagonal && semidefinite.is_none();
        let indefinite = (semidefinite == Some(false)).then_some(Flaw::Indefinite);
        let flaw = flaw_of_entry(graph, &matrix).or(indefinite);
        Some(Damping { name: "damping", matrix, reads, diagonal, open, flaw })
    }

    /// Returns the diagonal entries whose signs are not known.
    pub(crate) fn open_diagonal(&self, graph: &Graph) -> Vec<Id> {
        let mut entries: Vec<Id> = (0..self.matrix.len()).map(|i| self.matrix[i][i]).collect();
        entries.sort();
        entries.dedup();
        entries.retain(|entry| graph.as_number(*entry).is_none());
        entries
    }

    /// Returns all entries, row by row, if generated code must check that C is positive semidefinite.
    pub(crate) fn open_matrix(&self) -> Vec<Id> {
        if self.open { self.matrix.concat() } else { vec![] }
    }

    /// Returns whether a coefficient of row `i` is not zero.
    pub(super) fn acts_on(&self, graph: &Graph, i: u32) -> bool {
        self.matrix[i as usize].iter().any(|entry| !graph.is_zero(*entry))
    }

    /// Builds Cv.
    pub(crate) fn drag(&self, graph: &mut Graph, velocities: &[Id]) -> Vec<Id> {
        self.matrix.iter().map(|row| graph.dot(row, velocities)).collect()
    }
}

/// Finds a pair of entries that differ, or a negative entry on the diagonal.
fn flaw_of_entry(graph: &Graph, matrix: &[Vec<Id>]) -> Option<Flaw> {
    let n = matrix.len();
    let mut pairs = (0..n).flat_map(|i| (0..i).map(move |j| (j, i)));
    if let Some((i, j)) = pairs.find(|(i, j)| matrix[*i][*j] != matrix[*j][*i]) {
        return Some(Flaw::NotSymmetric(i, j));
    }
    let negative = |i: &usize| graph.as_number(matrix[*i][*i]).is_some_and(Number::is_negative);
    (0..n).find(negative).map(Flaw::Negative)
}

/// Decides exactly whether a symmetric matrix of numbers is positive semidefinite. `None` if an entry is not an exact number, or becomes too long.
/// Generated code decides other matrices at run time, up to rounding.
fn is_semidefinite(graph: &Graph, matrix: &[Vec<Id>]) -> Option<bool> {
    let number = |id: &Id| match graph.as_number(*id)? {
        Number::Exact(ratio) => Some(ratio),
        Number::Root(..) | Number::Float(_) => None,
    };
    let mut c: Vec<Vec<Ratio>> = matrix.iter().map(|row| row.iter().map(number).collect()).collect::<Option<_>>()?;
    for k in 0..c.len() {
        // The entries below a pivot of zero must be zero.
        if c[k][k] < Ratio::ZERO || c[k][k] == Ratio::ZERO && (k..c.len()).any(|i| c[i][k] != Ratio::ZERO) {
            return Some(false);
        }
        let Some(reciprocal) = c[k][k].recip() else { continue };
        for i in k + 1..c.len() {
            let factor = c[i][k].mul(reciprocal)?.neg();
            for j in k + 1..=i {
                c[i][j] = c[i][j].add(factor.mul(c[j][k])?)?;
            }
        }
    }
    Some(true)
}

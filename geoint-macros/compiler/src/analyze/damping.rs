//! Damping C of p' = −∂H/∂q − C ∂H/∂p: what is known of it before it has a value.

use crate::ir::{Graph, Id, Number, Ratio, Reads};

/// C, not all of whose entries are zero.
#[derive(Debug)]
pub(crate) struct Damping {
    /// Its rows.
    pub(crate) matrix: Vec<Vec<Id>>,
    /// What some entry reads.
    pub(crate) reads: Reads,
    /// Whether only the diagonal is not zero.
    pub(crate) diagonal: bool,
    /// Whether it has to be found out at run time if C is positive semidefinite.
    pub(crate) open: bool,
    /// Why C takes energy in no state at all, if that is so.
    pub(crate) flaw: Option<Flaw>,
}

/// What no damping has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flaw {
    /// Cᵢⱼ is not written as Cⱼᵢ is.
    NotSymmetric(usize, usize),
    /// Cᵢᵢ is a negative number.
    Negative(usize),
    /// A matrix of numbers feeds some direction.
    Indefinite,
}

impl Damping {
    /// The coefficients whose sign is not known yet.
    pub(crate) fn open_diagonal(&self, graph: &Graph) -> Vec<Id> {
        let mut entries: Vec<Id> = (0..self.matrix.len()).map(|i| self.matrix[i][i]).collect();
        entries.sort();
        entries.dedup();
        entries.retain(|entry| graph.as_number(*entry).is_none());
        entries
    }

    /// Cv.
    pub(crate) fn drag(&self, graph: &mut Graph, velocities: &[Id]) -> Vec<Id> {
        let row = |row: &Vec<Id>| {
            let terms: Vec<Id> = row.iter().zip(velocities).map(|(entry, v)| graph.mul(*entry, *v)).collect();
            graph.sum(&terms)
        };
        self.matrix.iter().map(row).collect()
    }

    /// The entries of a matrix of which it is not known yet whether it is positive semidefinite.
    pub(crate) fn open_matrix(&self) -> Vec<Id> {
        if self.open { self.matrix.iter().flatten().copied().collect() } else { vec![] }
    }
}

pub(super) fn damping(graph: &Graph, matrix: Vec<Vec<Id>>) -> Option<Damping> {
    let entries = || (0..matrix.len()).flat_map(|i| (0..matrix.len()).map(move |j| (i, j)));
    if entries().all(|(i, j)| graph.is_zero(matrix[i][j])) {
        return None;
    }
    let reads = entries().fold(Reads::default(), |reads, (i, j)| reads.or(graph.reads(matrix[i][j])));
    let diagonal = entries().all(|(i, j)| i == j || graph.is_zero(matrix[i][j]));
    let flaw = flaw(graph, &matrix);
    let open = !diagonal && definiteness(graph, &matrix).is_none();
    Some(Damping { matrix, reads, diagonal, open, flaw })
}

fn flaw(graph: &Graph, matrix: &[Vec<Id>]) -> Option<Flaw> {
    let n = matrix.len();
    let mut pairs = (0..n).flat_map(|i| (0..i).map(move |j| (j, i)));
    if let Some((i, j)) = pairs.find(|(i, j)| matrix[*i][*j] != matrix[*j][*i]) {
        return Some(Flaw::NotSymmetric(i, j));
    }
    let negative = |i: &usize| graph.as_number(matrix[*i][*i]).is_some_and(|number| number.is_negative());
    if let Some(i) = (0..n).find(negative) {
        return Some(Flaw::Negative(i));
    }
    match definiteness(graph, matrix) {
        Some(false) => Some(Flaw::Indefinite),
        _ => None,
    }
}

/// Whether a symmetric matrix of numbers is positive semidefinite, exactly; `None` if some entry is not known, or too long. (What has a
/// value at run time alone is decided there, to rounding.)
fn definiteness(graph: &Graph, matrix: &[Vec<Id>]) -> Option<bool> {
    let number = |id: &Id| match graph.as_number(*id)? {
        Number::Exact(ratio) => Some(ratio),
        Number::Root(..) | Number::Float(_) => None,
    };
    let mut c: Vec<Vec<Ratio>> = matrix.iter().map(|row| row.iter().map(number).collect()).collect::<Option<_>>()?;
    for k in 0..c.len() {
        // Below a pivot of zero there are zeros.
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

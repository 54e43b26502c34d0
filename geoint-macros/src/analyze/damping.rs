//! Damping C of p' = −∂H/∂q − C ∂H/∂p: what is known of it before it has a value.

use super::dependence::{Dependence, Reads};
use crate::ir::{Graph, Id};

/// C, not all of whose entries are zero.
#[derive(Debug)]
pub(crate) struct Damping {
    /// Its rows.
    pub(crate) matrix: Vec<Vec<Id>>,
    /// What some entry reads.
    pub(crate) reads: Reads,
    /// Whether only the diagonal is not zero.
    pub(crate) diagonal: bool,
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

pub(super) fn damping(graph: &Graph, matrix: Vec<Vec<Id>>) -> Option<Damping> {
    let dependence = Dependence::of(graph);
    let entries = || (0..matrix.len()).flat_map(|i| (0..matrix.len()).map(move |j| (i, j)));
    if entries().all(|(i, j)| graph.is_zero(matrix[i][j])) {
        return None;
    }
    let reads = entries().fold(Reads::default(), |reads, (i, j)| reads.or(dependence.reads(matrix[i][j])));
    let diagonal = entries().all(|(i, j)| i == j || graph.is_zero(matrix[i][j]));
    let flaw = flaw(graph, &matrix);
    Some(Damping { matrix, reads, diagonal, flaw })
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
    let number = |id: &Id| graph.as_number(*id).map(|number| number.to_f64());
    let numbers: Option<Vec<Vec<f64>>> = matrix.iter().map(|row| row.iter().map(number).collect()).collect();
    numbers.is_some_and(|numbers| !is_semidefinite(numbers)).then_some(Flaw::Indefinite)
}

/// Whether a symmetric matrix is positive semidefinite to rounding, by elimination, as the runtime decides it where it alone
/// knows the values.
fn is_semidefinite(mut c: Vec<Vec<f64>>) -> bool {
    let n = c.len();
    let margin = 1.0 + 8.0 * (n * n) as f64 * f64::EPSILON;
    (0..n).for_each(|k| c[k][k] *= margin);
    for k in 0..n {
        if c[k][k] < 0.0 {
            return false;
        }
        let pivot = c[k][k];
        if pivot < f64::MIN_POSITIVE && (k + 1..n).any(|i| c[i][k] != 0.0) {
            return false;
        }
        for i in k + 1..n {
            let factor = c[i][k] / pivot.max(f64::MIN_POSITIVE);
            for j in k + 1..=i {
                c[i][j] -= factor * c[j][k];
            }
        }
    }
    true
}

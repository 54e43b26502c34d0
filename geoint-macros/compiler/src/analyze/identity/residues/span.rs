//! Linear independence of vectors over the field.

use super::prime::{Element, Prime};

/// Independent vectors.
pub(in super::super) struct Span {
    prime: Prime,
    /// Each vector with the index of its pivot, the first entry that is not zero. The pivot is 1.
    rows: Vec<(usize, Vec<Element>)>,
}

impl Span {
    pub(in super::super) fn new(prime: Prime) -> Span {
        Span { prime, rows: vec![] }
    }

    /// Adds a vector, unless it depends on the others. Returns whether it was added.
    pub(in super::super) fn add(&mut self, mut row: Vec<Element>) -> bool {
        let prime = self.prime;
        for (pivot, other) in &self.rows {
            let factor = prime.negative(row[*pivot]);
            for (x, y) in row.iter_mut().zip(other) {
                *x = prime.sum(*x, prime.product(factor, *y));
            }
        }
        let Some(pivot) = row.iter().position(|x| !x.is_zero()) else { return false };
        let Some(scale) = prime.reciprocal(row[pivot]) else { return false };
        row.iter_mut().for_each(|x| *x = prime.product(*x, scale));
        self.rows.push((pivot, row));
        true
    }
}

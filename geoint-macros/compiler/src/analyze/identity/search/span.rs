//! Which combinations depend on those before: with coefficients that are functions of the parameters, and on products of linear ones.

use super::Candidate;
use crate::analyze::identity::multiplied::Powers;
use crate::analyze::identity::residues::Residues;
use crate::ir::Ratio;

/// Combinations, as vectors over candidates, at parameters that are random residues.
#[derive(Default)]
pub(super) struct Span {
    rows: Residues,
    linear: Vec<Vec<u64>>,
}

impl Span {
    /// Adds a combination, and its products with the linear ones; whether it is new.
    pub(super) fn add(&mut self, terms: &[(usize, &Powers, Ratio)], candidates: &[Candidate]) -> bool {
        let mut row = vec![0; candidates.len()];
        for (candidate, weight, coefficient) in terms {
            // Numbers that are too long for a residue are those of no other combination.
            let Some(value) = Residues::value(weight, *coefficient) else { return false };
            row[*candidate] = Residues::sum(row[*candidate], value);
        }
        if !self.rows.add(row.clone()) {
            return false;
        }
        if terms.iter().all(|(candidate, ..)| matches!(candidates[*candidate], Candidate::Linear(_))) {
            self.linear.push(row.clone());
            for other in &self.linear {
                let mut product = vec![0; candidates.len()];
                for (k, candidate) in candidates.iter().enumerate() {
                    let Candidate::Square(i, j) = *candidate else { continue };
                    // Linear candidates come first, in order.
                    product[k] = Residues::product(row[i], other[j]);
                    if i != j {
                        product[k] = Residues::sum(product[k], Residues::product(row[j], other[i]));
                    }
                }
                self.rows.add(product);
            }
        }
        true
    }
}

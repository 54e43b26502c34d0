//! Linear dependence of combinations, with functions of the parameters as coefficients, on each other and on products of linear ones.

use super::{Candidate, Unknown};
use crate::analyze::identity::multiplied::Monomial;
use crate::analyze::identity::residues::{self, Element, PRIMES, Prime, pseudorandom};
use crate::ir::Ratio;

const PRIME: Prime = PRIMES[0];

/// The known combinations as vectors of coefficients of candidates, at random values of the parameters.
pub(super) struct Span {
    rows: residues::Span,
    linear: Vec<Vec<Element>>,
}

impl Span {
    pub(super) fn new() -> Span {
        Span { rows: residues::Span::new(PRIME), linear: vec![] }
    }

    /// Adds a combination, and its products with linear ones. Returns whether it is new.
    pub(super) fn add(&mut self, combination: &[(&Unknown, Ratio)], candidates: &[Candidate]) -> bool {
        let mut row = vec![Element::ZERO; candidates.len()];
        for (unknown, coefficient) in combination {
            // A number without a residue makes the combination unusable.
            let Some(value) = value(&unknown.weight, *coefficient) else { return false };
            row[unknown.candidate] = PRIME.sum(row[unknown.candidate], value);
        }
        if !self.rows.add(row.clone()) {
            return false;
        }
        if combination.iter().all(|(unknown, _)| matches!(candidates[unknown.candidate], Candidate::Linear(_))) {
            self.linear.push(row.clone());
            for other in &self.linear {
                let mut product = vec![Element::ZERO; candidates.len()];
                for (entry, candidate) in product.iter_mut().zip(candidates) {
                    let Candidate::Square(i, j) = *candidate else { continue };
                    // The i-th candidate is the i-th coordinate.
                    *entry = PRIME.product(row[i], other[j]);
                    if i != j {
                        *entry = PRIME.sum(*entry, PRIME.product(row[j], other[i]));
                    }
                }
                self.rows.add(product);
            }
        }
        true
    }
}

/// The value of coefficient·monomial, where atoms are pseudorandom residues.
fn value(monomial: &Monomial, coefficient: Ratio) -> Option<Element> {
    monomial.iter().try_fold(PRIME.ratio(coefficient)?, |value, (atom, exponent)| {
        let power = PRIME.power(PRIME.unknown(pseudorandom(*atom as u64)), exponent.to_i64()?)?;
        Some(PRIME.product(value, power))
    })
}

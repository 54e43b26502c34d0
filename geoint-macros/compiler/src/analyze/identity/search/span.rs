//! Which conserved functions are new? A combination of candidates is new if it is outside the span of the known ones and of the products of two linear ones. The
//! coefficients of the span may be any functions of the parameters. Logarithms take no part in products.
//!
//! Dependence is decided with residues of a prime at random values of the parameters, because exact ratios of long monomials would be slow. An
//! accidental dependence only shortens the list of conserved functions.

use super::{Candidate, Unknown};
use crate::analyze::identity::multiplied::Monomial;
use crate::analyze::identity::residues::{self, Element, PRIMES, Prime, pseudorandom};
use crate::ir::Ratio;

const PRIME: Prime = PRIMES[0];

/// The known combinations as vectors of coefficients of candidates, at random values of the parameters.
pub(super) struct Span {
    rows: residues::Span,
    /// Those of the known combinations that are linear in the coordinates.
    linear: Vec<Vec<Element>>,
}

impl Span {
    pub(super) fn new() -> Span {
        Span { rows: residues::Span::new(PRIME), linear: vec![] }
    }

    /// Adds a combination, and its products with the linear combinations so far. Returns whether it is new. Linear combinations of a degree in the
    /// parameters come first, so that their products are known when others are asked.
    pub(super) fn add(&mut self, combination: &[(&Unknown, Ratio)], candidates: &[Candidate]) -> bool {
        let mut row = vec![Element::ZERO; candidates.len()];
        for (unknown, coefficient) in combination {
            // A combination with a number without a residue, or with a root of a parameter, counts as known.
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

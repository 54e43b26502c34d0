//! Vectors of residues, and whether one more depends on them.

use super::evaluate::mixed;
use super::prime::{Element, PRIMES, Prime};
use crate::analyze::identity::multiplied::Powers;
use crate::ir::Ratio;

const PRIME: Prime = PRIMES[0];

/// Independent vectors, each 1 at its pivot.
#[derive(Default)]
pub(in super::super) struct Residues(Vec<(usize, Vec<u64>)>);

impl Residues {
    /// Adds a vector, unless it depends on the others; whether it was added.
    pub(in super::super) fn add(&mut self, mut row: Vec<u64>) -> bool {
        for (pivot, other) in &self.0 {
            let factor = PRIME.negative(real(row[*pivot])).real;
            for (x, y) in row.iter_mut().zip(other) {
                *x = Residues::sum(*x, Residues::product(factor, *y));
            }
        }
        let Some(pivot) = row.iter().position(|x| *x != 0) else { return false };
        let Some(scale) = PRIME.reciprocal(real(row[pivot])) else { return false };
        row.iter_mut().for_each(|x| *x = Residues::product(*x, scale.real));
        self.0.push((pivot, row));
        true
    }

    /// coefficient·Π atomᵉ, where atoms are random residues.
    pub(in super::super) fn value(powers: &Powers, coefficient: Ratio) -> Option<u64> {
        let mut value = PRIME.ratio(coefficient)?;
        for (atom, exponent) in powers {
            let power = PRIME.power(PRIME.unknown(mixed(*atom as u64)), exponent.to_integer()?)?;
            value = PRIME.product(value, power);
        }
        Some(value.real)
    }

    pub(in super::super) fn sum(a: u64, b: u64) -> u64 {
        PRIME.sum(real(a), real(b)).real
    }

    pub(in super::super) fn product(a: u64, b: u64) -> u64 {
        PRIME.product(real(a), real(b)).real
    }
}

fn real(real: u64) -> Element {
    Element { real, imaginary: 0 }
}

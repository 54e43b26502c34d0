//! Systems of linear inequalities by Fourier–Motzkin elimination. Every monomial counts as an unknown.

use super::normal::{Monomial, Normal};
use crate::ir::Ratio;

/// sum ≥ 0, or sum > 0 if it is strict.
#[derive(Clone, Debug)]
pub(super) struct Inequality {
    pub(super) sum: Normal,
    pub(super) is_strict: bool,
}

/// Elimination stops at more inequalities than this.
const LIMIT: usize = 200;

/// Returns whether inequalities are proven to exclude each other. `false` proves nothing.
pub(super) fn are_contradictory(mut inequalities: Vec<Inequality>) -> bool {
    while inequalities.len() <= LIMIT {
        let monomial = inequalities.iter().find_map(|inequality| inequality.sum.monomials().next().cloned());
        let Some(monomial) = monomial else { return inequalities.iter().any(Inequality::fails) };
        match eliminated(&monomial, inequalities) {
            Some(rest) => inequalities = rest,
            None => return false,
        }
    }
    false
}

/// Returns the consequences that do not contain one monomial; `None` if numbers become too long.
fn eliminated(monomial: &Monomial, inequalities: Vec<Inequality>) -> Option<Vec<Inequality>> {
    let (reading, mut rest): (Vec<Inequality>, Vec<Inequality>) =
        inequalities.into_iter().partition(|inequality| inequality.sum.coefficient(monomial) != Ratio::ZERO);
    let (above, below): (Vec<Inequality>, Vec<Inequality>) =
        reading.into_iter().partition(|inequality| inequality.sum.coefficient(monomial) > Ratio::ZERO);
    for lower in &above {
        for upper in &below {
            let (up, down) = (lower.sum.coefficient(monomial), upper.sum.coefficient(monomial));
            let sum = lower.sum.scale(down.neg())?.add(up, &upper.sum)?;
            rest.push(Inequality { sum, is_strict: lower.is_strict || upper.is_strict });
        }
    }
    Some(rest)
}

impl Inequality {
    /// Returns whether an inequality between numbers is false.
    fn fails(&self) -> bool {
        let value = self.sum.as_number().unwrap_or(Ratio::ONE);
        value < Ratio::ZERO || value == Ratio::ZERO && self.is_strict
    }
}

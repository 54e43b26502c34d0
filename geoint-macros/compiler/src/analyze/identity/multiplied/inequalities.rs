//! Systems of linear inequalities by Fourier–Motzkin elimination. Every monomial counts as an unknown. A case of a selection whose conditions exclude
//! each other contains no state, and proofs skip it.

use super::normal::{Monomial, Normal};
use crate::ir::Ratio;

/// sum ≥ 0, or sum > 0 if it is strict.
#[derive(Clone, Debug)]
pub(super) struct Inequality {
    pub(super) sum: Normal,
    pub(super) is_strict: bool,
}

/// Elimination stops at more inequalities than this: each step may square their number.
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
    // A positive coefficient bounds the monomial from below.
    let (lower_bounds, upper_bounds): (Vec<Inequality>, Vec<Inequality>) =
        reading.into_iter().partition(|inequality| inequality.sum.coefficient(monomial) > Ratio::ZERO);
    for lower in &lower_bounds {
        for upper in &upper_bounds {
            let (positive, negative) = (lower.sum.coefficient(monomial), upper.sum.coefficient(monomial));
            let sum = lower.sum.scale(negative.neg())?.add(positive, &upper.sum)?;
            rest.push(Inequality { sum, is_strict: lower.is_strict || upper.is_strict });
        }
    }
    Some(rest)
}

impl Inequality {
    /// Returns whether an inequality between numbers is false.
    fn fails(&self) -> bool {
        // No monomial is left. Another sum would prove nothing, as 1 ≥ 0 does.
        let value = self.sum.as_number().unwrap_or(Ratio::ONE);
        value < Ratio::ZERO || value == Ratio::ZERO && self.is_strict
    }
}

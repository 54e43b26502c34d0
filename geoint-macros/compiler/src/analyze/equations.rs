//! Homogeneous linear equations with exact coefficients. Their solutions are the coefficients of conserved functions.

use crate::ir::Ratio;
use std::collections::BTreeMap;

/// Coefficients by the number of the unknown. Invariant: no coefficient is zero.
pub(super) type Row = BTreeMap<usize, Ratio>;

/// Linear equations in echelon form. Row i is an equation whose last unknown is i, with the coefficient 1. Thus early unknowns stay free, and a
/// solution that uses them alone is a basis vector of its own.
pub(super) struct Equations(Vec<Option<Row>>);

impl Equations {
    /// Creates an empty system.
    pub(super) fn new(unknowns: usize) -> Equations {
        Equations(vec![None; unknowns])
    }

    /// Adds the equation row·x = 0. `None` if a number is no longer exact: the system then lacks the equation and must not be solved.
    pub(super) fn add(&mut self, mut row: Row) -> Option<()> {
        while let Some((last, c)) = row.last_key_value().map(|(last, c)| (*last, *c)) {
            let Some(known) = &self.0[last] else {
                let mut solved = Row::new();
                add_multiple(&mut solved, c.recip()?, row)?;
                self.0[last] = Some(solved);
                return Some(());
            };
            add_multiple(&mut row, c.neg(), known.clone())?;
        }
        Some(())
    }

    /// Returns a basis of all solutions. The first entry of each basis vector is 1. `None` if a number is no longer exact.
    pub(super) fn solutions(&self) -> Option<Vec<Row>> {
        let free = (0..self.0.len()).filter(|unknown| self.0[*unknown].is_none());
        let basis = free.map(|free| {
            let mut solution = Row::from([(free, Ratio::ONE)]);
            for (unknown, known) in self.0.iter().enumerate().skip(free) {
                let Some(known) = known else { continue };
                let products = known.iter().filter_map(|(other, c)| Some(solution.get(other)?.mul(*c)));
                let sum = products.into_iter().try_fold(Ratio::ZERO, |sum, product| sum.add(product?))?;
                add_multiple(&mut solution, Ratio::integer(-1), [(unknown, sum)])?;
            }
            Some(solution)
        });
        basis.collect()
    }
}

/// Adds factor·other to a row. `None` if a number is no longer exact.
pub(super) fn add_multiple(
    row: &mut Row,
    factor: Ratio,
    other: impl IntoIterator<Item = (usize, Ratio)>,
) -> Option<()> {
    for (unknown, c) in other {
        let sum = row.get(&unknown).map_or(Ratio::ZERO, |c| *c).add(factor.mul(c)?)?;
        if sum == Ratio::ZERO {
            row.remove(&unknown);
        } else {
            row.insert(unknown, sum);
        }
    }
    Some(())
}

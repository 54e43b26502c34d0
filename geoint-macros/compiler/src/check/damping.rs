//! Damping that is none.

use crate::analyze::{Damping, Flaw};
use crate::diagnostics::Diagnostics;
use crate::ir::print::Printer;
use crate::parse::Energy;

/// Damping that is none.
pub(super) fn flaw_of_damping(energy: &Energy, damping: &Damping, printer: &Printer<'_>, errors: &mut Diagnostics) {
    if let Damping { matrix, flaw: Some(flaw), .. } = damping {
        let entry = |i: usize, j: usize| printer.excerpt(matrix[i][j]);
        let message = match *flaw {
            Flaw::NotSymmetric(i, j) => format!(
                "damping is a symmetric matrix, but row {i}, column {j} is {} and row {j}, column {i} is {}: write both alike",
                entry(i, j),
                entry(j, i)
            ),
            Flaw::Negative(i) => format!(
                "damping takes energy away, but the coefficient of coordinate {i} is {}: write one that is not negative",
                entry(i, i)
            ),
            Flaw::Indefinite => INDEFINITE.into(),
        };
        errors.at(&energy.options.damping.as_ref().or(energy.options.rayleigh.as_ref()), message);
    }
}

const INDEFINITE: &str = "damping takes energy away, but this matrix gives some at some velocity: write one that is positive \
                          semidefinite";

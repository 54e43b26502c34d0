//! Checks that damping takes energy from the system.

use crate::analyze::{Damping, Flaw};
use crate::compilation::Compilation;

/// Reports a damping matrix that is not symmetric or not positive semidefinite.
pub(super) fn report_damping(compilation: &mut Compilation<'_>, damping: Option<&Damping>) {
    if let Some(Damping { matrix, flaw: Some(flaw), .. }) = damping {
        let entry = |i: usize, j: usize| compilation.excerpt(matrix[i][j]);
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
        let options = &compilation.energy.options;
        compilation.diagnostics.at(&options.damping.as_ref().or(options.rayleigh.as_ref()), message);
    }
}

const INDEFINITE: &str = "damping takes energy away, but this matrix gives some at some velocity: write one that is positive \
                          semidefinite";

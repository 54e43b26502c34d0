//! Checks that damping takes energy from the system, and that friction raises its entropy.

use crate::analyze::{Damping, Flaw};
use crate::compilation::Compilation;

/// Reports a matrix of damping or friction that is not symmetric or not positive semidefinite.
pub(super) fn report_damping(compilation: &mut Compilation<'_>, damping: Option<&Damping>) {
    if let Some(Damping { name, matrix, flaw: Some(flaw), .. }) = damping {
        let entry = |i: usize, j: usize| compilation.excerpt(matrix[i][j]);
        let options = &compilation.energy.options;
        let [effect, opposite] = match options.friction {
            Some(_) => ["raises the entropy", "lowers it in some direction"],
            None => ["takes energy away", "gives some at some velocity"],
        };
        let message = match *flaw {
            Flaw::NotSymmetric(i, j) => format!(
                "{name} is a symmetric matrix, but row {i}, column {j} is {} and row {j}, column {i} is {}: write both alike",
                entry(i, j),
                entry(j, i)
            ),
            Flaw::Negative(i) => format!(
                "{name} {effect}, but the coefficient of coordinate {i} is {}: write one that is not negative",
                entry(i, i)
            ),
            Flaw::Indefinite => {
                format!("{name} {effect}, but this matrix {opposite}: write one that is positive semidefinite")
            }
        };
        let written = options.damping.as_ref().or(options.friction.as_ref()).or(options.rayleigh.as_ref());
        compilation.diagnostics.at(&written, message);
    }
}

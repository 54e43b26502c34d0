//! Reports the invariant measure that the user has stated.

use super::Report;
use crate::check::wording::proven;
use crate::derive::Measure;

/// Writes the density with its proof.
pub(super) fn report(report: &mut Report<'_>, Measure { density, proof }: &Measure) {
    let part = if report.graph().is_positive(*density) { "" } else { " where ρ > 0" };
    writeln!(report, "\nInvariant measure\n- ρ = {}: div(ρf) = 0, {}", report.formula(*density), proven(*proof, "0"));
    writeln!(report, "- the density ρ is kept by the flow{part}; steps keep it to their order");
}

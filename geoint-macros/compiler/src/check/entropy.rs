//! Checks the entropy S and the friction M of x' = L ∇E + M ∇S. Other checks look at L, as at every structure matrix, and at M, as at every damping matrix.

use super::wording::{refutation, undecided};
use crate::analyze::Identity;
use crate::compilation::Compilation;
use crate::derive::proof::Entropy;
use crate::diagnostics::Result;

/// Reports friction that is zero or has M ∇E ≠ 0, and an entropy with L ∇S ≠ 0 or one that reads time. What is not proven is reported, too.
pub(crate) fn entropy(compilation: &mut Compilation<'_>, found: Option<&Entropy>) -> Result<()> {
    let Some(found @ Entropy { place, .. }) = found else { return Ok(()) };
    let friction = &compilation.energy.options.friction;
    // A matrix of zeros counts as no friction.
    if found.friction.is_none() {
        compilation.diagnostics.at(friction, "friction is zero, so that the entropy is constant: leave out both");
    }
    if compilation.graph.reads(found.value).t {
        let message = "the entropy reads time, and would change without friction: leave `t` out of it";
        compilation.diagnostics.at_place(*place, message);
    }
    if let Err((row, verdict)) = &found.of_structure {
        let rest = remaining(compilation, verdict);
        let message = format!(
            "entropy is changed by the reversible part: row {row} of L ∇S{rest}; L ∇S = 0 is asked for, so write S in Casimirs of L"
        );
        compilation.diagnostics.at_place(*place, message);
    }
    if let Err((row, verdict)) = &found.of_friction {
        let rest = remaining(compilation, verdict);
        let message = format!(
            "friction changes the energy: row {row} of M ∇E{rest}; M ∇E = 0 is asked for, so let M return as heat what friction takes"
        );
        compilation.diagnostics.at(friction, message);
    }
    compilation.checked(())
}

/// Describes a row that is not zero, or not proven to be.
fn remaining(compilation: &Compilation<'_>, verdict: &Identity) -> String {
    let printer = compilation.printer();
    match verdict {
        Identity::Wrong(wrong) => refutation(&printer, wrong),
        _ => format!(" was not proven to be 0{}", undecided(&printer, verdict)),
    }
}

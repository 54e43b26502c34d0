//! Checks the entropy S and the friction M of x' = L ∇E + M ∇S.
//!
//! `check::structure` runs before. It checks that L is skew, and that M is symmetric and not known to be indefinite.

use super::wording::{refutation, undecided};
use crate::analyze::Identity;
use crate::compilation::Compilation;
use crate::derive::proof::Entropy;
use crate::diagnostics::Result;

/// Reports friction with M = 0 or M ∇E ≠ 0, and an entropy that reads time or has L ∇S ≠ 0. An equation M ∇E = 0 or L ∇S = 0 without a proof is an error,
/// too.
pub(crate) fn entropy(compilation: &mut Compilation<'_>, found: Option<&Entropy>) -> Result<()> {
    let Some(found @ Entropy { place, .. }) = found else { return Ok(()) };
    let friction = &compilation.energy.options.friction;
    // `None` stands for M = 0.
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

/// Describes a row that is not zero, or not proven to be zero.
fn remaining(compilation: &Compilation<'_>, verdict: &Identity) -> String {
    let printer = compilation.printer();
    match verdict {
        Identity::Wrong(wrong) => refutation(&printer, wrong),
        _ => format!(" was not proven to be 0{}", undecided(&printer, verdict)),
    }
}

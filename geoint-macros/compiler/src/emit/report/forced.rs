//! Reports H(q, p, s, t) with an action and forces.

use super::Report;
use crate::analyze::Forces;
use crate::ir::Id;

/// Reports the equations and the available methods. `drag` is ∂R/∂v of a quadratic Rayleigh function R.
pub(super) fn report(report: &mut Report<'_>, energy: Id, forces: Option<&Forces>, drag: Option<&[Id]>) {
    let applied = forces.and_then(|forces| forces.applied.as_deref());
    let friction = drag.or(forces.and_then(|forces| forces.friction.as_deref()));
    let explicit = if report.graph().reads(energy).t { " + ∂H/∂t" } else { "" };
    let (force, work) = if applied.is_some() { (" + F", " + v·F") } else { ("", "") };
    let (drag, loss) = if friction.is_some() { (" − ∂R/∂v", " − v·∂R/∂v") } else { ("", "") };
    writeln!(report, "H = {}", report.formula(energy));
    writeln!(report, "\nForces beside the energy, with v = ∂H/∂p");
    if let Some(applied) = applied {
        writeln!(report, "- F = {}", report.vector(applied));
    }
    if let Some(friction) = friction {
        let friction = report.vector(friction);
        writeln!(report, "- ∂R/∂v = {friction}; a step in which friction would feed energy is refused");
    }
    writeln!(report, "- p' = −∂H/∂q − p ∂H/∂s{force}{drag}");
    writeln!(report, "- H' = −H ∂H/∂s{explicit}{work}{loss}");
    if let Some(potential) = forces.and_then(|forces| forces.potential) {
        let potential = report.excerpt(potential);
        writeln!(report, "- F has a potential: add {potential} to L, and every contact method is there");
    }
    writeln!(
        report,
        "- no step is a contact map, and kick and drift do not exist: methods are `DOP853`, `RK4` and Taylor series"
    )
}

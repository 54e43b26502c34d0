//! Facts about H(q, p, s, t) with forces beside it, in words.

use super::Report;
use crate::analyze::Forces;
use crate::ir::Id;

/// `drag` is ∂R/∂v of a quadratic Rayleigh function R.
pub(super) fn report(report: &mut Report<'_>, energy: Id, forces: Option<&Forces>, drag: Option<&[Id]>) {
    let applied = forces.and_then(|forces| forces.applied.as_deref());
    let friction = drag.or(forces.and_then(|forces| forces.friction.as_deref()));
    let (plus, minus) = (applied.map(|_| " + F"), friction.map(|_| " − ∂R/∂v"));
    let (work, taken) = (applied.map(|_| " + v·F"), friction.map(|_| " − v·∂R/∂v"));
    let explicit = report.graph().reads(energy).t.then_some(" + ∂H/∂t");
    let all = |parts: &[Option<&str>]| parts.iter().flatten().copied().collect::<String>();
    writeln!(report, "H = {}", report.formula(energy));
    writeln!(report, "\nForces beside the energy, with v = ∂H/∂p");
    if let Some(applied) = applied {
        writeln!(report, "- F = {}", report.vector(applied));
    }
    if let Some(friction) = friction {
        writeln!(
            report,
            "- ∂R/∂v = {}; a step in which friction would feed energy is refused",
            report.vector(friction)
        );
    }
    writeln!(report, "- p' = −∂H/∂q − p ∂H/∂s{}", all(&[plus, minus]));
    writeln!(report, "- H' = −H ∂H/∂s{}", all(&[explicit, work, taken]));
    if let Some(potential) = forces.and_then(|forces| forces.potential) {
        let potential = report.excerpt(potential);
        writeln!(report, "- F has a potential: add {potential} to L, and every contact method is there");
    }
    writeln!(
        report,
        "- no step is a contact map, and kick and drift do not exist: methods are `DOP853`, `RK4` and Taylor series"
    )
}

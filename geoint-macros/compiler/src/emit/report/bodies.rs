//! Reports H(r, m, t) of rigid bodies.

use super::Report;
use crate::analyze;
use crate::derive::{Kernels, System};
use crate::parse::Role;

/// Reports the equations, the structure of T, the tensors of inertia, and the costs of kick and drift.
pub(super) fn report(report: &mut Report<'_>, found: &analyze::Bodies, system: &System) {
    let Kernels::Bodies(kernels) = &system.kernels else { return };
    let (r, m) = (report.name_of(Role::Attitude), report.name_of(Role::AngularMomentum));
    let (q, p) = (report.name_of(Role::Position), report.name_of(Role::Momentum));
    let centres = !found.streaming.is_empty();
    let (momenta, places) = if centres { (format!("{m}, {p}"), format!("{r}, {q}")) } else { (m.clone(), r.clone()) };
    writeln!(report, "H = {}", report.formula(found.energy));
    writeln!(report, "{r}' = ½ {r}⊗(0, ω), {m}' = {m} × ω + τ, ω = ∂H/∂{m}, τᵢ = −½ ({r}⊗eᵢ)·∂H/∂{r}");

    if centres {
        writeln!(report, "{q}' = ∂H/∂{p}, {p}' = −∂H/∂{q}");
    }

    writeln!(report, "\nStructure");
    writeln!(report, "- H = T({momenta}) + V({places}): kick and drift are exact flows");
    writeln!(report, "- T = {}", report.excerpt(found.kinetic));
    writeln!(report, "- V = {}", report.excerpt(found.potential));
    writeln!(report, "- T is quadratic in {m} with constant coefficients, each body by itself");
    if centres {
        writeln!(report, "- T is quadratic in {p} with constant coefficients: drifts of centres of mass are straight");
    }
    for (i, inertia) in found.inertia.iter().enumerate() {
        let body = if found.inertia.len() == 1 { String::new() } else { format!("body {i}: ") };
        let spins = inertia.constant.iter().any(|entry| !report.graph().is_zero(*entry));
        let axes = if inertia.symmetry(report.graph()).is_some() {
            "principal axes, two moments of inertia are equal: the drift is two rotations"
        } else if inertia.is_principal(report.graph()) {
            "principal axes: the tensor of inertia is diagonal"
        } else if spins {
            "a gyrostat: T has terms linear in the momentum"
        } else {
            "a full tensor of inertia"
        };
        writeln!(report, "- {body}{axes}");
    }
    report.time("H", found.autonomous);

    writeln!(report, "\nConserved by the flow, at least");
    if found.autonomous {
        writeln!(report, "- the energy");
    }
    writeln!(report, "- the length of {r}, which is 1: by drifts to rounding, and normalised once in 1024 steps");

    writeln!(report, "\nOperations");
    writeln!(report, "- kick: {}", kernels.kick.kernel.operations());
    writeln!(report, "- kick with a force gradient: {}", kernels.gradient_kick.kernel.operations());
    if kernels.turns.iter().any(|turn| turn.symmetry.is_none()) {
        writeln!(
            report,
            "- drift: Taylor series of 12 terms up to 0.1 rad, 14 up to 0.2, 18 up to 0.4, in equal parts beyond"
        );
    }
    if kernels.principal {
        writeln!(report, "- drift of `FiveRotations`: five rotations about the principal axes");
    } else {
        writeln!(report, "\nSkipped");
        writeln!(report, "- `FiveRotations`: T is not Σ mᵢ²/(2Iᵢ) of every body");
    }
}

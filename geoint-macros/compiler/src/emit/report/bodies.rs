//! What was found of H(r, m, t) of rigid bodies, in words.

use super::super::kernel::Context;
use super::counted;
use crate::analyze;
use crate::derive::Bodies;
use crate::ir::{Graph, print::Printer};
use crate::parse::Role;
use crate::schedule::Plan;
use std::fmt::Write;

/// The report.
pub(crate) fn bodies(context: &Context<'_>, graph: &Graph, found: &analyze::Bodies, derived: &Bodies<Plan>) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = sections(&mut text, context, graph, found, derived);
    text
}

fn sections(
    text: &mut String,
    context: &Context<'_>,
    graph: &Graph,
    found: &analyze::Bodies,
    derived: &Bodies<Plan>,
) -> std::fmt::Result {
    let printer = Printer::new(graph, context);
    let name_of = |role: Role| {
        let argument = context.energy.argument(role);
        argument.map(|argument| argument.name.to_string()).unwrap_or_default()
    };
    let (r, m) = (name_of(Role::Attitude), name_of(Role::AngularMomentum));
    let (q, p) = (name_of(Role::Position), name_of(Role::Momentum));
    let centres = !found.streaming.is_empty();
    let (momenta, places) = if centres { (format!("{m}, {p}"), format!("{r}, {q}")) } else { (m.clone(), r.clone()) };
    writeln!(text, "H = {}", printer.formula(found.energy))?;
    writeln!(text, "{r}' = ½ {r}⊗(0, ω), {m}' = {m} × ω + τ, ω = ∂H/∂{m}, τᵢ = −½ ({r}⊗eᵢ)·∂H/∂{r}")?;

    if centres {
        writeln!(text, "{q}' = ∂H/∂{p}, {p}' = −∂H/∂{q}")?;
    }

    writeln!(text, "\nStructure")?;
    writeln!(text, "- H = T({momenta}) + V({places}): kick and drift are exact flows")?;
    writeln!(text, "- T = {}", printer.excerpt(found.kinetic))?;
    writeln!(text, "- V = {}", printer.excerpt(found.potential))?;
    writeln!(text, "- T is quadratic in {m} with constant coefficients, each body by itself")?;
    if centres {
        writeln!(text, "- T is quadratic in {p} with constant coefficients: drifts of centres of mass are straight")?;
    }
    for (i, inertia) in found.inertia.iter().enumerate() {
        let body = if found.inertia.len() == 1 { String::new() } else { format!("body {i}: ") };
        let spins = inertia.constant.iter().any(|entry| !graph.is_zero(*entry));
        let axes = if inertia.symmetry(graph).is_some() {
            "principal axes, two moments of inertia are equal: the drift is two rotations"
        } else if inertia.is_principal(graph) {
            "principal axes: the tensor of inertia is diagonal"
        } else if spins {
            "a gyrostat: T has terms linear in the momentum"
        } else {
            "a full tensor of inertia"
        };
        writeln!(text, "- {body}{axes}")?;
    }
    let reads_time = if found.autonomous { "does not depend" } else { "depends" };
    writeln!(text, "- H {reads_time} on time")?;

    writeln!(text, "\nConserved by the flow, at least")?;
    if found.autonomous {
        writeln!(text, "- the energy")?;
    }
    writeln!(text, "- the length of {r}, which is 1: by drifts to rounding, and normalised once in 1024 steps")?;

    writeln!(text, "\nOperations")?;
    writeln!(text, "- kick: {}", counted(derived.kick.kernel.operations()))?;
    writeln!(text, "- kick with a force gradient: {}", counted(derived.gradient_kick.kernel.operations()))?;
    if derived.turns.iter().any(|turn| turn.symmetry.is_none()) {
        writeln!(
            text,
            "- drift: Taylor series of 12 terms up to 0.1 rad, 14 up to 0.2, 18 up to 0.4, in equal parts beyond"
        )?;
    }
    if derived.principal {
        writeln!(text, "- drift of `FiveRotations`: five rotations about the principal axes")?;
    } else {
        writeln!(text, "\nSkipped")?;
        writeln!(text, "- `FiveRotations`: T is not Σ mᵢ²/(2Iᵢ) of every body")?;
    }
    Ok(())
}

//! L(q, v, s, t) with velocities as unknowns: d/dt ∂L/∂v = ∂L/∂q + ∂L/∂v ∂L/∂s, s' = L.

use crate::analyze::{self, Forces};
use crate::check;
use crate::compilation::Compilation;
use crate::derive::{self, BesideVelocities, Derived, Findings, LagrangianOfVelocities};
use crate::diagnostics::Result;
use crate::ir::Id;
use crate::legendre::Legendre;
use crate::lower::Terms;

/// Derives a system. `obstacle` is the reason why there is no H.
pub(super) fn derived(
    compilation: &mut Compilation<'_>,
    terms: Terms,
    legendre: Legendre,
    obstacle: Id,
) -> Result<Derived> {
    let has_action = compilation.form.has_action();
    // With an action, forces beside L are derived from H.
    let graph = &mut compilation.graph;
    let damping = if has_action { None } else { analyze::damping(graph, terms.damping) };
    let forces = if has_action { None } else { Forces::of(graph, terms.force, terms.friction) };
    check::velocities(compilation, obstacle, damping.as_ref(), forces.as_ref())?;
    let (graph, shape) = (&mut compilation.graph, &compilation.energy.coordinates.shape);
    let action = has_action.then(|| {
        let dissipated = analyze::dissipated_by_velocities(graph, legendre.lagrangian, shape);
        BesideVelocities::Action { decay: analyze::decay(graph, legendre.lagrangian), dissipated }
    });
    let of =
        LagrangianOfVelocities { legendre: &legendre, obstacle, damping: damping.as_ref(), applied: forces.as_ref() };
    let system = derive::velocities(compilation, &of);
    let beside = action.unwrap_or(BesideVelocities::Forces { damping, forces });
    let findings = Findings::Velocities { obstacle, beside };
    Ok(Derived { system, legendre: Some(legendre), findings }.with_velocities(compilation))
}

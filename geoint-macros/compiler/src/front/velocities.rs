//! L(q, v, s, t) with velocities as unknowns: d/dt ∂L/∂v = ∂L/∂q + ∂L/∂v ∂L/∂s, s' = L.

use crate::analyze::{self, Forces};
use crate::check;
use crate::compilation::Compilation;
use crate::derive::{self, Derived, Findings};
use crate::diagnostics::Result;
use crate::ir::Id;
use crate::legendre::Legendre;
use crate::lower::Terms;

/// Derives a system without an action. `obstacle` is the reason why there is no H.
pub(super) fn derived(
    compilation: &mut Compilation<'_>,
    terms: Terms,
    legendre: Legendre,
    obstacle: Id,
) -> Result<Derived> {
    let positions = compilation.positions();
    let graph = &mut compilation.graph;
    let damping = analyze::damping(graph, terms.damping);
    let forces = Forces::of(graph, terms.force, terms.friction);
    check::velocities(compilation, obstacle, damping.as_ref(), forces.as_ref())?;
    let shape = &compilation.energy.coordinates.shape;
    let graph = &mut compilation.graph;
    let system = derive::velocities(graph, &legendre, obstacle, shape, damping.as_ref(), forces.as_ref(), &positions);
    let findings = Findings::Velocities { obstacle, damping, forces };
    Ok(Derived { system, legendre: Some(legendre), findings }.with_velocities(&positions))
}

/// Derives a system with an action. `obstacle` is the reason why there is no H.
pub(super) fn with_action(compilation: &mut Compilation<'_>, legendre: Legendre, obstacle: Id) -> Result<Derived> {
    check::velocities(compilation, obstacle, None, None)?;
    let (positions, shape) = (compilation.positions(), &compilation.energy.coordinates.shape);
    let graph = &mut compilation.graph;
    let dissipated = analyze::dissipated_by_velocities(graph, legendre.lagrangian, shape);
    let decay = analyze::decay(graph, legendre.lagrangian);
    let system = derive::herglotz(graph, &legendre, obstacle, &positions);
    let findings = Findings::Herglotz { obstacle, decay, dissipated };
    Ok(Derived { system, legendre: Some(legendre), findings }.with_velocities(&positions))
}

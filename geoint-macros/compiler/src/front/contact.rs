//! H(q, p, s, t): q' = ∂H/∂p, p' = −∂H/∂q − p ∂H/∂s, s' = p·∂H/∂p − H.

use super::constrained;
use crate::analyze::{self, Forces};
use crate::compilation::Compilation;
use crate::derive::{self, ContactEnergy, Derived, Findings, ForcedContact};
use crate::diagnostics::Result;
use crate::legendre::Legendre;
use crate::lower::Terms;
use crate::{check, diff, split};

/// Derives a system from its energy, which may be that of a Lagrangian.
pub(super) fn derived(compilation: &mut Compilation<'_>, terms: Terms, legendre: Option<Legendre>) -> Result<Derived> {
    if compilation.energy.options.is_constrained() {
        return constrained::derived(compilation, terms, legendre);
    }
    let (energy, degrees) = (terms.energy, compilation.degrees());
    let (shape, lift) = (&compilation.energy.coordinates.shape, compilation.energy.options.lift.is_some());
    let (graph, groups) = (&mut compilation.graph, terms.groups.as_deref());
    let dissipated = analyze::dissipated(graph, energy, shape).filter(|_| !lift);
    let pieces = split::pieces(graph, energy, split::Space { degrees, action: true }, groups);
    let mechanics = split::mechanics(graph, energy, degrees);
    let gradient = diff::gradient(graph, energy, degrees);
    let of = ContactEnergy {
        energy,
        gradient: &gradient,
        pieces: &pieces,
        mechanics: &mechanics,
        lift,
        legendre: legendre.as_ref(),
    };
    let system = derive::contact(compilation, &of, &terms.partial);
    check::of_action(compilation, energy, &mechanics)?;
    check::pieces(compilation, energy, groups, &pieces)?;
    // The positions of a lift q' = X(q) follow X alone.
    let measure = check::measure(compilation, &terms, &gradient.p)?;
    let findings = Findings::Contact { energy, gradient, dissipated, measure };
    Ok(Derived { system, legendre, findings }.with_velocities(compilation))
}

/// Derives a system with forces beside the energy of a Lagrangian. Its steps are no contact maps.
pub(super) fn forced(compilation: &mut Compilation<'_>, mut terms: Terms, legendre: Legendre) -> Result<Derived> {
    let graph = &mut compilation.graph;
    let damping = analyze::damping(graph, terms.damping.take());
    let forces = Forces::of(graph, terms.force.take(), terms.friction.take());
    if damping.is_none() && forces.is_none() {
        return derived(compilation, terms, Some(legendre)); // all forces are zero
    }
    check::forced_action(compilation, damping.as_ref())?;
    let energy = terms.energy;
    let ForcedContact { system, drag } =
        derive::forced_contact(compilation, energy, damping.as_ref(), forces.as_ref(), &terms.partial);
    let findings = Findings::Forced { energy, forces, drag };
    Ok(Derived { system, legendre: Some(legendre), findings }.with_velocities(compilation))
}

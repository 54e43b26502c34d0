//! H(q, p, t): q' = ∂H/∂p, p' = −∂H/∂q, with damping and other forces.

use super::constrained;
use crate::analyze::{self, Forces};
use crate::compilation::Compilation;
use crate::derive::{self, Decompositions, Derived, Findings};
use crate::diagnostics::Result;
use crate::legendre::{self, Legendre};
use crate::lower::Terms;
use crate::{check, diff, split};

/// Derives a system from its energy, which may be that of a Lagrangian.
pub(super) fn derived(compilation: &mut Compilation<'_>, terms: Terms, legendre: Option<Legendre>) -> Result<Derived> {
    if compilation.energy.options.is_constrained() {
        return constrained::derived(compilation, terms, legendre);
    }
    let (energy, degrees) = (compilation.energy, compilation.degrees());
    let graph = &mut compilation.graph;
    let structure = analyze::structure(graph, terms.energy, &energy.coordinates.shape);
    let forces = Forces::of(graph, terms.force, terms.friction);
    let structure = structure.damped(graph, terms.damping).forced(graph, forces);
    let partial = legendre::without_velocities(graph, &terms.partial);
    let groups = terms.groups.as_deref();
    let division = split::divided(graph, &structure, energy, groups);
    let pieces = split::coupled_pieces(graph, &structure, degrees, groups);
    let gradient = diff::gradient(graph, structure.energy, degrees);
    let decompositions = Decompositions { division: &division, pieces: pieces.as_ref() };
    let system = derive::canonical(compilation, &structure, &gradient, decompositions, &partial, legendre.as_ref());
    check::requests(compilation, &structure)?;
    check::division(compilation, &division)?;
    if let Some(pieces) = &pieces {
        check::pieces(compilation, structure.energy, groups, pieces)?;
    }
    let system = match &legendre {
        Some(_) => system,
        None => system.with_inverse(compilation, structure.energy),
    };
    Ok(Derived { system, legendre, findings: Findings::Canonical { structure, gradient } }.with_velocities(compilation))
}

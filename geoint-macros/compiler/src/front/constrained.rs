//! H(q, p, t) with constraints g(q) = 0: p' = −∂H/∂q − Gᵀλ with G = ∂g/∂q.

use crate::compilation::Compilation;
use crate::derive::{self, Derived, Findings};
use crate::diagnostics::Result;
use crate::ir::Id;
use crate::legendre::Legendre;
use crate::lower::Terms;
use crate::{analyze, check, diff};

pub(super) fn derived(
    compilation: &mut Compilation<'_>,
    mut terms: Terms,
    legendre: Option<Legendre>,
) -> Result<Derived> {
    let degrees = compilation.degrees();
    let (shape, damping) = (&compilation.energy.coordinates.shape, terms.damping.take());
    let graph = &mut compilation.graph;
    let structure = analyze::structure(graph, terms.energy, shape).damped(graph, damping.clone());
    check::constraints(compilation, &terms, structure.damping.as_ref())?;
    check::requests(compilation, &structure)?;
    let graph = &mut compilation.graph;
    let constraints: Vec<Id> = terms.constraints.iter().map(|(constraint, _)| *constraint).collect();
    let kept = analyze::bound(graph, terms.energy, &constraints, shape).damped(graph, damping);
    let gradient = diff::gradient(graph, structure.energy, degrees);
    let system = derive::constrained(compilation, &structure, &constraints, &gradient, &terms.partial);
    let system = match &legendre {
        Some(_) => system,
        None => system.with_inverse(compilation, structure.energy),
    };
    let findings = Findings::Constrained { structure, kept, constraints, gradient };
    Ok(Derived { system, legendre, findings }.with_velocities(compilation))
}

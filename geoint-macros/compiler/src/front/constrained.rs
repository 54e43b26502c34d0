//! H(q, p, t) with constraints A v + b = 0: p' = −∂H/∂q − Gᵀλ + Aᵀμ, with G = ∂g/∂q of constraints of positions, and A of constraints of velocities alone.

use crate::compilation::Compilation;
use crate::derive::{self, ConstrainedFindings, Derived, Findings};
use crate::diagnostics::Result;
use crate::diff::constraint::Row;
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
    let mut rows = vec![];
    for (constraint, _) in &terms.constraints {
        rows.push(Row::of_positions(graph, *constraint, degrees));
    }
    for (constraint, _) in &terms.rolling {
        rows.push(Row::of_velocities(graph, *constraint, degrees));
    }
    let kept = analyze::bound(graph, terms.energy, &rows, shape).damped(graph, damping);
    let bindings = analyze::bindings(graph, &rows);
    let gradient = diff::gradient(graph, structure.energy, degrees);
    let system = derive::constrained(compilation, &structure, &rows, &gradient, &terms.partial);
    let system = match &legendre {
        Some(_) => system,
        None => system.with_inverse(compilation, structure.energy),
    };
    let findings = ConstrainedFindings { structure, kept, rows, bindings, gradient };
    let findings = Findings::Constrained(Box::new(findings));
    Ok(Derived { system, legendre, findings }.with_velocities(compilation))
}

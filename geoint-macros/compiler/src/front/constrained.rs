//! H(q, p, t) with constraints A v + b = 0: p' = −∂H/∂q − Gᵀλ + Aᵀμ, with G = ∂g/∂q of constraints of positions, and A of constraints of velocities alone.
//!
//! H₀(q, p, t) + γ(t)·s with constraints of positions: p' = −∂H₀/∂q − γp − Gᵀλ, s' = p·∂H₀/∂p − H.

use crate::compilation::Compilation;
use crate::derive::{self, ConstrainedFindings, Derived, Findings};
use crate::diagnostics::Result;
use crate::diff::constraint::Row;
use crate::legendre::Legendre;
use crate::lower::Terms;
use crate::{analyze, check, diff, split};

pub(super) fn derived(
    compilation: &mut Compilation<'_>,
    mut terms: Terms,
    legendre: Option<Legendre>,
) -> Result<Derived> {
    let (energy, degrees) = (terms.energy, compilation.degrees());
    let action = match compilation.form.has_action() {
        true => {
            let mechanics = split::mechanics(&mut compilation.graph, energy, degrees);
            check::of_action(compilation, energy, &mechanics)?;
            Some(check::friction_of_time(compilation, energy)?)
        }
        false => None,
    };
    if let Some(action) = &action {
        terms.energy = action.energy;
    }
    let (shape, damping) = (&compilation.energy.coordinates.shape, terms.damping.take());
    let graph = &mut compilation.graph;
    let structure = analyze::structure(graph, terms.energy, shape).damped(graph, damping.clone());
    check::constraints(compilation, &terms, structure.damping.as_ref())?;
    if action.is_none() {
        check::requests(compilation, &structure)?;
    }
    let graph = &mut compilation.graph;
    let mut rows = vec![];
    for (constraint, _) in &terms.constraints {
        rows.push(Row::of_positions(graph, *constraint, degrees));
    }
    for (constraint, _) in &terms.rolling {
        rows.push(Row::of_velocities(graph, *constraint, degrees));
    }
    let mut kept = analyze::bound(graph, terms.energy, &rows, shape).damped(graph, damping);
    let bindings = analyze::bindings(graph, &rows);
    let gradient = diff::gradient(graph, structure.energy, degrees);
    let system = derive::constrained(compilation, &structure, &rows, &gradient, action, &terms.partial);
    let system = match &legendre {
        None if action.is_none() => system.with_inverse(compilation, structure.energy),
        _ => system,
    };
    let decaying = action.map(|action| {
        let graph = &mut compilation.graph;
        let reads_time = [action.decay].into_iter().chain(rows.iter().map(|row| row.written));
        let steady = structure.autonomous && !reads_time.into_iter().any(|node| graph.reads(node).t);
        (action, analyze::dissipated_on_constraints(graph, &mut kept, steady))
    });
    let findings = ConstrainedFindings { energy, structure, kept, rows, bindings, gradient, action: decaying };
    let findings = Findings::Constrained(Box::new(findings));
    Ok(Derived { system, legendre, findings }.with_velocities(compilation))
}

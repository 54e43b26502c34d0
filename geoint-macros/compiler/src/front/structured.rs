//! H(x, t) with x' = S(x) ∇H, and E(x, t) with x' = L(x) ∇E + M(x) ∇S.

use crate::compilation::Compilation;
use crate::derive::{self, Derived, Findings, Flow, Parted, Source, System, proof};
use crate::diagnostics::Result;
use crate::lower::Terms;
use crate::{analyze, check};

pub(super) fn derived(compilation: &mut Compilation<'_>, terms: Terms) -> Result<Derived> {
    let energy = terms.energy;
    let graph = &mut compilation.graph;
    let structure = proof::structure(graph, energy, &terms.structure);
    let damping = analyze::damping(graph, terms.damping);
    let entropy = terms.entropy.map(|written| proof::entropy(graph, energy, &structure.matrix, written));
    let friction = entropy.as_ref().and_then(|entropy| entropy.friction.as_ref());
    let damping = damping.as_ref().or(friction);
    check::structure(compilation, &structure, damping)?;
    check::entropy(compilation, entropy.as_ref())?;
    let Compilation { graph, names, .. } = compilation;
    let mut flow = match (&entropy, friction) {
        (Some(entropy), Some(friction)) => Flow::of_entropy(graph, energy, &structure.matrix, entropy.value, friction),
        _ => Flow::structured(graph, energy, &structure.matrix, damping),
    };
    flow.search_casimirs(graph, &structure, names);
    flow.search(graph, names); // other constants
    let parted = Parted::of_structure(energy, &structure.matrix, structure.poisson.is_ok());
    let pieces = derive::parts(graph, &flow, Some(&parted), damping); // by terms of H, and by planes
    let system = derive::flow(compilation, &flow, &terms.partial, damping);
    let findings = Findings::Flow { flow, source: Source::Structure(structure) };
    Ok(Derived { system: System { pieces, ..system }, legendre: None, findings })
}

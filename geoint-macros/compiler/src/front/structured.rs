//! H(x, t) with x' = S(x) ∇H.

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
    check::structure(compilation, &structure, damping.as_ref())?;
    let Compilation { graph, names, .. } = compilation;
    let mut flow = Flow::structured(graph, energy, &structure.matrix, damping.as_ref());
    flow.search_casimirs(graph, &structure, names);
    flow.search(graph, names); // other constants
    let parted = Parted::of_structure(energy, &structure.matrix, structure.poisson.is_ok());
    let pieces = derive::parts(graph, &flow, Some(&parted), damping.as_ref()); // by terms of H, and by planes
    let system = derive::flow(compilation, &flow, &terms.partial, damping.as_ref());
    let findings = Findings::Flow { flow, source: Source::Structure(structure) };
    Ok(Derived { system: System { pieces, ..system }, legendre: None, findings })
}

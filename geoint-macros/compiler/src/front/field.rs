//! x' = f(x, t), with integrals.

use crate::check;
use crate::compilation::Compilation;
use crate::derive::{self, Derived, FieldFindings, Findings, Flow, Parted, Source, System, proof};
use crate::diagnostics::Result;
use crate::lower::Terms;

pub(super) fn derived(compilation: &mut Compilation<'_>, terms: &Terms) -> Result<Derived> {
    let mut flow = Flow::of_field(&terms.field, compilation.energy.options.keeps.iter().zip(&terms.keeps));
    let proofs = proof::integrals(&mut compilation.graph, &flow);
    check::integrals(compilation, &terms.keeps, &proofs)?;
    let measure = check::measure(compilation, terms, &terms.field)?;
    let Compilation { graph, names, .. } = compilation;
    let liouville = derive::liouville(graph, &terms.field, &terms.partial);
    match liouville.kept() {
        Some(energy) => flow.recovered(graph, energy, names),
        None => flow.divergent = liouville.divergent(),
    }
    flow.search(graph, names); // other constants
    let parted = Parted::of_field(graph, &flow); // S, known or searched for
    let pieces = derive::parts(graph, &flow, parted.as_ref(), None);
    let system = System { pieces, ..derive::flow(compilation, &flow, &terms.partial, None) };
    let source = Source::Field(FieldFindings { proofs, measure, liouville, parted });
    Ok(Derived { system, legendre: None, findings: Findings::Flow { flow, source } })
}

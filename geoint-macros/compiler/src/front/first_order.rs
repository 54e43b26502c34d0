//! L(q, v, t) = ϑ(q)·v − H(q, t): x' = S ∇H for x = q, where S follows from the momenta ϑ.

use crate::compilation::Compilation;
use crate::derive::{self, Derived, Findings, Flow, Parted, Source, System};
use crate::diagnostics::Result;
use crate::ir::Id;
use crate::lower::Terms;
use crate::parse::Form;
use crate::{check, legendre};

pub(super) fn derived(compilation: &mut Compilation<'_>, terms: &Terms, momenta: &[Id]) -> Result<Derived> {
    compilation.form = Form::FirstOrder;
    let found = legendre::first_order(&mut compilation.graph, terms.energy, momenta, &terms.partial);
    let found = check::first_order(compilation, found)?;
    let graph = &mut compilation.graph;
    let flow = Flow::structured(graph, found.energy, &found.structure, None);
    let parted = Parted::of_structure(found.energy, &found.structure, true);
    let pieces = derive::parts(graph, &flow, Some(&parted), None); // by terms of H, and by planes
    let system = derive::flow(compilation, &flow, &found.partial, None).of_first_order(compilation, &found);
    let system = System { pieces, ..system };
    Ok(Derived { system, legendre: None, findings: Findings::Flow { flow, source: Source::Lagrangian(found) } })
}

//! H(r, m, t) of rigid bodies: r' = ½ r⊗(0, ω), m' = m × ω + τ with ω = ∂H/∂m.

use crate::compilation::Compilation;
use crate::derive::{self, Derived, Findings};
use crate::diagnostics::Result;
use crate::lower::Terms;
use crate::{analyze, check};

pub(super) fn derived(compilation: &mut Compilation<'_>, terms: &Terms) -> Result<Derived> {
    let (bodies, rows) = (compilation.energy.bodies(), compilation.degrees() / 4);
    let found = analyze::bodies(&mut compilation.graph, terms.energy, bodies, rows); // T and V, or the term in the way
    let found = check::bodies(compilation, found)?;
    let system = derive::bodies(compilation, &found, &terms.partial);
    Ok(Derived { system, legendre: None, findings: Findings::Bodies(found) })
}

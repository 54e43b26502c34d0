//! Checks angles by `atan2`: an angle whose arguments have a common factor jumps by less than a turn.

use crate::analyze::{angles, broken_at};
use crate::compilation::Compilation;
use crate::diagnostics::Result;
use crate::ir::{Id, print::Printer};
use crate::lower::Terms;
use crate::parse::Form;

/// Reports angles of an energy, of an entropy and of constraints whose arguments have a common factor. A field may jump: the proofs of its integrals check the
/// angles of each integral.
pub(crate) fn of_energy(compilation: &mut Compilation<'_>, terms: &Terms) -> Result<()> {
    if compilation.form == Form::Field {
        return Ok(());
    }
    let constraints = terms.constraints.iter().chain(&terms.rolling).map(|(constraint, _)| *constraint);
    let entropy = terms.entropy.iter().map(|entropy| entropy.value);
    let roots = [terms.energy].into_iter().chain(constraints).chain(entropy);
    let mut found: Vec<Id> = roots.flat_map(|root| angles(&compilation.graph, root)).collect();
    found.sort_unstable();
    found.dedup();
    if found.is_empty() {
        return Ok(());
    }
    // The search adds nodes to a copy, so that the numbers of later nodes, and with them the emitted code, do not depend on it.
    let graph = &mut compilation.graph.clone();
    for angle in found {
        let Some(g) = broken_at(graph, angle).first().copied() else { continue };
        let span = compilation.energy.item.sig.ident.span();
        let place = compilation.places.get(&angle).copied().unwrap_or((span, span));
        let g = Printer::new(graph, &compilation.names).excerpt(g);
        compilation.diagnostics.at_place(place, format!("both arguments of this `atan2` vanish where {g} = 0{BROKEN}"));
    }
    compilation.checked(())
}

const BROKEN: &str =
    ", and the angle jumps there by less than a turn, of which steps see nothing: take the common factor out of both";

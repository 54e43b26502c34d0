//! Angles that jump by less than a turn.

use crate::analyze::{angles, broken_at};
use crate::diagnostics::{Diagnostics, Result};
use crate::ir::{
    Id,
    print::{Naming, Printer},
};
use crate::lower::Lowered;
use crate::parse::{Energy, Form};

/// Reports the angles of an energy and of constraints whose arguments have a common factor. A field may jump; the proof of each function that
/// it keeps checks the angles of this function.
pub(crate) fn of_energy(energy: &Energy, lowered: &Lowered, names: &dyn Naming) -> Result<()> {
    let mut errors = Diagnostics::default();
    if energy.form == Form::Field {
        return errors.or(());
    }
    let constraints = lowered.constraints.iter().map(|(constraint, _)| *constraint);
    let roots = [lowered.energy].into_iter().chain(constraints);
    let mut found: Vec<Id> = roots.flat_map(|root| angles(&lowered.graph, root)).collect();
    found.sort_unstable();
    found.dedup();
    if found.is_empty() {
        return errors.or(());
    }
    // The search adds nodes. Their order must not change the code of energies without such angles.
    let graph = &mut lowered.graph.clone();
    for angle in found {
        let Some(g) = broken_at(graph, angle).first().copied() else { continue };
        let span = energy.item.sig.ident.span();
        let place = lowered.places.get(&angle).copied().unwrap_or((span, span));
        let g = Printer::new(graph, names).excerpt(g);
        errors.at_place(place, format!("both arguments of this `atan2` vanish where {g} = 0{BROKEN}"));
    }
    errors.or(())
}

const BROKEN: &str =
    ", and the angle jumps there by less than a turn, of which steps see nothing: take the common factor out of both";

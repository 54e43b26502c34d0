//! What the user asked for against what was proven.

mod angles;
mod blame;
mod constraints;
mod damping;
mod first_order;
mod lagrangian;
mod pieces;
mod proofs;
pub(crate) mod wording;

pub(crate) use angles::of_energy as angles;
pub(crate) use constraints::constraints;
pub(crate) use first_order::first_order;
pub(crate) use lagrangian::{forced_action, lagrangian, velocities};
pub(crate) use pieces::{division, pieces};
pub(crate) use proofs::{integrals, structure};

use crate::analyze::{self, Split, Structure};
use crate::diagnostics::{Diagnostics, Result};
use crate::ir::HashMap;
use crate::ir::{
    Graph, Id,
    print::{Naming, Printer},
};
use crate::lower::Place;
use crate::messages::{
    COUPLED, DAMPED, DOES_WORK, FORCED, NOT_MECHANICAL, NOT_NYSTROM, NOT_QUADRATIC, READS_ACTION, TAKES_ENERGY,
};
use crate::parse::{Energy, Requirement};
use crate::split::Mechanics;
use blame::blame;
use damping::flaw_of_damping;

/// Reports damping that is none, and every requirement that does not hold, at the term that breaks it.
pub(crate) fn requests(
    energy: &Energy,
    structure: &Structure,
    graph: &Graph,
    places: &HashMap<Id, Place>,
    names: &dyn Naming,
) -> Result<()> {
    let mut errors = Diagnostics::default();
    let printer = Printer::new(graph, names);
    if let Some(damping) = &structure.damping {
        flaw_of_damping(energy, damping, &printer, &mut errors);
    }
    for (requirement, span) in
        energy.options.requirements.iter().filter(|(requirement, _)| !requirement.is_of_lagrangian())
    {
        if !structure.conservative() {
            let why = match (requirement, structure.damping.is_some()) {
                (Requirement::Conservative, true) => TAKES_ENERGY,
                (Requirement::Conservative, false) => DOES_WORK,
                (_, true) => DAMPED,
                (_, false) => FORCED,
            };
            errors.at_place((*span, *span), why);
            continue;
        }
        let witness = match (requirement, &structure.split) {
            (Requirement::Separable | Requirement::QuadraticKinetic, Split::Coupled(term)) => Some((*term, COUPLED)),
            (Requirement::QuadraticKinetic, Split::Separable(parts)) => {
                parts.not_quadratic.map(|term| (term, NOT_QUADRATIC))
            }
            _ => None,
        };
        if let Some((term, why)) = witness {
            blame((term, *span), why, &printer, places, &mut errors);
        }
    }
    errors.or(())
}

/// The same of an energy H(q, p, s, t).
pub(crate) fn of_action(
    energy: &Energy,
    (root, mechanics): (Id, &std::result::Result<Mechanics, Id>),
    graph: &Graph,
    places: &HashMap<Id, Place>,
    names: &dyn Naming,
) -> Result<()> {
    let mut errors = Diagnostics::default();
    let printer = Printer::new(graph, names);
    for (requirement, span) in &energy.options.requirements {
        let witness = match (requirement, mechanics) {
            (Requirement::Conservative, _) => graph.reads(root).s.then_some((root, READS_ACTION)),
            (Requirement::Separable | Requirement::QuadraticKinetic, Err(term)) => Some((*term, NOT_MECHANICAL)),
            (Requirement::QuadraticKinetic, Ok(mechanics)) => {
                mechanics.gradient_kick.as_ref().err().map(|term| (*term, NOT_NYSTROM))
            }
            _ => None,
        };
        if let Some((term, why)) = witness {
            blame((term, *span), why, &printer, places, &mut errors);
        }
    }
    errors.or(())
}

/// Reports the term by which an energy is not that of rigid bodies.
pub(crate) fn bodies(
    energy: &Energy,
    found: std::result::Result<analyze::Bodies, (Id, &'static str)>,
    graph: &Graph,
    places: &HashMap<Id, Place>,
    names: &dyn Naming,
) -> Result<analyze::Bodies> {
    found.map_err(|(term, why)| {
        let mut errors = Diagnostics::default();
        let span = energy.item.sig.ident.span();
        blame((term, span), why, &Printer::new(graph, names), places, &mut errors);
        errors
    })
}

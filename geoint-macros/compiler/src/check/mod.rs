//! Compares the user's requests with the proven facts, and reports contradictions at the source position of a term.

mod angles;
mod constraints;
mod damping;
mod entropy;
mod first_order;
mod lagrangian;
mod measure;
mod pieces;
mod proofs;
pub(crate) mod wording;

pub(crate) use angles::of_energy as angles;
pub(crate) use constraints::{constraints, friction_of_time};
pub(crate) use entropy::entropy;
pub(crate) use first_order::first_order;
pub(crate) use lagrangian::{forced_action, lagrangian, velocities};
pub(crate) use measure::measure;
pub(crate) use pieces::{division, pieces};
pub(crate) use proofs::{integrals, structure};

use crate::analyze::{self, Split, Structure};
use crate::compilation::Compilation;
use crate::diagnostics::Result;
use crate::ir::Id;
use crate::messages::{
    COUPLED, DAMPED, DOES_WORK, FORCED, NOT_MECHANICAL, NOT_NYSTROM, NOT_QUADRATIC, READS_ACTION, TAKES_ENERGY,
};
use crate::parse::{Energy, Requirement, Role};
use crate::split::Mechanics;
use damping::report_damping;
use proc_macro2::Span;

/// Returns the requirements on the energy with their source positions, without the requirements on a Lagrangian.
fn required(energy: &Energy) -> impl Iterator<Item = (Requirement, Span)> + '_ {
    energy.options.requirements.iter().copied().filter(|(requirement, _)| !requirement.is_of_lagrangian())
}

/// Returns the source position of the argument for velocities, or of the function's name.
fn velocity(energy: &Energy) -> Span {
    energy.argument(Role::Velocity).map_or(&energy.item.sig.ident, |argument| &argument.name).span()
}

/// Reports a compound term at its source position, or at `span`. Symbols and numbers are reported at `span`.
fn blame_written(compilation: &mut Compilation<'_>, term: Id, span: Span, why: &str) {
    let place = compilation.written(term).unwrap_or((span, span));
    let message = format!("{why}: {}", compilation.excerpt(term));
    compilation.diagnostics.at_place(place, message);
}

/// Reports damping that feeds energy, and every violated requirement at the violating term.
pub(crate) fn requests(compilation: &mut Compilation<'_>, structure: &Structure) -> Result<()> {
    report_damping(compilation, structure.damping.as_ref());
    for (requirement, span) in required(compilation.energy) {
        if !structure.conservative() {
            let why = match (requirement, structure.damping.is_some()) {
                (Requirement::Conservative, true) => TAKES_ENERGY,
                (Requirement::Conservative, false) => DOES_WORK,
                (_, true) => DAMPED,
                (_, false) => FORCED,
            };
            compilation.report_at(span, why);
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
            compilation.blame(term, span, why);
        }
    }
    compilation.checked(())
}

/// Reports every violated requirement on an energy H(q, p, s, t) at the violating term. `mechanics` is H = T + g·s + V, or a term that prevents it.
pub(crate) fn of_action(
    compilation: &mut Compilation<'_>,
    root: Id,
    mechanics: &std::result::Result<Mechanics, Id>,
) -> Result<()> {
    for (requirement, span) in &compilation.energy.options.requirements {
        let witness = match (requirement, mechanics) {
            (Requirement::Conservative, _) => compilation.graph.reads(root).s.then_some((root, READS_ACTION)),
            (Requirement::Separable | Requirement::QuadraticKinetic, Err(term)) => Some((*term, NOT_MECHANICAL)),
            (Requirement::QuadraticKinetic, Ok(mechanics)) => {
                mechanics.gradient_kick.as_ref().err().map(|term| (*term, NOT_NYSTROM))
            }
            _ => None,
        };
        if let Some((term, why)) = witness {
            compilation.blame(term, *span, why);
        }
    }
    compilation.checked(())
}

/// Reports the term that prevents the form of an energy of rigid bodies.
pub(crate) fn bodies(
    compilation: &mut Compilation<'_>,
    found: std::result::Result<analyze::Bodies, (Id, &'static str)>,
) -> Result<analyze::Bodies> {
    found.map_err(|(term, why)| {
        let span = compilation.energy.item.sig.ident.span();
        compilation.blame(term, span, why);
        std::mem::take(&mut compilation.diagnostics)
    })
}

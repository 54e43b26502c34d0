//! What was found of a contact Hamiltonian, in words.

use super::super::kernel::Context;
use super::super::report::counted;
use crate::ir::{Graph, Id, print::Printer};
use crate::schedule::Operations;
use crate::split::{Clock, Pieces};
use std::fmt::Write;

pub(super) fn report(
    context: &Context<'_>,
    graph: &Graph,
    energy: Id,
    found: &Pieces,
    costs: &[Operations],
    steps: &[(&'static str, Operations)],
) -> String {
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = sections(&mut text, context, graph, energy, found, costs)
        .and_then(|()| implicit(&mut text, context.energy.degrees(), steps));
    text
}

fn sections(
    text: &mut String,
    context: &Context<'_>,
    graph: &Graph,
    energy: Id,
    found: &Pieces,
    costs: &[Operations],
) -> std::fmt::Result {
    let printer = Printer::new(graph, |symbol| context.user_name(symbol));
    writeln!(text, "H = {}", printer.formula(energy))?;
    writeln!(text, "\nPieces with flows in closed form, in the order of half a step")?;
    match found {
        Ok(pieces) => {
            for (piece, cost) in pieces.iter().zip(costs) {
                writeln!(text, "- {}", printer.excerpt(piece.energy))?;
                writeln!(text, "  {}: {} ({})", piece.rule.name, piece.rule.family, piece.rule.source)?;
                let clock = match piece.clock {
                    Clock::Own => "exact in time",
                    Clock::Stage => "time frozen in the middle of a step",
                };
                writeln!(text, "  {clock}; {}", counted(*cost))?;
            }
        }
        Err(term) => writeln!(text, "- none: no rule knows the flow of {}", printer.excerpt(*term))?,
    }
    Ok(())
}

fn implicit(text: &mut String, degrees: u32, steps: &[(&'static str, Operations)]) -> std::fmt::Result {
    writeln!(text, "\nImplicit steps, for the increments of all positions, momenta and the action")?;
    for (method, cost) in steps {
        writeln!(text, "- `{method}`, unknowns {}: {} an iteration", 2 * degrees + 1, counted(*cost))?;
    }
    Ok(())
}

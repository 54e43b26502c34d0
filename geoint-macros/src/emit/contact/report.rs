//! What was found of a contact Hamiltonian, in words.

use super::super::kernel::Context;
use super::super::report::counted;
use crate::analyze;
use crate::ir::{Graph, Id, Symbol, print::Printer};
use crate::schedule::Operations;
use crate::split::{Clock, Mechanics, Pieces};
use std::fmt::{Result as Written, Write};

/// What there is to report.
pub(super) struct Facts<'a> {
    pub(super) energy: Id,
    /// ∂H/∂s.
    pub(super) decay: Id,
    pub(super) pieces: &'a Pieces,
    pub(super) mechanics: &'a Result<Mechanics, Id>,
    /// What the flows of pieces cost.
    pub(super) costs: &'a [Operations],
    /// Implicit methods, and what an iteration costs.
    pub(super) steps: &'a [(&'static str, Operations)],
}

pub(super) fn report(context: &Context<'_>, graph: &Graph, facts: &Facts<'_>) -> String {
    let mut text = String::new();
    let printer = Printer::new(graph, |symbol| context.user_name(symbol));
    // Writing to a string cannot fail.
    let _ = structure(&mut text, &printer, graph, facts)
        .and_then(|()| pieces(&mut text, &printer, facts))
        .and_then(|()| implicit(&mut text, context.energy.degrees(), facts.steps));
    text
}

fn structure<F: Fn(Symbol) -> String>(
    text: &mut String,
    printer: &Printer<'_, F>,
    graph: &Graph,
    facts: &Facts<'_>,
) -> Written {
    writeln!(text, "H = {}", printer.formula(facts.energy))?;
    writeln!(text, "\nStructure")?;
    let reads = analyze::reads(graph, facts.decay);
    let explicit = if analyze::reads(graph, facts.energy).t { " + ∂H/∂t" } else { "" };
    match graph.is_zero(facts.decay) {
        true => {
            writeln!(text, "- ∂H/∂s = 0: nothing is lost, H' = {}", if explicit.is_empty() { "0" } else { "∂H/∂t" })?
        }
        false => writeln!(text, "- ∂H/∂s = {}, and H' = −H ∂H/∂s{explicit}", printer.excerpt(facts.decay))?,
    }
    match reads.state() {
        true => writeln!(text, "- s acts back on positions or momenta")?,
        false => writeln!(text, "- positions and momenta move without s: `without_action` leaves it out")?,
    }
    match facts.mechanics {
        Ok(Mechanics { gradient_kick: Ok(_), .. }) => {
            writeln!(text, "- T + g·s + V with quadratic T: kick and drift exist, and all tables have their order")
        }
        Ok(Mechanics { kick, free_kick, .. }) if kick != free_kick => {
            writeln!(
                text,
                "- T + g·s + V: kick and drift exist, with the damping in the kick, because T is no quadratic form; tables of \
                 Runge–Kutta–Nyström type need one"
            )
        }
        Ok(Mechanics { gradient_kick: Err(term), .. }) => {
            let term = printer.excerpt(*term);
            writeln!(
                text,
                "- T + g·s + V: kick and drift exist; tables of Runge–Kutta–Nyström type would lose their order by {term}"
            )
        }
        Err(term) => {
            writeln!(text, "- not T + g·s + V, so that kick and drift do not exist: {}", printer.excerpt(*term))
        }
    }
}

fn pieces<F: Fn(Symbol) -> String>(text: &mut String, printer: &Printer<'_, F>, facts: &Facts<'_>) -> Written {
    writeln!(text, "\nPieces with flows in closed form, in the order of half a step")?;
    match facts.pieces {
        Ok(pieces) => pieces.iter().zip(facts.costs).try_for_each(|(piece, cost)| {
            writeln!(text, "- {}", printer.excerpt(piece.energy))?;
            writeln!(text, "  {}: {} ({})", piece.rule.name, piece.rule.family, piece.rule.source)?;
            let clock = match piece.clock {
                Clock::Own => "exact in time",
                Clock::Stage => "time frozen in the middle of a step",
            };
            writeln!(text, "  {clock}; {}", counted(*cost))
        }),
        Err(term) => writeln!(text, "- none: no rule knows the flow of {}", printer.excerpt(*term)),
    }
}

fn implicit(text: &mut String, degrees: u32, steps: &[(&'static str, Operations)]) -> Written {
    writeln!(text, "\nImplicit steps, for the increments of all positions, momenta and the action")?;
    for (method, cost) in steps {
        writeln!(text, "- `{method}`, unknowns {}: {} an iteration", 2 * degrees + 1, counted(*cost))?;
    }
    if steps.is_empty() {
        writeln!(text, "- none: the momenta of a lift are not followed")?;
    }
    Ok(())
}

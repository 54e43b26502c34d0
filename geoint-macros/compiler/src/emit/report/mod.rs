//! The facts about a system in words: the text of `REPORT` and of the docs of the generated struct.

mod bodies;
mod canonical;
mod constraints;
mod contact;
mod field;
mod flow;
mod forced;
mod friction;
mod lagrangian;
mod pieces;
mod structure;
mod velocities;

use crate::compilation::Compilation;
use crate::derive::{Derived, Findings, System};
use crate::ir::{Graph, Id, Symbol, print::Printer};
use crate::parse::{Form, Role};
use crate::schedule::Operations;
use std::fmt;

/// A text that grows line by line.
struct Report<'a> {
    text: String,
    compilation: &'a Compilation<'a>,
    printer: Printer<'a>,
}

impl<'a> Report<'a> {
    /// Target of `write!` and `writeln!`. Writing to a string cannot fail.
    fn write_fmt(&mut self, line: fmt::Arguments<'_>) {
        // A `String` never returns an error.
        let _ = fmt::Write::write_fmt(&mut self.text, line);
    }

    fn graph(&self) -> &'a Graph {
        &self.compilation.graph
    }

    /// Returns the whole formula of a node.
    fn formula(&self, id: Id) -> String {
        self.printer.formula(id)
    }

    /// Returns the formula of a node, cut to the length of a message.
    fn excerpt(&self, id: Id) -> String {
        self.printer.excerpt(id)
    }

    /// Returns `[a, b]` with the formulas of nodes.
    fn vector(&self, entries: &[Id]) -> String {
        let entries: Vec<String> = entries.iter().map(|id| self.excerpt(*id)).collect();
        format!("[{}]", entries.join(", "))
    }

    /// Returns the user's name of a symbol.
    fn named(&self, symbol: Symbol) -> String {
        self.printer.named(symbol)
    }

    /// Returns the user's name of an argument.
    fn name_of(&self, role: Role) -> String {
        self.compilation.names.of(role)
    }
}

/// Writes the report of a system.
pub(super) fn report(compilation: &Compilation<'_>, derived: &Derived) -> String {
    let mut report = Report { text: String::new(), compilation, printer: compilation.printer() };
    let Derived { legendre, findings, system } = derived;
    if let Some(legendre) = legendre {
        lagrangian::report(&mut report, legendre);
    }
    match findings {
        Findings::Canonical { structure, gradient } => canonical::report(&mut report, structure, gradient, system),
        Findings::Constrained { structure, kept, constraints, gradient } => {
            constraints::equations(&mut report, structure, constraints, gradient);
            constraints::conserved(&mut report, kept);
            constraints::steps(&mut report, structure, system);
        }
        Findings::Contact { energy, gradient, dissipated } => {
            contact::report(&mut report, *energy, gradient, dissipated.as_ref(), system);
        }
        Findings::Forced { energy, forces, drag } => {
            forced::report(&mut report, *energy, forces.as_ref(), drag.as_deref());
        }
        Findings::Velocities { obstacle, beside } => {
            if let Some(legendre) = legendre {
                velocities::report(&mut report, legendre, *obstacle, beside, system);
            }
        }
        Findings::Flow { flow, source } => flow::report(&mut report, flow, source, system),
        Findings::Bodies(found) => bodies::report(&mut report, found, system),
    }
    jumps(&mut report, system);
    turns(&mut report, system);
    report.text
}

/// Reports the condition where the energy may jump. Most steps use derivatives only, and end there.
fn jumps(report: &mut Report<'_>, system: &System) {
    let has_energy = !report.compilation.form.is_flow() || system.value.is_some();
    if let Some([a, b]) = system.domain.jumps.as_ref().filter(|_| has_energy).and_then(|jumps| jumps.edge) {
        let [a, b] = [a, b].map(|id| report.excerpt(id));
        writeln!(
            report,
            "\nJumps\n- H may jump where {a} = {b}: methods that keep the energy take it along, and all other steps end there"
        );
    }
}

/// Reports terms that jump where an angle by `atan2` comes round. A field reports them beside each function that it keeps.
fn turns(report: &mut Report<'_>, system: &System) {
    let turning = &system.domain.turning;
    if turning.is_empty() || report.compilation.form == Form::Field {
        return;
    }
    writeln!(report, "\nTurns");
    for term in turning {
        writeln!(
            report,
            "- {}: the term jumps where the angle by `atan2` comes round, by 2π times the factor of the angle",
            report.excerpt(*term)
        );
    }
}

/// Returns a count of operations in words.
fn counted(operations: Operations) -> String {
    let Operations { arithmetic, divisions, calls } = operations;
    let kinds = [("sums and products", arithmetic), ("divisions and roots", divisions), ("functions", calls)];
    let parts: Vec<String> =
        kinds.iter().filter(|(_, count)| *count > 0).map(|(kind, count)| format!("{kind} {count}")).collect();
    if parts.is_empty() { "nothing".into() } else { parts.join(", ") }
}

/// Returns the plural ending of a noun.
fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

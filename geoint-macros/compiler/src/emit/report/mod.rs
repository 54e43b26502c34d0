//! Writes the facts about a system: the text of `REPORT` and of the documentation of the generated struct.

mod bodies;
mod canonical;
mod constraints;
mod contact;
mod entropy;
mod field;
mod flow;
mod forced;
mod friction;
mod lagrangian;
mod measure;
mod pieces;
mod structure;
mod velocities;

use crate::analyze::Conserved;
use crate::check::wording::commas;
use crate::compilation::Compilation;
use crate::derive::{Derived, Findings, MOST_UNKNOWNS, System};
use crate::ir::{Graph, Id, Symbol, print::Printer};
use crate::parse::{Form, Role};
use crate::schedule::Operations;
use std::fmt;

/// A report under construction.
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

    /// Returns `a, b` with the formulas of nodes.
    fn excerpts(&self, ids: &[Id]) -> String {
        commas(ids.iter().map(|id| self.excerpt(*id)))
    }

    /// Returns `[a, b]` with the formulas of nodes.
    fn vector(&self, entries: &[Id]) -> String {
        format!("[{}]", self.excerpts(entries))
    }

    /// Returns the user's name of a symbol.
    fn named(&self, symbol: Symbol) -> String {
        self.printer.named(symbol)
    }

    /// Returns `a, b` with the user's names of coordinates.
    fn names(&self, kind: fn(u32) -> Symbol, coordinates: &[u32]) -> String {
        commas(coordinates.iter().map(|i| self.named(kind(*i))))
    }

    /// Returns the user's name of an argument.
    fn name_of(&self, role: Role) -> String {
        self.compilation.names.of(role)
    }

    /// Returns the line of a conserved momentum.
    fn momentum(&self, momentum: &Conserved) -> String {
        format!("{}: {}", momentum.name, self.excerpt(momentum.value))
    }

    /// Returns the line of a momentum whose coordinate `i` does not occur in `function`.
    fn cyclic(&self, function: &str, i: u32) -> String {
        let [q, p] = [Symbol::Position(i), Symbol::Momentum(i)].map(|symbol| self.named(symbol));
        format!("{p}: {function} does not read {q}")
    }

    /// Writes the partial derivatives of a function by one kind of coordinates.
    fn derivatives(&mut self, function: &str, kind: fn(u32) -> Symbol, slopes: &[Id], text: fn(&Self, Id) -> String) {
        for (i, slope) in (0..).zip(slopes) {
            writeln!(self, "∂{function}/∂{} = {}", self.named(kind(i)), text(self, *slope));
        }
    }

    /// Writes whether a function depends on time.
    fn time(&mut self, function: &str, autonomous: bool) {
        writeln!(self, "- {function} {} on time", if autonomous { "does not depend" } else { "depends" });
    }

    /// Writes a list of conserved functions.
    fn conserved(&mut self, functions: &[String]) {
        functions.iter().for_each(|function| writeln!(self, "- {function}"));
        if functions.is_empty() {
            writeln!(self, "- nothing that was found");
        }
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
        Findings::Constrained(findings) => constraints::report(&mut report, findings, system),
        Findings::Contact { energy, gradient, dissipated, measure: invariant } => {
            contact::report(&mut report, *energy, gradient, dissipated.as_ref(), system);
            invariant.iter().for_each(|invariant| measure::report(&mut report, invariant));
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

/// Reports the condition at which the energy may jump. Most steps use derivatives only, and end there.
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

/// Reports terms that jump after a full turn of an angle by `atan2`. A field reports them beside each of its integrals.
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

/// Counts operations by kind: "sums and products 3, functions 1".
impl fmt::Display for Operations {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Operations { arithmetic, divisions, calls } = *self;
        let kinds = [("sums and products", arithmetic), ("divisions and roots", divisions), ("functions", calls)];
        let counts =
            commas(kinds.iter().filter(|(_, count)| *count > 0).map(|(kind, count)| format!("{kind} {count}")));
        formatter.write_str(if counts.is_empty() { "nothing" } else { &counts })
    }
}

/// Returns the solver of an implicit step by its number of unknowns.
fn solver(unknowns: usize) -> String {
    match unknowns {
        1 => "Newton's iteration for one number".into(),
        2..=MOST_UNKNOWNS => "Newton's iteration with elimination".into(),
        _ => format!(
            "the fixed point while it attracts, Newton's iteration elsewhere: measured to be faster beyond {MOST_UNKNOWNS}"
        ),
    }
}

/// Returns the plural ending of a noun.
fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

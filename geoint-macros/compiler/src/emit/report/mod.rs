//! What was found, in words: the text behind `REPORT` and the docs of the generated struct.

mod bodies;
mod canonical;
mod constraints;
mod contact;
mod forced;
mod pieces;
mod structure;
mod field;
mod flow;
mod lagrangian;

use super::kernel::Context;
use crate::derive::Jumps;
use crate::ir::{Graph, Id, print::Printer};
use crate::schedule::{Operations, Plan};
pub(crate) use bodies::bodies;
pub(crate) use canonical::canonical;
pub(crate) use constraints::constraints;
pub(crate) use contact::contact;
pub(crate) use field::OfField;
pub(crate) use flow::{Source, flow};
pub(crate) use forced::forced;
pub(crate) use lagrangian::{herglotz, lagrangian, velocities};

/// Where the energy was not proven not to jump: most steps know its derivatives alone, and end there.
pub(crate) fn jumps(context: &Context<'_>, graph: &Graph, jumps: &Jumps<Plan>) -> String {
    let printer = Printer::new(graph, context);
    jumps.edge.map_or_else(String::new, |[a, b]| {
        format!(
            "\nJumps\n- H may jump where {} = {}: methods that keep the energy take it along, and all other steps end there\n",
            printer.excerpt(a),
            printer.excerpt(b)
        )
    })
}

/// Terms that jump where an angle comes round.
pub(crate) fn turns(context: &Context<'_>, graph: &Graph, turning: &[Id]) -> String {
    let printer = Printer::new(graph, context);
    let lines = turning.iter().map(|term| {
        format!(
            "- {}: the term jumps where the angle by `atan2` comes round, by 2π times the factor of the angle\n",
            printer.excerpt(*term)
        )
    });
    if turning.is_empty() { String::new() } else { format!("\nTurns\n{}", lines.collect::<String>()) }
}

/// How much something costs.
fn counted(operations: Operations) -> String {
    let Operations { arithmetic, divisions, calls } = operations;
    let kinds = [("sums and products", arithmetic), ("divisions and roots", divisions), ("functions", calls)];
    let parts: Vec<String> =
        kinds.iter().filter(|(_, count)| *count > 0).map(|(kind, count)| format!("{kind} {count}")).collect();
    if parts.is_empty() { "nothing".into() } else { parts.join(", ") }
}

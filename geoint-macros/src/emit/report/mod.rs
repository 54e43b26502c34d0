//! What was found, in words: the text behind `REPORT` and the docs of the generated struct.

mod bodies;
mod canonical;
mod constraints;
mod contact;
mod forced;
mod pieces;
mod field;
mod flow;
mod lagrangian;

use crate::schedule::Operations;
pub(crate) use bodies::bodies;
pub(crate) use canonical::canonical;
pub(crate) use constraints::constraints;
pub(crate) use contact::contact;
pub(crate) use flow::{OfField, Source, flow};
pub(crate) use forced::forced;
pub(crate) use lagrangian::{herglotz, lagrangian, velocities};

/// How much something costs.
fn counted(operations: Operations) -> String {
    let Operations { arithmetic, divisions, calls } = operations;
    let kinds = [("sums and products", arithmetic), ("divisions and roots", divisions), ("functions", calls)];
    let parts: Vec<String> =
        kinds.iter().filter(|(_, count)| *count > 0).map(|(kind, count)| format!("{kind} {count}")).collect();
    if parts.is_empty() { "nothing".into() } else { parts.join(", ") }
}

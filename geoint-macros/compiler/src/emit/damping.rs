//! What is emitted, and said, of damped systems alone.

use super::kernel::Context;
use super::tokens::Tokens;
use crate::analyze::{Damping, Forces};
use crate::ir::{Id, print::Printer};
use proc_macro2::TokenStream;
use quote::quote;
use std::fmt::Write;

/// The statement that tests a matrix of which it is not known yet whether it is positive semidefinite.
pub(super) fn matrix_test(context: &Context<'_>, values: &[Tokens]) -> TokenStream {
    if values.is_empty() {
        return TokenStream::new();
    }
    let rows = values.chunks(context.energy.degrees() as usize).map(|row| quote!([#(#row),*]));
    let message = "damping that is not positive semidefinite";
    quote!(if !is_positive_semidefinite([#(#rows),*]) { return ::core::option::Option::Some(#message); })
}

/// A vector as users write it.
pub(super) fn coefficients(printer: &Printer<'_>, entries: &[Id]) -> String {
    let entries: Vec<String> = entries.iter().map(|id| printer.excerpt(*id)).collect();
    format!("[{}]", entries.join(", "))
}

/// What becomes of the energy.
pub(super) fn section(
    text: &mut String,
    printer: &Printer<'_>,
    damping: &Damping,
    autonomous: bool,
) -> std::fmt::Result {
    let entry = |id: &Id| printer.excerpt(*id);
    let row = |row: &[Id]| row.iter().map(entry).collect::<Vec<_>>().join(", ");
    let diagonal: Vec<Id> = (0..damping.matrix.len()).map(|i| damping.matrix[i][i]).collect();
    let matrix = match damping.diagonal {
        true if diagonal.iter().all(|entry| *entry == diagonal[0]) => entry(&diagonal[0]),
        true => format!("diag({})", row(&diagonal)),
        false => {
            let rows: Vec<String> = damping.matrix.iter().map(|entries| format!("[{}]", row(entries))).collect();
            format!("[{}]", rows.join(", "))
        }
    };
    let explicit = if autonomous { "" } else { " + ∂H/∂t" };
    writeln!(text, "\nDamping")?;
    writeln!(text, "- p' = −∂H/∂q − C ∂H/∂p with C = {matrix}")?;
    writeln!(text, "- dH/dt = −∂H/∂p·C ∂H/∂p{explicit}")?;
    if autonomous {
        writeln!(text, "- in a step of `DiscreteGradient` the energy falls by exactly h ∇̄H·C ∇̄H, for every h")?;
    }
    writeln!(text, "- kick and drift do not exist: damping is no part of either")
}

/// What forces beside the energy do to it.
pub(super) fn forces(text: &mut String, printer: &Printer<'_>, forces: &Forces, autonomous: bool) -> std::fmt::Result {
    writeln!(text, "\nForces beside the energy")?;
    let mut power = vec![];
    if let Some(applied) = &forces.applied {
        writeln!(text, "- F = {}", coefficients(printer, applied))?;
        power.push("v·F");
    }
    if let Some(friction) = &forces.friction {
        writeln!(text, "- friction −∂R/∂v with ∂R/∂v = {}", coefficients(printer, friction))?;
        power.push("− v·∂R/∂v");
    }
    let power = power.join(" ");
    writeln!(text, "- they add {power} to dH/dt, with v = ∂H/∂p")?;
    if autonomous {
        writeln!(
            text,
            "- in a step of `DiscreteGradient` they add exactly h times that at the mean velocity, for every h"
        )?;
    }
    if forces.friction.is_some() {
        writeln!(text, "- a step in which friction would feed energy is refused")?;
    }
    if let Some(potential) = forces.potential {
        writeln!(
            text,
            "- this force has a potential: add {} to L, or take it off H, and the discrete gradient keeps the whole energy",
            printer.excerpt(potential)
        )?;
    }
    writeln!(text, "- kick and drift do not exist: a force is no part of either")
}

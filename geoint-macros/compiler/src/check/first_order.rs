//! Checks Lagrangians that are linear in the velocities, L = ϑ(q)·v − H(q).
//!
//! Their equations are Ω q' = ∇H with Ωᵢⱼ = ∂ᵢϑⱼ − ∂ⱼϑᵢ. They determine q' if Ω is regular. A matrix Ω that is singular at some states only is
//! accepted: the divisors of Ω⁻¹ are poles, and steps refuse these states. ϑ may not read time, because −∂ϑ/∂t would be a further force, and at most
//! [`LARGEST_BLOCK`] coordinates may be coupled.

use super::velocity;
use super::wording::quoted;
use crate::compilation::Compilation;
use crate::diagnostics::Result;
use crate::ir::Symbol;
use crate::legendre::{FirstOrder, FirstOrderFlaw, LARGEST_BLOCK};
use crate::parse::Requirement;

/// Reports a Lagrangian whose equations do not determine q', and options without a meaning for equations of first order.
pub(crate) fn first_order(
    compilation: &mut Compilation<'_>,
    analysis: std::result::Result<FirstOrder, FirstOrderFlaw>,
) -> Result<FirstOrder> {
    let options = &compilation.energy.options;
    for expr in options.rayleigh.iter().chain(&options.force) {
        compilation.diagnostics.at(expr, NO_FORCE);
    }
    if let Some(constraint) = options.constraint.as_ref().or(options.rolling.as_ref()) {
        compilation.diagnostics.at(constraint, NO_CONSTRAINTS);
    }
    for (requirement, span) in &options.requirements {
        // All other requirements are properties of the kinetic energy.
        let why = if *requirement == Requirement::Regular { NOT_REGULAR } else { NO_KINETIC };
        compilation.report_at(*span, why);
    }
    match analysis {
        Ok(system) => compilation.checked(system),
        Err(flaw) => {
            let message =
                format!("{LINEAR}: Ω q' = ∇H with Ωᵢⱼ = ∂ᵢϑⱼ − ∂ⱼϑᵢ, ϑ = ∂L/∂v. But {}", explain(compilation, &flaw));
            compilation.report_at(velocity(compilation.energy), message);
            Err(std::mem::take(&mut compilation.diagnostics))
        }
    }
}

/// Explains why Ω does not determine q'.
fn explain(compilation: &Compilation<'_>, flaw: &FirstOrderFlaw) -> String {
    let printer = compilation.printer();
    let all = |coordinates: &[u32]| quoted(&printer, Symbol::Position, coordinates);
    match flaw {
        FirstOrderFlaw::OddBlock(alone) if alone.len() == 1 => {
            let q = printer.named(Symbol::Position(alone[0]));
            format!(
                "the row of `{q}` in Ω is zero, so the rate of `{q}` is in no equation, and ∂H/∂{q} = 0 remains; solve this equation for \
                 `{q}` and insert the result into L, or give `{q}` a mass"
            )
        }
        FirstOrderFlaw::OddBlock(coordinates) => format!(
            "Ω of {} has an odd number of rows, so it is singular: coordinates come in pairs, as a position and its momentum; add the \
             missing coordinate, or eliminate one by a conserved function",
            all(coordinates)
        ),
        FirstOrderFlaw::Singular(coordinates) => format!(
            "Ω of {} is singular at every state: some combination of them has no equation of motion",
            all(coordinates)
        ),
        FirstOrderFlaw::ReadsTime(i) => format!(
            "ϑ of `{}` reads time: write the equations as `#[vector_field]`",
            printer.named(Symbol::Velocity(*i))
        ),
        FirstOrderFlaw::TooLarge(coordinates) => format!(
            "Ω couples {} coordinates, {}; it is inverted in closed form for {LARGEST_BLOCK} at most: give S = Ω⁻¹, \
             `#[hamiltonian(structure = S)]`",
            coordinates.len(),
            all(coordinates)
        ),
    }
}

const NO_CONSTRAINTS: &str = "the Lagrangian is linear in the velocities: constraints are for positions that have inertia; express one coordinate by the others";

const LINEAR: &str = "this Lagrangian is linear in the velocities, so that its equations are of first order";

const NO_FORCE: &str = "this Lagrangian is linear in the velocities: its equations are of first order, and a force has no inertia to act on; \
                        write them as `#[vector_field]`";

const NO_KINETIC: &str = "this Lagrangian is linear in the velocities: there is no kinetic energy";

const NOT_REGULAR: &str = "this Lagrangian is linear in the velocities, so that these do not follow from momenta";

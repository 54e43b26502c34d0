//! Checks Lagrangians that are linear in the velocities: the equations Ω q' = ∇H must determine q'.

use super::velocity;
use super::wording::quoted;
use crate::compilation::Compilation;
use crate::diagnostics::Result;
use crate::ir::Symbol;
use crate::legendre::{FirstOrder, NotRegular};
use crate::parse::Requirement;

/// Reports a Lagrangian whose equations do not determine q', and options without a meaning for equations of first order.
pub(crate) fn first_order(
    compilation: &mut Compilation<'_>,
    found: std::result::Result<FirstOrder, NotRegular>,
) -> Result<FirstOrder> {
    let options = &compilation.energy.options;
    for expr in options.rayleigh.iter().chain(&options.force) {
        compilation.diagnostics.at(expr, NO_FORCE);
    }
    if let Some(constraint) = &options.constraint {
        compilation.diagnostics.at(constraint, NO_CONSTRAINTS);
    }
    for (requirement, span) in &options.requirements {
        let why = if *requirement == Requirement::Regular { NO_VELOCITIES } else { NO_KINETIC };
        compilation.report_at(*span, why);
    }
    match found {
        Ok(found) => compilation.checked(found),
        Err(flaw) => {
            let message =
                format!("{LINEAR}: Ω q' = ∇H with Ωᵢⱼ = ∂ᵢϑⱼ − ∂ⱼϑᵢ, ϑ = ∂L/∂v. But {}", explain(compilation, &flaw));
            compilation.report_at(velocity(compilation.energy), message);
            Err(std::mem::take(&mut compilation.diagnostics))
        }
    }
}

/// Explains why Ω does not determine q'.
fn explain(compilation: &Compilation<'_>, flaw: &NotRegular) -> String {
    let printer = compilation.printer();
    let all = |coordinates: &[u32]| quoted(&printer, Symbol::Position, coordinates);
    match flaw {
        NotRegular::Odd(alone) if alone.len() == 1 => {
            let q = printer.named(Symbol::Position(alone[0]));
            format!(
                "no entry of Ω has `{q}`: what ϑ has of it adds a total derivative to L, which changes no motion, and ∂H/∂{q} = 0 is no \
                 differential equation; give `{q}` a mass, or solve that for it and put it in"
            )
        }
        NotRegular::Odd(coordinates) => format!(
            "Ω of {} has an odd number of rows, so that it is singular: positions and their momenta ϑ come in pairs; add the missing \
             coordinate, or take one out by what is constant",
            all(coordinates)
        ),
        NotRegular::Singular(coordinates) => format!(
            "Ω of {} is singular at every state: some combination of them has no equation of motion",
            all(coordinates)
        ),
        NotRegular::Timed(i) => format!(
            "ϑ of `{}` reads time: write the equations as `#[vector_field]`, or take time for one more coordinate",
            printer.named(Symbol::Velocity(*i))
        ),
        NotRegular::Large(coordinates) => format!(
            "Ω couples {} coordinates, {}; it is inverted in closed form for 8 at most: give its inverse, `#[hamiltonian(structure = S)]`",
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

const NO_VELOCITIES: &str = "this Lagrangian is linear in the velocities, so that these do not follow from momenta";

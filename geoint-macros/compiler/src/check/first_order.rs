//! Lagrangians that are linear in velocities: whether velocities follow from positions.

use crate::compilation::Compilation;
use crate::diagnostics::Result;
use crate::ir::{Symbol, print::Printer};
use crate::legendre::{FirstOrder, NotRegular};
use crate::parse::{Requirement, Role};

/// Reports a Lagrangian whose velocities do not follow, and what has no meaning for one whose velocities do.
pub(crate) fn first_order(
    compilation: &mut Compilation<'_>,
    found: std::result::Result<FirstOrder, NotRegular>,
) -> Result<FirstOrder> {
    let energy = compilation.energy;
    let Compilation { graph, names, diagnostics: errors, .. } = compilation;
    let printer = Printer::new(graph, names);
    for expr in energy.options.rayleigh.iter().chain(&energy.options.force) {
        errors.at(expr, NO_FORCE);
    }
    if let Some(constraint) = &energy.options.constraint {
        errors.at(constraint, NO_CONSTRAINTS);
    }
    for (requirement, span) in &energy.options.requirements {
        let why = if *requirement == Requirement::Regular { NO_VELOCITIES } else { NO_KINETIC };
        errors.at_place((*span, *span), why);
    }
    let all = |coordinates: &[u32]| {
        coordinates.iter().map(|i| format!("`{}`", printer.named(Symbol::Position(*i)))).collect::<Vec<_>>().join(", ")
    };
    let flaw = match &found {
        Ok(_) => None,
        Err(NotRegular::Odd(alone)) if alone.len() == 1 => {
            let q = printer.named(Symbol::Position(alone[0]));
            Some(format!(
                "no entry of Ω has `{q}`: what ϑ has of it adds a total derivative to L, which changes no motion, and ∂H/∂{q} = 0 is no \
                 differential equation; give `{q}` a mass, or solve that for it and put it in"
            ))
        }
        Err(NotRegular::Odd(coordinates)) => Some(format!(
            "Ω of {} has an odd number of rows, so that it is singular: positions and their momenta ϑ come in pairs; add the missing \
             coordinate, or take one out by what is constant",
            all(coordinates)
        )),
        Err(NotRegular::Singular(coordinates)) => Some(format!(
            "Ω of {} is singular at every state: some combination of them has no equation of motion",
            all(coordinates)
        )),
        Err(NotRegular::Timed(i)) => Some(format!(
            "ϑ of `{}` reads time: write the equations as `#[vector_field]`, or take time for one more coordinate",
            printer.named(Symbol::Velocity(*i))
        )),
        Err(NotRegular::Large(coordinates)) => Some(format!(
            "Ω couples {} coordinates, {}; it is inverted in closed form for 8 at most: give its inverse, `#[hamiltonian(structure = S)]`",
            coordinates.len(),
            all(coordinates)
        )),
    };
    if let Some(flaw) = flaw {
        let message = format!("{LINEAR}: Ω q' = ∇H with Ωᵢⱼ = ∂ᵢϑⱼ − ∂ⱼϑᵢ, ϑ = ∂L/∂v. But {flaw}");
        match energy.argument(Role::Velocity) {
            Some(velocities) => errors.at(&velocities.name, message),
            None => errors.at(&energy.item.sig.ident, message),
        }
    }
    match found {
        Ok(found) => compilation.checked(found),
        Err(_) => Err(std::mem::take(&mut compilation.diagnostics)),
    }
}

const NO_CONSTRAINTS: &str = "the Lagrangian is linear in the velocities: constraints are for positions that have inertia; express one coordinate by the others";

const LINEAR: &str = "this Lagrangian is linear in the velocities, so that its equations are of first order";

const NO_FORCE: &str = "this Lagrangian is linear in the velocities: its equations are of first order, and a force has no inertia to act on; \
                        write them as `#[vector_field]`";

const NO_KINETIC: &str = "this Lagrangian is linear in the velocities: there is no kinetic energy";

const NO_VELOCITIES: &str = "this Lagrangian is linear in the velocities, so that these do not follow from momenta";

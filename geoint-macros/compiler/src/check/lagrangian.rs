//! Lagrangians: whether velocities follow from momenta, and whether friction is some.

use super::damping::report_damping;
use crate::analyze::{Damping, Forces};
use crate::compilation::Compilation;
use crate::diagnostics::Result;
use crate::ir::{Graph, Id, Symbol, print::Printer};
use crate::legendre::{self, Friction, Kinetic, Legendre, NoFriction};
use crate::messages::{DOES_WORK, FORCED_ACTION, FULL_MASS, FULL_MASS_OF_ACTION, READS_ACTION, TAKES_ENERGY};
use crate::parse::{Requirement, Role};

/// Reports a Lagrangian that has no energy here, and friction that is none.
pub(crate) fn lagrangian(
    compilation: &mut Compilation<'_>,
    found: std::result::Result<Legendre, legendre::Flaw>,
    friction: std::result::Result<Option<Friction>, NoFriction>,
) -> Result<(Legendre, Option<Friction>)> {
    let energy = compilation.energy;
    let Compilation { graph, names, diagnostics: errors, .. } = compilation;
    let printer = Printer::new(graph, names);
    let [q, v] = [Symbol::Position, Symbol::Velocity].map(|kind| move |i: &u32| kind(*i));
    let named = |symbol: Symbol| printer.named(symbol);
    let velocities = energy.argument(Role::Velocity).map(|velocities| &velocities.name);
    match &friction {
        Err(NoFriction::Odd) => errors.at(&energy.options.rayleigh, NOT_RAYLEIGH),
        Err(NoFriction::Kink(slope)) => {
            errors.at(&energy.options.rayleigh, format!("{KINKED}: {}", printer.excerpt(*slope)));
        }
        Err(NoFriction::AtRest(rest)) => {
            errors.at(&energy.options.rayleigh, format!("{NO_REST}: {}", printer.excerpt(*rest)));
        }
        Ok(_) => {}
    }
    if let Err(flaw) = &found {
        let all =
            |velocities: &[u32]| velocities.iter().map(|i| format!("`{}`", named(v(i)))).collect::<Vec<_>>().join(", ");
        let (message, term) = match flaw {
            legendre::Flaw::Unread(i) => {
                let [q, v] = [named(q(i)), named(v(i))];
                let message = format!(
                    "`{v}` is not read, so that `{q}` has no inertia, and ∂L/∂{q} = 0 is no differential equation: solve that for `{q}` and \
                     put it in, or give it a mass"
                );
                (message, None)
            }
            legendre::Flaw::Jumps(i, momentum) => {
                let message = format!(
                    "the momentum of `{}` jumps where velocities change, so that no velocity belongs to momenta in between; dry friction is no \
                     term of L: for a small velocity e it is `rayleigh = c * (v * v + e * e).sqrt()`. ∂L/∂v: {}",
                    named(v(i)),
                    printer.excerpt(*momentum)
                );
                (message, None)
            }
            legendre::Flaw::Linear(momenta) => {
                let momenta: Vec<String> = momenta.iter().map(|momentum| printer.excerpt(*momentum)).collect();
                let message = format!(
                    "this Lagrangian is linear in the velocities, so that its equations are of first order: write them as \
                     `#[hamiltonian(structure = …)]` of the energy −L at {} = 0; the momenta ∂L/∂v are {}",
                    velocities.map(ToString::to_string).unwrap_or_default(),
                    momenta.join(", ")
                );
                (message, None)
            }
            legendre::Flaw::LinearIn(i, momentum) => {
                let message = format!(
                    "this Lagrangian is linear in `{}`, which has no inertia: its momentum is a function of positions, {}; give `{}` a mass, or \
                     write the equations as `#[vector_field]`",
                    named(v(i)),
                    printer.excerpt(*momentum),
                    named(q(i))
                );
                (message, None)
            }
            legendre::Flaw::Singular(velocities, direction) => {
                let combination: Vec<String> = velocities
                    .iter()
                    .zip(direction)
                    .filter(|(_, part)| !graph.is_zero(**part))
                    .map(|(i, part)| format!("`{}` = {}", named(v(i)), printer.excerpt(*part)))
                    .collect();
                let message = format!(
                    "the mass matrix ∂²L/∂v² of {} is singular at every state, so that these velocities do not follow from momenta: a motion \
                     with {} has no inertia",
                    all(velocities),
                    combination.join(", ")
                );
                (message, None)
            }
            legendre::Flaw::NotClosed(velocities, of) => {
                let message = format!(
                    "no formula is known for {} as functions of their momenta; known are Lagrangians that are quadratic in velocities, and \
                     A√(S + v·Cv), A|v|ⁿ, A eᵛ, A ln v and A cosh v, with terms that are linear: {}",
                    all(velocities),
                    printer.excerpt(*of)
                );
                (message, Some(*of))
            }
        };
        let place = term.and_then(|term| compilation.written(term));
        let errors = &mut compilation.diagnostics;
        match (place, velocities) {
            (Some(place), _) => errors.at_place(place, message),
            (None, Some(velocities)) => errors.at(velocities, message),
            (None, None) => errors.at(&energy.item.sig.ident, message),
        }
    }
    match (found, friction) {
        (Ok(legendre), Ok(friction)) => {
            for (requirement, span) in &energy.options.requirements {
                if let Some((term, why)) = in_the_way(&compilation.graph, *requirement, &legendre) {
                    compilation.blame(term, *span, why);
                }
            }
            compilation.checked((legendre, friction))
        }
        _ => Err(std::mem::take(&mut compilation.diagnostics)),
    }
}

/// The term by which a requirement on L does not hold. A Lagrangian with an energy is regular.
fn in_the_way(graph: &Graph, requirement: Requirement, legendre: &Legendre) -> Option<(Id, &'static str)> {
    if !matches!(requirement, Requirement::Quadratic | Requirement::ConstantMass) {
        return None;
    }
    legendre.parts.iter().find_map(|part| match &part.kinetic {
        Kinetic::Conjugate { term, .. } | Kinetic::Open(term) => Some((*term, NOT_QUADRATIC_IN_VELOCITIES)),
        Kinetic::Quadratic { mass, .. } if requirement == Requirement::ConstantMass => {
            mass.iter().flatten().copied().find(|entry| graph.reads(*entry).moves()).map(|entry| (entry, MASS_CHANGES))
        }
        Kinetic::Quadratic { .. } => None,
    })
}

/// Reports friction that is none, and what is required of an energy that is not derived.
pub(crate) fn velocities(
    compilation: &mut Compilation<'_>,
    obstacle: Id,
    damping: Option<&Damping>,
    others: Option<&Forces>,
) -> Result<()> {
    report_damping(compilation, damping);
    let has_action = compilation.form.has_action();
    for (requirement, span) in &compilation.energy.options.requirements {
        if *requirement == Requirement::Conservative {
            let changed = match (damping, others) {
                (Some(_), _) => Some(TAKES_ENERGY),
                (None, Some(_)) => Some(DOES_WORK),
                (None, None) => has_action.then_some(READS_ACTION),
            };
            changed.into_iter().for_each(|why| compilation.report_at(*span, why));
            continue;
        }
        if requirement.is_of_lagrangian() {
            continue;
        }
        let place = compilation.written(obstacle).unwrap_or((*span, *span));
        let why = if has_action { FULL_MASS_OF_ACTION } else { FULL_MASS };
        let message = format!("{why}: {}", compilation.excerpt(obstacle));
        compilation.diagnostics.at_place(place, message);
    }
    compilation.checked(())
}

/// Reports friction that is none, and requirements: with an action and forces beside it there are rates alone.
pub(crate) fn forced_action(compilation: &mut Compilation<'_>, damping: Option<&Damping>) -> Result<()> {
    report_damping(compilation, damping);
    let requirements = &compilation.energy.options.requirements;
    let of_energy = requirements.iter().filter(|(requirement, _)| !requirement.is_of_lagrangian());
    of_energy.for_each(|(_, span)| compilation.report_at(*span, FORCED_ACTION));
    compilation.checked(())
}

const NOT_QUADRATIC_IN_VELOCITIES: &str = "this is not quadratic in the velocities, so that the mass matrix reads them";

const MASS_CHANGES: &str = "this entry of the mass matrix ∂²L/∂v² is not constant";

const NOT_RAYLEIGH: &str = "Rayleigh's function has its least value at rest, but this is a polynomial of odd degree in the velocities, which \
                            feeds one direction where it brakes the other: write `c * v * v / 2.0`, or `c * v.abs().powi(3) / 3.0`";

const KINKED: &str = "friction jumps at rest, so that no step ends there: for a small velocity e, dry friction is \
                      `c * (v * v + e * e).sqrt()`. ∂R/∂v";

const NO_REST: &str =
    "Rayleigh's function has its least value at rest, so that friction vanishes there, but there ∂R/∂v is";

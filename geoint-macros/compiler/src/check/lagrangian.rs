//! Checks Lagrangians: the momenta must determine the velocities, and friction must take energy.

use super::damping::report_damping;
use super::wording::{commas, quoted};
use super::{blame_written, required, velocity};
use crate::analyze::{Damping, Forces};
use crate::compilation::Compilation;
use crate::diagnostics::Result;
use crate::ir::{Graph, Id, Symbol};
use crate::legendre::{self, Friction, Kinetic, Legendre, NoFriction};
use crate::messages::{DOES_WORK, FORCED_ACTION, FULL_MASS, FULL_MASS_OF_ACTION, READS_ACTION, TAKES_ENERGY};
use crate::parse::{Requirement, Role};

/// Reports a Lagrangian without an energy, an invalid Rayleigh function, and requirements on L that do not hold.
pub(crate) fn lagrangian(
    compilation: &mut Compilation<'_>,
    found: std::result::Result<Legendre, legendre::Flaw>,
    friction: std::result::Result<Option<Friction>, NoFriction>,
) -> Result<(Legendre, Option<Friction>)> {
    let energy = compilation.energy;
    if let Err(flaw) = &friction {
        let message = match *flaw {
            NoFriction::Odd => NOT_RAYLEIGH.into(),
            NoFriction::Kink(slope) => format!("{KINKED}: {}", compilation.excerpt(slope)),
            NoFriction::AtRest(rest) => format!("{NO_REST}: {}", compilation.excerpt(rest)),
        };
        compilation.diagnostics.at(&energy.options.rayleigh, message);
    }
    if let Err(flaw) = &found {
        let term = if let legendre::Flaw::NotClosed(_, term) = flaw { compilation.written(*term) } else { None };
        let span = velocity(energy);
        let message = explain(compilation, flaw);
        compilation.diagnostics.at_place(term.unwrap_or((span, span)), message);
    }
    let (Ok(legendre), Ok(friction)) = (found, friction) else {
        return Err(std::mem::take(&mut compilation.diagnostics));
    };
    for (requirement, span) in &energy.options.requirements {
        if let Some((term, why)) = obstacle(&compilation.graph, *requirement, &legendre) {
            compilation.blame(term, *span, why);
        }
    }
    compilation.checked((legendre, friction))
}

/// Explains why a Lagrangian has no energy.
fn explain(compilation: &Compilation<'_>, flaw: &legendre::Flaw) -> String {
    let (graph, printer) = (&compilation.graph, compilation.printer());
    let (q, v) = (|i: &u32| printer.named(Symbol::Position(*i)), |i: &u32| printer.named(Symbol::Velocity(*i)));
    let all = |velocities: &[u32]| quoted(&printer, Symbol::Velocity, velocities);
    match flaw {
        legendre::Flaw::Unread(i) => {
            let (q, v) = (q(i), v(i));
            format!(
                "`{v}` is not read, so that `{q}` has no inertia, and ∂L/∂{q} = 0 is no differential equation: solve that for `{q}` and \
                 put it in, or give it a mass"
            )
        }
        legendre::Flaw::Jumps(i, momentum) => format!(
            "the momentum of `{}` jumps where velocities change, so that no velocity belongs to momenta in between; dry friction is no \
             term of L: for a small velocity e it is `rayleigh = c * (v * v + e * e).sqrt()`. ∂L/∂v: {}",
            v(i),
            printer.excerpt(*momentum)
        ),
        legendre::Flaw::Linear(momenta) if compilation.form.has_action() => format!(
            "this Lagrangian is linear in the velocities, so that its equations are of first order: in coordinates in which half of them are the momenta of the \
             others, write them as `#[contact_hamiltonian]` of the energy −L at {} = 0; the momenta ∂L/∂v are {}",
            compilation.names.of(Role::Velocity),
            commas(momenta.iter().map(|momentum| printer.excerpt(*momentum)))
        ),
        legendre::Flaw::Linear(momenta) => format!(
            "this Lagrangian is linear in the velocities, so that its equations are of first order: write them as \
             `#[hamiltonian(structure = …)]` of the energy −L at {} = 0; the momenta ∂L/∂v are {}",
            compilation.names.of(Role::Velocity),
            commas(momenta.iter().map(|momentum| printer.excerpt(*momentum)))
        ),
        legendre::Flaw::LinearIn(i, momentum) => format!(
            "this Lagrangian is linear in `{}`, which has no inertia: its momentum is a function of positions, {}; give `{}` a mass, or \
             write the equations as `#[vector_field]`",
            v(i),
            printer.excerpt(*momentum),
            q(i)
        ),
        legendre::Flaw::Singular(velocities, direction) => {
            let moving = velocities.iter().zip(direction).filter(|(_, part)| !graph.is_zero(**part));
            format!(
                "the mass matrix ∂²L/∂v² of {} is singular at every state, so that these velocities do not follow from momenta: a motion \
                 with {} has no inertia",
                all(velocities),
                commas(moving.map(|(i, part)| format!("`{}` = {}", v(i), printer.excerpt(*part))))
            )
        }
        legendre::Flaw::NotClosed(velocities, term) => format!(
            "no formula is known for {} as functions of their momenta; known are Lagrangians that are quadratic in velocities, and \
             A√(S + v·Cv), A|v|ⁿ, A eᵛ, A ln v and A cosh v, with terms that are linear: {}",
            all(velocities),
            printer.excerpt(*term)
        ),
    }
}

/// Returns the first term that violates a requirement on L, with the reason. A Lagrangian with an energy is always regular.
fn obstacle(graph: &Graph, requirement: Requirement, legendre: &Legendre) -> Option<(Id, &'static str)> {
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

/// Reports damping that feeds energy, and all requirements on the energy, for a Lagrangian whose steps solve for velocities. `obstacle` is the
/// term that hides the energy.
pub(crate) fn velocities(
    compilation: &mut Compilation<'_>,
    obstacle: Id,
    damping: Option<&Damping>,
    others: Option<&Forces>,
) -> Result<()> {
    report_damping(compilation, damping);
    let has_action = compilation.form.has_action();
    for (requirement, span) in required(compilation.energy) {
        if requirement != Requirement::Conservative {
            blame_written(compilation, obstacle, span, if has_action { FULL_MASS_OF_ACTION } else { FULL_MASS });
        } else if damping.is_some() {
            compilation.report_at(span, TAKES_ENERGY);
        } else if others.is_some() {
            compilation.report_at(span, DOES_WORK);
        } else if has_action {
            compilation.report_at(span, READS_ACTION);
        }
    }
    compilation.checked(())
}

/// Reports damping that feeds energy, and all requirements on the energy, for a system with an action and forces. Its steps follow rates only.
pub(crate) fn forced_action(compilation: &mut Compilation<'_>, damping: Option<&Damping>) -> Result<()> {
    report_damping(compilation, damping);
    required(compilation.energy).for_each(|(_, span)| compilation.report_at(span, FORCED_ACTION));
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

//! What was found of H(q, p, s, t), in words.

use super::super::kernel::Context;
use super::counted;
use crate::analyze::{self, Dissipated};
use crate::derive::{ContactStages, Implicit, KickDrift, System, Undamped};
use crate::diff::Gradient;
use crate::ir::{Graph, Id, Symbol, print::Printer};
use crate::schedule::Plan;
use std::fmt::{Result as Written, Write};

/// The report.
pub(crate) fn contact(
    context: &Context<'_>,
    graph: &Graph,
    (energy, gradient, dissipated): (Id, &Gradient, Option<&Dissipated>),
    system: &System<Plan>,
) -> String {
    let mut text = String::new();
    let printer = Printer::new(graph, context);
    // Writing to a string cannot fail.
    let _ = structure(&mut text, &printer, (energy, gradient), system)
        .and_then(|()| dissipated.map_or(Ok(()), |found| decaying(&mut text, &printer, ("H", gradient.s), found)))
        .and_then(|()| pieces(&mut text, &printer, system))
        .and_then(|()| implicit(&mut text, context.energy.degrees(), system));
    text
}

fn structure(
    text: &mut String,
    printer: &Printer<'_>,
    (energy, gradient): (Id, &Gradient),
    system: &System<Plan>,
) -> Written {
    let graph = printer.graph();
    writeln!(text, "H = {}", printer.formula(energy))?;
    writeln!(text, "\nStructure")?;
    let explicit = if graph.reads(energy).t { " + ∂H/∂t" } else { "" };
    match graph.is_zero(gradient.s) {
        true => {
            writeln!(text, "- ∂H/∂s = 0: nothing is lost, H' = {}", if explicit.is_empty() { "0" } else { "∂H/∂t" })?
        }
        false => writeln!(text, "- ∂H/∂s = {}, and H' = −H ∂H/∂s{explicit}", printer.excerpt(gradient.s))?,
    }
    match analyze::acts_back(graph, gradient.s, gradient.q.iter().chain(&gradient.p).copied()) {
        true => writeln!(text, "- s acts back on positions or momenta")?,
        false => writeln!(text, "- positions and momenta move without s: `without_action` leaves it out")?,
    }
    match &system.splitting {
        Some(Ok(KickDrift { gradient_kick: Ok(_), .. })) => {
            writeln!(text, "- T + g·s + V with quadratic T: kick and drift exist, and all tables have their order")
        }
        Some(Ok(KickDrift { undamped: Some(Undamped { kick: Some(_), .. }), .. })) => {
            writeln!(
                text,
                "- T + g·s + V: kick and drift exist, with the damping in the kick, because T is no quadratic form; tables of \
                 Runge–Kutta–Nyström type need one"
            )
        }
        Some(Ok(KickDrift { gradient_kick: Err(missing), .. })) => {
            let term = printer.excerpt(missing.term);
            writeln!(
                text,
                "- T + g·s + V: kick and drift exist; tables of Runge–Kutta–Nyström type would lose their order by {term}"
            )
        }
        Some(Err(missing)) => {
            writeln!(text, "- not T + g·s + V, so that kick and drift do not exist: {}", printer.excerpt(missing.term))
        }
        None => Ok(()),
    }
}

/// What decays by one factor, by H or L.
pub(super) fn decaying(
    text: &mut String,
    printer: &Printer<'_>,
    (by, rate): (&str, Id),
    Dissipated { cyclic, momenta, energy }: &Dissipated,
) -> Written {
    let reads = printer.graph().reads(rate);
    let rate = printer.excerpt(rate);
    let factor = match (reads.state(), reads.t) {
        (false, false) => format!("e^(−({rate})·t)"),
        _ => format!("exp(−∫ ({rate}) dt)"),
    };
    writeln!(text, "\nDecaying by the factor {factor}, all alike, so that quotients are constant")?;
    for i in cyclic {
        writeln!(
            text,
            "- {}: {by} does not read {}",
            printer.named(Symbol::Momentum(*i)),
            printer.named(Symbol::Position(*i))
        )?;
    }
    for momentum in momenta {
        writeln!(text, "- {}: {}", momentum.name, printer.excerpt(momentum.value))?;
    }
    if *energy {
        writeln!(text, "- H: it does not read time")?;
    }
    if !cyclic.is_empty() || !momenta.is_empty() {
        writeln!(
            text,
            "In a step of a contact map (`ContactGauss`, `ContactMidpoint`) momenta are multiplied by one number, to rounding"
        )?;
    }
    if *energy {
        writeln!(text, "`ContactDiscreteGradient` multiplies H by what its equation says, to rounding")?;
    }
    Ok(())
}

fn pieces(text: &mut String, printer: &Printer<'_>, system: &System<Plan>) -> Written {
    writeln!(text, "\nPieces with flows in closed form, in the order of half a step")?;
    system.pieces.iter().try_for_each(|found| super::pieces::of_energy(text, printer, (found, true)))
}

fn implicit(text: &mut String, degrees: u32, system: &System<Plan>) -> Written {
    writeln!(text, "\nImplicit steps, for the increments of all positions, momenta and the action")?;
    let Implicit::Contact(kernels) = &system.implicit else { return Ok(()) };
    for (method, step) in &kernels.steps {
        let cost = counted(step.kernel.operations());
        writeln!(text, "- `{method}`, unknowns {}: {cost} an iteration", 2 * degrees + 1)?;
    }
    let Some(stages) = &kernels.stages else {
        return writeln!(text, "- none: the momenta of a lift are not followed");
    };
    let (kernel, unknowns, varying) = match stages {
        ContactStages::Points(stages) => {
            let unknowns = stages.moved.len() as u32;
            (&stages.kernel, unknowns, unknowns > 2 * degrees)
        }
        ContactStages::Velocities(stages) => (&stages.stage, degrees + u32::from(stages.varying), stages.varying),
    };
    let (cost, of) = (counted(kernel.operations()), if unknowns < 2 * degrees { " (velocities)" } else { "" });
    let beside = if varying { "" } else { ": s follows, and friction costs nothing beside `Gauss`" };
    writeln!(text, "- `ContactGauss`, unknowns {unknowns}{of} a stage: {cost} a stage of an iteration{beside}")
}

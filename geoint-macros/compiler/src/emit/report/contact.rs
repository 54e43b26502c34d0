//! Reports H(q, p, s, t).

use super::{Report, pieces};
use crate::analyze::{self, Dissipated};
use crate::derive::{ContactStages, Kernels, KickDrift, System, Undamped};
use crate::diff::Gradient;
use crate::ir::Id;

/// Reports the structure, decaying functions, pieces, and costs of implicit steps.
pub(super) fn report(
    report: &mut Report<'_>,
    energy: Id,
    gradient: &Gradient,
    dissipated: Option<&Dissipated>,
    system: &System,
) {
    structure(report, energy, gradient, system);
    if let Some(found) = dissipated {
        decaying(report, "H", CONTACT_MAPS, gradient.s, found);
    }
    writeln!(report, "\nPieces with flows in closed form, in the order of half a step");
    system.pieces.iter().for_each(|found| pieces::of_energy(report, found));
    implicit(report, system);
}

/// Writes H, its change along the flow, and whether kick and drift exist.
fn structure(report: &mut Report<'_>, energy: Id, gradient: &Gradient, system: &System) {
    let graph = report.graph();
    writeln!(report, "H = {}", report.formula(energy));
    writeln!(report, "\nStructure");
    let explicit = if graph.reads(energy).t { " + ∂H/∂t" } else { "" };
    match graph.is_zero(gradient.s) {
        true => {
            writeln!(report, "- ∂H/∂s = 0: nothing is lost, H' = {}", if explicit.is_empty() { "0" } else { "∂H/∂t" })
        }
        false => writeln!(report, "- ∂H/∂s = {}, and H' = −H ∂H/∂s{explicit}", report.excerpt(gradient.s)),
    }
    if explicit.is_empty() && report.compilation.energy.options.lift.is_none() {
        let power = report.compilation.degrees() + 1;
        writeln!(report, "- |H|^−{power} is the density of an invariant measure where H ≠ 0");
    }
    match analyze::acts_back(graph, gradient.s, gradient.q.iter().chain(&gradient.p).copied()) {
        true => writeln!(report, "- s acts back on positions or momenta"),
        false => writeln!(report, "- positions and momenta move without s: `without_action` leaves it out"),
    }
    match &system.splitting {
        Some(Ok(KickDrift { gradient_kick: Ok(_), .. })) => {
            writeln!(report, "- T + g·s + V with quadratic T: kick and drift exist, and all tables have their order")
        }
        Some(Ok(KickDrift { undamped: Some(Undamped { kick: Some(_), .. }), .. })) => {
            writeln!(
                report,
                "- T + g·s + V: kick and drift exist, with the damping in the kick, because T is no quadratic form; tables of \
                 Runge–Kutta–Nyström type need one"
            )
        }
        Some(Ok(KickDrift { gradient_kick: Err(missing), .. })) => {
            let term = report.excerpt(missing.term);
            writeln!(
                report,
                "- T + g·s + V: kick and drift exist; tables of Runge–Kutta–Nyström type would lose their order by {term}"
            )
        }
        Some(Err(missing)) => {
            writeln!(report, "- not T + g·s + V, so that kick and drift do not exist: {}", report.excerpt(missing.term))
        }
        None => {}
    }
}

/// Contact maps for every contact system without constraints.
pub(super) const CONTACT_MAPS: &str = "`ContactGauss`, `ContactMidpoint`";

/// Reports functions that decay by one common factor. `function` is H or L, which does not read the cyclic coordinates.
pub(super) fn decaying(
    report: &mut Report<'_>,
    function: &str,
    contact_maps: &str,
    rate: Id,
    Dissipated { cyclic, momenta, energy }: &Dissipated,
) {
    let reads = report.graph().reads(rate);
    let rate = report.excerpt(rate);
    let factor = match (reads.state(), reads.t) {
        (false, false) => format!("e^(−({rate})·t)"),
        _ => format!("exp(−∫ ({rate}) dt)"),
    };
    writeln!(report, "\nDecaying by the factor {factor}, all alike, so that quotients are constant");
    for i in cyclic {
        writeln!(report, "- {}", report.cyclic(function, *i));
    }
    for momentum in momenta {
        writeln!(report, "- {}", report.momentum(momentum));
    }
    if *energy {
        writeln!(report, "- H: it does not read time");
    }
    if !cyclic.is_empty() || !momenta.is_empty() {
        writeln!(
            report,
            "In a step of a contact map ({contact_maps}) momenta are multiplied by one number, to rounding"
        );
    }
    if *energy {
        writeln!(report, "`ContactDiscreteGradient` multiplies H by what its equation says, to rounding");
    }
}

/// Writes the costs of implicit steps.
fn implicit(report: &mut Report<'_>, system: &System) {
    let degrees = report.compilation.degrees();
    writeln!(report, "\nImplicit steps, for the increments of all positions, momenta and the action");
    let Kernels::Contact(kernels) = &system.kernels else { return };
    for (method, step) in &kernels.steps {
        let (unknowns, cost) = (2 * degrees + 1, step.kernel.operations());
        writeln!(report, "- `{method}`, unknowns {unknowns}: {cost} an iteration");
    }
    let Some(stages) = &kernels.stages else {
        return writeln!(report, "- none: the momenta of a lift are not followed");
    };
    let (kernel, unknowns, varying) = match stages {
        ContactStages::Points(stages) => {
            let unknowns = stages.moved.len() as u32;
            (&stages.kernel, unknowns, unknowns > 2 * degrees)
        }
        ContactStages::Velocities(stages) => {
            let varying = stages.has_action_unknown();
            (&stages.stage, degrees + u32::from(varying), varying)
        }
    };
    let (cost, of) = (kernel.operations(), if unknowns < 2 * degrees { " (velocities)" } else { "" });
    let beside = if varying { "" } else { ": s follows, and friction costs nothing beside `Gauss`" };
    writeln!(report, "- `ContactGauss`, unknowns {unknowns}{of} a stage: {cost} a stage of an iteration{beside}")
}

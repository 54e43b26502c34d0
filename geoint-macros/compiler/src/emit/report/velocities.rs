//! Reports steps of a Lagrangian with velocities as unknowns.

use super::contact::{CONTACT_MAPS, decaying};
use super::{Report, friction};
use crate::analyze::{Acting, Damping, Forces};
use crate::check::wording::commas;
use crate::derive::{BesideVelocities, Decay, KeptMomentum, Kernels, System, VelocityKernels};
use crate::ir::{Id, Symbol};
use crate::legendre::Legendre;
use crate::parse::Role;

/// Reports the structure, conserved functions, and costs of implicit steps. `obstacle` is the term that prevents a short H.
pub(super) fn report(
    report: &mut Report<'_>,
    legendre: &Legendre,
    obstacle: Id,
    beside: &BesideVelocities,
    system: &System,
) {
    let Kernels::Velocities(kernels) = &system.kernels else { return };
    let v = report.name_of(Role::Velocity);
    writeln!(report, "Structure");
    writeln!(
        report,
        "- steps are solved for {v}: H as a function of momenta would be long, or has no formula, by {}",
        report.excerpt(obstacle)
    );
    match beside {
        BesideVelocities::Forces { damping, forces } => {
            writeln!(report, "- kick and drift do not exist");
            conserved(report, legendre, damping.as_ref(), forces.as_ref(), kernels);
        }
        BesideVelocities::Action { decay, dissipated } => {
            writeln!(report, "- kick and drift do not exist, nor do pieces with flows in closed form");
            writeln!(report, "- ∂H/∂s = −∂L/∂s = {}, and H' = −H ∂H/∂s − ∂L/∂t", report.excerpt(*decay));
            match kernels.stages.has_action_unknown() {
                true => writeln!(report, "- s acts back on positions or momenta"),
                false => writeln!(report, "- positions and momenta move without s: `without_action` leaves it out"),
            }
            if let Some(dissipated) = dissipated {
                decaying(report, "L", CONTACT_MAPS, *decay, dissipated);
            }
        }
    }
    let unknowns = report.compilation.degrees() + u32::from(kernels.stages.has_action_unknown());
    writeln!(report, "\nImplicit steps, with {unknowns} unknowns a stage (a sine with its cosine counts as two)");
    let stage = kernels.stages.stage.operations();
    let action = kernels.stages.decay != Decay::None;
    match action {
        false => writeln!(report, "- stage of a Newton iteration of collocation: {stage}"),
        true => writeln!(report, "- `ContactMidpoint` and `ContactGauss`: {stage} a stage of an iteration"),
    }
    match kernels.polarised.as_ref().map(|step| step.kernel.operations()) {
        Ok(cost) if action => {
            writeln!(report, "- `ContactDiscreteGradient`, the polarised one: {cost} an iteration")
        }
        Ok(cost) => writeln!(report, "- Newton iteration of the discrete gradient, the polarised one: {cost}"),
        Err(_) => writeln!(report, "- there is no discrete gradient: L is not quadratic in {v}"),
    }
}

/// Reports time, damping, forces, and integrals of the flow and of its methods.
fn conserved(
    report: &mut Report<'_>,
    legendre: &Legendre,
    damping: Option<&Damping>,
    forces: Option<&Forces>,
    kernels: &VelocityKernels,
) {
    let autonomous = !report.graph().reads(legendre.lagrangian).t;
    report.time("L", autonomous);
    if let Some(damping) = damping {
        friction::damping(report, damping, autonomous);
    }
    if let Some(forces) = forces {
        friction::forces(report, forces, autonomous);
    }
    writeln!(report, "\nConserved by the flow, at least");
    let read = report.graph().symbols(legendre.lagrangian);
    let acting = Acting { damping, forces };
    let is_kept = |i: &u32| !read.contains(&Symbol::Position(*i)) && !acting.on_momentum(report.graph(), *i);
    let cyclic: Vec<u32> = (0..report.compilation.degrees()).filter(is_kept).collect();
    let energy = autonomous && damping.is_none() && forces.is_none();
    let VelocityKernels { polarised, momenta, .. } = kernels;
    let mut lines: Vec<String> = energy.then(|| "the energy".into()).into_iter().collect();
    lines.extend(cyclic.iter().map(|i| report.cyclic("L", *i)));
    lines.extend(momenta.iter().map(|KeptMomentum { momentum, .. }| report.momentum(momentum)));
    report.conserved(&lines);
    if !cyclic.is_empty() || !momenta.is_empty() {
        writeln!(report, "`ImplicitMidpoint` and `Gauss` keep all momenta of these, to rounding");
    }
    let summed = momenta.iter().any(|kept| kept.by_gradient);
    if polarised.is_ok() && (energy || summed || !cyclic.is_empty()) {
        let others = momenta.iter().filter(|kept| !kept.by_gradient);
        let others = commas(others.map(|kept| format!("the {}", kept.momentum.name)));
        let but = if others.is_empty() { String::new() } else { format!(" but {others}") };
        writeln!(report, "`DiscreteGradient` keeps all of these{but}, to rounding");
    }
}

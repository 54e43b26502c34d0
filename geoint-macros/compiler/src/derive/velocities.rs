//! What is derived from L(q, v, t) where velocities are the unknowns of steps.

use super::domain::{Domain, Roots};
use super::exact::pieces::{self, Followed};
use super::facts::Fact;
use super::system::{
    HerglotzKernels, Implicit, MassKernels, Missing, StepKernel, System, VelocityKernels, VelocityStages,
};
use crate::analyze::{self, Damping, Forces, Spared};
use crate::diff::lagrangian::{self, EulerLagrange, Polarised, Stage};
use crate::ir::collect::collected;
use crate::ir::{Graph, Id, Reads, Symbol};
use crate::legendre::{Definite, Kinetic, Legendre, definite};
use crate::messages::{
    FULL_MASS, FULL_MASS_OF_ACTION, NO_PIECES_OF_VELOCITIES, NOT_POLARISED, NOT_POLARISED_OF_ACTION,
};
use crate::parse::{Form, Shape};
use crate::schedule::{Kernel, Levels};

/// Derives everything that some method needs; `long` is why there is no H.
pub(crate) fn velocities(
    graph: &mut Graph,
    legendre: &Legendre,
    (long, coordinates): (Id, &Shape),
    (damping, others): (Option<&Damping>, Option<&Forces>),
) -> System {
    let Legendre { lagrangian, forces, momenta, .. } = legendre;
    let equation = EulerLagrange {
        damping: damping.map(|damping| &damping.matrix[..]),
        applied: others,
        has_action: false,
        ..euler_lagrange(legendre)
    };
    let stage = stage(graph, equation);
    let mut momenta_kept = analyze::noether(graph, legendre.lagrangian, coordinates);
    let spared = Spared { damping, forces: others };
    momenta_kept.retain(|momentum| spared.momentum(graph, momentum));
    let polarised = if is_quadratic(legendre) {
        Ok(polarised(graph, equation).kernel)
    } else {
        Err(Missing { marker: "Polarised", term: long, why: NOT_POLARISED, pair: None })
    };
    let summed = match &polarised {
        Ok(_) => {
            let polarisation = lagrangian::polarisation(graph, equation);
            analyze::translations(graph, polarisation, coordinates)
        }
        Err(_) => vec![],
    };
    // What has no velocity in it is divided as slopes divide it.
    let roots = [&[*lagrangian][..], forces, momenta].concat();
    let degrees = momenta.len() as u32;
    System {
        facts: vec![],
        value: None,
        slopes: None,
        rate: None,
        splitting: Some(Err(Missing { marker: "Uncoupled", term: long, why: FULL_MASS, pair: None })),
        modified: None,
        pieces: vec![],
        perturbed: None,
        implicit: Implicit::Velocities(VelocityKernels {
            increments: (0..degrees).map(Symbol::VelocityIncrement).collect(),
            mass: mass_kernels(graph, legendre),
            stage: stage_kernel(stage),
            keeps: damping.is_none() && others.is_none() && !graph.reads(*lagrangian).t,
            polarised,
            momenta: momenta_kept
                .into_iter()
                .map(|momentum| {
                    let by_gradient = summed.iter().any(|other| other.value == momentum.value);
                    (momentum, by_gradient)
                })
                .collect(),
        }),
        integrals: None,
        domain: Domain::of(
            graph,
            Roots { all: &roots, divided: &[*lagrangian] },
            Form::Lagrangian,
            &legendre.partial,
            (damping, &[]),
        ),
        lagrangian: None,
        jet: None,
    }
}

/// The same of L(q, v, s, t) with an action.
pub(crate) fn herglotz(graph: &mut Graph, legendre: &Legendre, long: Id) -> System {
    let Legendre { lagrangian, forces, momenta, .. } = legendre;
    let stages = velocity_stages(graph, legendre);
    let decay = analyze::decay(graph, *lagrangian);
    let polarised = if is_quadratic(legendre) {
        Ok(polarised(graph, euler_lagrange(legendre)))
    } else {
        Err(Missing { marker: "Polarised", term: long, why: NOT_POLARISED_OF_ACTION, pair: None })
    };
    let roots = [&[*lagrangian, decay][..], forces, momenta].concat();
    System {
        facts: if stages.varying { vec![] } else { vec![Fact::ConformalContact] },
        value: None,
        slopes: None,
        rate: None,
        splitting: Some(Err(Missing { marker: "MechanicalIn", term: long, why: FULL_MASS_OF_ACTION, pair: None })),
        modified: None,
        pieces: vec![pieces::kernels(graph, Followed::Contact, (&Err(long), NO_PIECES_OF_VELOCITIES))],
        perturbed: None,
        implicit: Implicit::Herglotz(HerglotzKernels { stages, polarised }),
        integrals: None,
        domain: Domain::of(
            graph,
            Roots { all: &roots, divided: &[*lagrangian] },
            Form::Contact,
            &legendre.partial,
            (None, &[]),
        ),
        lagrangian: None,
        jet: None,
    }
}

/// The terms of the equation of motion of a Lagrangian with an action, and without other forces.
fn euler_lagrange(legendre: &Legendre) -> EulerLagrange<'_> {
    let Legendre { lagrangian, forces, momenta, mass, shift, potential, .. } = legendre;
    EulerLagrange {
        lagrangian: *lagrangian,
        momenta,
        forces,
        mass,
        shift,
        potential: *potential,
        damping: None,
        applied: None,
        has_action: true,
    }
}

/// A stage of collocation, with terms collected.
fn stage(graph: &mut Graph, equation: EulerLagrange<'_>) -> Stage {
    let mut stage = lagrangian::stage(graph, equation);
    stage.collect_terms(graph);
    stage
}

/// The routines `stage` and `force` of a stage of collocation.
fn stage_kernel(stage: Stage) -> Kernel {
    let Stage { momentum, force, momentum_by_q, mass, force_by_q, force_by_v, action } = stage;
    let matrices = [momentum_by_q, mass, force_by_q, force_by_v].map(|matrix| matrix.concat()).concat();
    let (mut all, mut rates) = ([&momentum[..], &force, &matrices].concat(), force);
    if let Some(action) = action {
        all.extend([action.lagrangian, action.decay]);
        all.extend(action.momentum_by_action.into_iter().chain(action.force_by_action));
        all.push(action.decay_by_action);
        rates.push(action.decay);
    }
    Kernel { levels: Levels::Prepared, routines: vec![all, rates] }
}

/// The polarised discrete gradient.
fn polarised(graph: &mut Graph, equation: EulerLagrange<'_>) -> StepKernel<Kernel> {
    let Polarised { unknowns, residual, impulse, matrix, impulse_by_increment } =
        lagrangian::polarised(graph, equation);
    let roots = [residual, impulse, matrix.concat(), impulse_by_increment.concat()].concat();
    StepKernel { unknowns, kernel: Kernel::new(Levels::Iterated, roots) }
}

/// Stages of collocation of L(q, v, s, t).
fn velocity_stages(graph: &mut Graph, legendre: &Legendre) -> VelocityStages<Kernel> {
    let Legendre { momenta, forces, .. } = legendre;
    let mut stage = lagrangian::stage(graph, euler_lagrange(legendre));
    let back = stage.force.iter().chain(&stage.momentum).copied();
    let varying = stage.action.as_ref().is_some_and(|action| analyze::acts_back(graph, action.decay, back));
    stage.collect_terms(graph);
    let reads = |ids: &[Id], of: fn(Reads) -> bool| ids.iter().any(|id| of(graph.reads(*id)));
    let mixed =
        [reads(momenta, |momentum| momentum.q), reads(momenta, |momentum| momentum.s), reads(forces, |force| force.s)];
    VelocityStages { varying, mixed, mass: mass_kernels(graph, legendre), stage: stage_kernel(stage) }
}

/// Stages of collocation of a Lagrangian with an energy, if they are solved for velocities: half of the unknowns. What has a conjugate is not,
/// because all momenta are those of some velocity, but not all velocities have a momentum.
pub(super) fn stages_of_energy(graph: &mut Graph, legendre: &Legendre) -> Option<VelocityStages<Kernel>> {
    is_quadratic(legendre).then(|| velocity_stages(graph, legendre))
}

fn is_quadratic(legendre: &Legendre) -> bool {
    legendre.parts.iter().all(|part| matches!(part.kinetic, Kinetic::Quadratic { .. }))
}

fn mass_kernels(graph: &mut Graph, legendre: &Legendre) -> MassKernels<Kernel> {
    let Legendre { lagrangian, momenta, mass, .. } = legendre;
    let known = collected(graph, &[momenta.clone(), mass.concat()].concat());
    MassKernels {
        mass: Kernel::new(Levels::One, known),
        definite: definite(graph, *lagrangian, momenta.len() as u32).map(|Definite { not_negative, positive }| {
            (not_negative.len(), Kernel::new(Levels::One, [not_negative, positive].concat()))
        }),
        quadratic: is_quadratic(legendre),
    }
}

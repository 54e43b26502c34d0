//! What is derived from L(q, v, t) where velocities are the unknowns of steps.

use super::domain::{Domain, Roots};
use super::exact::pieces::{self, Followed};
use super::facts::Fact;
use super::system::{
    HerglotzKernels, Implicit, MassKernels, Missing, StepKernel, System, VelocityKernels, VelocityStages,
};
use crate::analyze::{self, Damping, Forces, Spared};
use crate::diff::lagrangian::{self, Given};
use crate::ir::collect::collected;
use crate::ir::{Graph, Id, Reads, Symbol};
use crate::legendre::{Definite, Kinetic, Legendre, definite};
use crate::messages::{
    FULL_MASS, FULL_MASS_OF_ACTION, NO_PIECES_OF_VELOCITIES, NOT_POLARISED, NOT_POLARISED_OF_ACTION,
};
use crate::parse::{Form, Shape};
use crate::schedule::{Kernel, Levels};

/// Derives everything that some method needs; `obstacle` is the reason why there is no H.
pub(crate) fn velocities(
    graph: &mut Graph,
    legendre: &Legendre,
    (obstacle, coordinates): (Id, &Shape),
    (damping, others): (Option<&Damping>, Option<&Forces>),
) -> System {
    let Legendre { lagrangian, forces, momenta, mass, shift, potential, .. } = legendre;
    let matrix = damping.map(|damping| &damping.matrix[..]);
    let given = Given { forces, momenta, mass, shift, potential: *potential, damping: matrix, others };
    let (stage, force) = (lagrangian::stage(graph, given), lagrangian::force(graph, given));
    let mut stage = collected(graph, &[stage, force].concat());
    let force = stage.split_off(stage.len() - momenta.len());
    let mut momenta_kept = analyze::noether(graph, legendre.lagrangian, coordinates);
    let spared = Spared { damping, forces: others };
    momenta_kept.retain(|momentum| spared.momentum(graph, momentum));
    let polarised = if is_quadratic(legendre) {
        let equation = lagrangian::polarised(graph, given);
        Ok(Kernel::new(Levels::Iterated, equation))
    } else {
        Err(Missing { marker: "Polarised", term: obstacle, why: NOT_POLARISED, pair: None })
    };
    let summed = match &polarised {
        Ok(_) => {
            let polarisation = lagrangian::polarisation(graph, given);
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
        splitting: Some(Err(Missing { marker: "Uncoupled", term: obstacle, why: FULL_MASS, pair: None })),
        modified: None,
        pieces: vec![],
        perturbed: None,
        implicit: Implicit::Velocities(VelocityKernels {
            increments: (0..degrees).map(Symbol::VelocityIncrement).collect(),
            mass: mass_kernels(graph, legendre),
            stage: Kernel { levels: Levels::Prepared, routines: vec![stage, force] },
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
pub(crate) fn herglotz(graph: &mut Graph, legendre: &Legendre, obstacle: Id) -> System {
    let Legendre { lagrangian, forces, momenta, mass, shift, potential, .. } = legendre;
    let given = Given { forces, momenta, mass, shift, potential: *potential, damping: None, others: None };
    let stages = velocity_stages(graph, legendre);
    let decay = analyze::decay(graph, *lagrangian);
    let polarised = if is_quadratic(legendre) {
        let equation = lagrangian::decaying(graph, given, *lagrangian);
        let kernel = Kernel::new(Levels::Iterated, equation);
        let unknowns =
            (0..momenta.len() as u32).map(Symbol::VelocityIncrement).chain([Symbol::ActionIncrement]).collect();
        Ok(StepKernel { unknowns, kernel })
    } else {
        Err(Missing { marker: "Polarised", term: obstacle, why: NOT_POLARISED_OF_ACTION, pair: None })
    };
    let roots = [&[*lagrangian, decay][..], forces, momenta].concat();
    System {
        facts: if stages.varying { vec![] } else { vec![Fact::ConformalContact] },
        value: None,
        slopes: None,
        rate: None,
        splitting: Some(Err(Missing { marker: "MechanicalIn", term: obstacle, why: FULL_MASS_OF_ACTION, pair: None })),
        modified: None,
        pieces: vec![pieces::kernels(graph, Followed::Contact, (&Err(obstacle), NO_PIECES_OF_VELOCITIES))],
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

/// Stages of collocation of L(q, v, s, t).
fn velocity_stages(graph: &mut Graph, legendre: &Legendre) -> VelocityStages<Kernel> {
    let Legendre { lagrangian, forces, momenta, mass, shift, potential, .. } = legendre;
    let given = Given { forces, momenta, mass, shift, potential: *potential, damping: None, others: None };
    let force = lagrangian::action_force(graph, given, *lagrangian);
    let stage = lagrangian::action_stage(graph, given, *lagrangian);
    let n = momenta.len();
    let varying = analyze::acts_back(graph, force[n], force[..n].iter().chain(momenta).copied());
    let [stage, force] = [stage, force].map(|roots| collected(graph, &roots));
    let reads = |ids: &[Id], of: fn(Reads) -> bool| ids.iter().any(|id| of(graph.reads(*id)));
    let mixed =
        [reads(momenta, |momentum| momentum.q), reads(momenta, |momentum| momentum.s), reads(forces, |force| force.s)];
    VelocityStages {
        varying,
        mixed,
        mass: mass_kernels(graph, legendre),
        stage: Kernel { levels: Levels::Prepared, routines: vec![stage, force] },
    }
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

//! What is derived from L(q, v, t) where velocities are the unknowns of steps.

use super::domain::{Domain, Friction, Roots};
use super::exact::pieces::{self, Followed};
use super::facts::Fact;
use super::system::{
    HerglotzKernels, Implicit, KeptMomentum, MassKernels, Missing, StepKernel, System, VelocityKernels, VelocityStages,
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
use crate::schedule::{Kernel, Levels, Output, Routine, Space};

/// Derives everything that some method needs; `long` is why there is no H.
pub(crate) fn velocities(
    graph: &mut Graph,
    legendre: &Legendre,
    long: Id,
    coordinates: &Shape,
    damping: Option<&Damping>,
    others: Option<&Forces>,
    positions: &[usize],
) -> System {
    let Legendre { lagrangian, forces, momenta, mass, shift, potential, .. } = legendre;
    let matrix = damping.map(|damping| &damping.matrix[..]);
    let given = Given { forces, momenta, mass, shift, potential: *potential, damping: matrix, others };
    let (stage, force) = (lagrangian::stage(graph, given), lagrangian::force(graph, given));
    let mut stages = [
        Routine::new("stage", stage_outputs(&mut stage.into_iter(), positions)),
        Routine::new("force", vec![Output::array("force", positions, force)]),
    ];
    collect(graph, &mut stages);
    let mut momenta_kept = analyze::noether(graph, legendre.lagrangian, coordinates);
    let spared = Spared { damping, forces: others };
    momenta_kept.retain(|momentum| spared.momentum(graph, momentum));
    let polarised = if is_quadratic(legendre) {
        let equation = lagrangian::polarised(graph, given);
        let unknowns = (0..momenta.len() as u32).map(Symbol::VelocityIncrement).collect();
        Ok(polarised_step(equation, unknowns, positions, ["impulse", "impulse_by_d"]))
    } else {
        Err(Missing::new("Polarised", long, NOT_POLARISED))
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
    System {
        facts: vec![],
        value: None,
        gradient: None,
        rate: None,
        splitting: Some(Err(Missing::new("Uncoupled", long, FULL_MASS))),
        modified: None,
        pieces: vec![],
        perturbed: None,
        implicit: Implicit::Velocities(VelocityKernels {
            mass: mass_kernels(graph, legendre, positions),
            stage: Kernel::new(Levels::Prepared, stages.to_vec()),
            keeps: damping.is_none() && others.is_none() && !graph.reads(*lagrangian).t,
            polarised,
            momenta: momenta_kept
                .into_iter()
                .map(|momentum| {
                    let by_gradient = summed.iter().any(|other| other.value == momentum.value);
                    KeptMomentum { momentum, by_gradient }
                })
                .collect(),
        }),
        integrals: None,
        domain: Domain::of(
            graph,
            Roots { all: &roots, divided: &[*lagrangian] },
            Form::Lagrangian,
            &legendre.partial,
            Friction { damping, rates: &[] },
        ),
        lagrangian: None,
        jet: None,
    }
}

/// The same of L(q, v, s, t) with an action.
pub(crate) fn herglotz(graph: &mut Graph, legendre: &Legendre, long: Id, positions: &[usize]) -> System {
    let Legendre { lagrangian, forces, momenta, mass, shift, potential, .. } = legendre;
    let given = Given { forces, momenta, mass, shift, potential: *potential, damping: None, others: None };
    let stages = velocity_stages(graph, legendre, positions);
    let decay = analyze::decay(graph, *lagrangian);
    let polarised = if is_quadratic(legendre) {
        let equation = lagrangian::decaying(graph, given, *lagrangian);
        let unknowns =
            (0..momenta.len() as u32).map(Symbol::VelocityIncrement).chain([Symbol::ActionIncrement]).collect();
        Ok(polarised_step(equation, unknowns, positions, ["increments", "increments_by_d"]))
    } else {
        Err(Missing::new("Polarised", long, NOT_POLARISED_OF_ACTION))
    };
    let roots = [&[*lagrangian, decay][..], forces, momenta].concat();
    System {
        facts: if stages.varying { vec![] } else { vec![Fact::ConformalContact] },
        value: None,
        gradient: None,
        rate: None,
        splitting: Some(Err(Missing::new("MechanicalIn", long, FULL_MASS_OF_ACTION))),
        modified: None,
        pieces: vec![pieces::kernels(graph, Followed::Contact, &Err(long), NO_PIECES_OF_VELOCITIES)],
        perturbed: None,
        implicit: Implicit::Herglotz(HerglotzKernels { stages, polarised }),
        integrals: None,
        domain: Domain::of(
            graph,
            Roots { all: &roots, divided: &[*lagrangian] },
            Form::Contact,
            &legendre.partial,
            Friction::NONE,
        ),
        lagrangian: None,
        jet: None,
    }
}

/// Stages of collocation of L(q, v, s, t).
fn velocity_stages(graph: &mut Graph, legendre: &Legendre, positions: &[usize]) -> VelocityStages {
    let Legendre { lagrangian, forces, momenta, mass, shift, potential, .. } = legendre;
    let given = Given { forces, momenta, mass, shift, potential: *potential, damping: None, others: None };
    let force = lagrangian::action_force(graph, given, *lagrangian);
    let stage = lagrangian::action_stage(graph, given, *lagrangian);
    let n = momenta.len();
    let varying = analyze::acts_back(graph, force[n], force[..n].iter().chain(momenta).copied());
    let mut nodes = stage.into_iter();
    let mut stage = stage_outputs(&mut nodes, positions);
    stage
        .extend(["lagrangian", "decay"].into_iter().zip(nodes.by_ref()).map(|(name, node)| Output::number(name, node)));
    for name in ["momentum_by_s", "force_by_s"] {
        stage.push(Output::array(name, positions, nodes.by_ref().take(n).collect()));
    }
    stage.extend(nodes.next().map(|node| Output::number("decay_by_action", node)));
    let mut nodes = force.into_iter();
    let force = Output::array("force", positions, nodes.by_ref().take(n).collect());
    let decay = nodes.next().map(|node| Output::number("decay", node));
    let (mut stage, mut force) =
        (Routine::new("stage", stage), Routine::new("force", [force].into_iter().chain(decay).collect()));
    collect(graph, std::slice::from_mut(&mut stage));
    collect(graph, std::slice::from_mut(&mut force));
    let reads = |ids: &[Id], of: fn(Reads) -> bool| ids.iter().any(|id| of(graph.reads(*id)));
    let mixed =
        [reads(momenta, |momentum| momentum.q), reads(momenta, |momentum| momentum.s), reads(forces, |force| force.s)];
    VelocityStages {
        varying,
        mixed,
        mass: mass_kernels(graph, legendre, positions),
        stage: Kernel::new(Levels::Prepared, vec![stage, force]),
    }
}

/// Stages of collocation of a Lagrangian with an energy, if they are solved for velocities: half of the unknowns. What has a conjugate is not,
/// because all momenta are those of some velocity, but not all velocities have a momentum.
pub(super) fn stages_of_energy(graph: &mut Graph, legendre: &Legendre, positions: &[usize]) -> Option<VelocityStages> {
    is_quadratic(legendre).then(|| velocity_stages(graph, legendre, positions))
}

fn is_quadratic(legendre: &Legendre) -> bool {
    legendre.parts.iter().all(|part| matches!(part.kinetic, Kinetic::Quadratic { .. }))
}

fn mass_kernels(graph: &mut Graph, legendre: &Legendre, positions: &[usize]) -> MassKernels {
    let Legendre { lagrangian, momenta, mass, .. } = legendre;
    let outputs = vec![Output::array("momentum", positions, momenta.clone()), Output::square("mass", positions, mass)];
    let mut known = Routine::new("mass", outputs);
    collect(graph, std::slice::from_mut(&mut known));
    MassKernels {
        mass: known,
        definite: definite(graph, *lagrangian, momenta.len() as u32).map(|Definite { not_negative, positive }| {
            let outputs = vec![Output::row("not_negative", not_negative), Output::row("positive", positive)];
            Routine::new("is_definite", outputs)
        }),
        quadratic: is_quadratic(legendre),
    }
}

/// ∂L/∂v, the force, and their derivatives by q and v.
fn stage_outputs(nodes: &mut impl Iterator<Item = Id>, positions: &[usize]) -> Vec<Output> {
    let n: usize = positions.iter().product();
    let mut outputs = vec![];
    for name in ["momentum", "force"] {
        outputs.push(Output::array(name, positions, nodes.by_ref().take(n).collect()));
    }
    for name in ["momentum_by_q", "mass", "force_by_q", "force_by_v"] {
        let nodes = nodes.by_ref().take(n * n).collect();
        outputs.push(Output { nodes, ..Output::square(name, positions, &[]) });
    }
    outputs
}

/// The equation of the polarised discrete gradient.
fn polarised_step(
    equation: Vec<Id>,
    unknowns: Vec<Symbol>,
    positions: &[usize],
    names: [&'static str; 2],
) -> StepKernel {
    let unknowns = Space::of_unknowns(unknowns, positions);
    let n = unknowns.len();
    let mut nodes = equation.into_iter();
    let mut outputs = vec![];
    for name in ["residual", names[0]] {
        outputs.push(Output::array(name, &unknowns.extents, nodes.by_ref().take(n).collect()));
    }
    for name in ["matrix", names[1]] {
        let nodes = nodes.by_ref().take(n * n).collect();
        outputs.push(Output { nodes, ..Output::square(name, &unknowns.extents, &[]) });
    }
    let equation = Routine::new("equation", outputs).reading("d", &unknowns);
    StepKernel { unknowns, kernel: Kernel::new(Levels::Iterated, vec![equation]) }
}

/// Collects the terms of all outputs that differ in parameters only.
fn collect(graph: &mut Graph, routines: &mut [Routine]) {
    let nodes: Vec<Id> = routines.iter().flat_map(Routine::nodes).collect();
    let collected = collected(graph, &nodes);
    let outputs = routines.iter_mut().flat_map(|routine| &mut routine.outputs);
    outputs.flat_map(|output| &mut output.nodes).zip(collected).for_each(|(node, collected)| *node = collected);
}

//! Routines of L(q, v, s, t) whose implicit methods solve for velocities.

use super::domain::{Domain, Formulas};
use super::exact::pieces::{self, Followed};
use super::facts::Fact;
use super::system::{
    Decay, KeptMomentum, Kernels, MassKernels, Missing, MixedDerivatives, StepKernel, System, VelocityKernels,
    VelocityStages,
};
use crate::analyze::{self, Acting, Damping, Forces};
use crate::compilation::Compilation;
use crate::diff::lagrangian::{self, EulerLagrange, Polarised};
use crate::ir::collect::collected;
use crate::ir::{Graph, Id};
use crate::legendre::{Definite, Kinetic, Legendre, definite};
use crate::messages::{
    FULL_MASS, FULL_MASS_OF_ACTION, NO_PIECES_OF_VELOCITIES, NOT_POLARISED, NOT_POLARISED_OF_ACTION,
};
use crate::parse::Shape;
use crate::schedule::{Kernel, Levels, Output, Routine, Space};

/// A Lagrangian without a short energy.
pub(crate) struct LagrangianOfVelocities<'a> {
    pub(crate) legendre: &'a Legendre,
    /// The reason why there is no H.
    pub(crate) obstacle: Id,
    /// Friction and forces beside L. Absent with an action.
    pub(crate) damping: Option<&'a Damping>,
    pub(crate) applied: Option<&'a Forces>,
}

/// Derives the routines of every method.
pub(crate) fn velocities(compilation: &mut Compilation<'_>, of: &LagrangianOfVelocities<'_>) -> System {
    let LagrangianOfVelocities { legendre, obstacle, damping, applied } = *of;
    let (positions, has_action) = (compilation.positions(), compilation.form.has_action());
    let (shape, graph) = (&compilation.energy.coordinates.shape, &mut compilation.graph);
    let Legendre { lagrangian, forces, momenta, .. } = legendre;
    let equation = EulerLagrange {
        damping: damping.map(|damping| &damping.matrix[..]),
        applied,
        has_action,
        ..euler_lagrange(legendre)
    };
    let stages = stages(graph, legendre, equation, &positions);
    let mut momenta_kept = if has_action { vec![] } else { analyze::noether(graph, *lagrangian, shape) };
    let acting = Acting { damping, forces: applied };
    momenta_kept.retain(|momentum| !acting.on(graph, momentum));
    let mut roots = vec![*lagrangian];
    if has_action {
        roots.push(analyze::decay(graph, *lagrangian));
    }
    roots.extend(forces.iter().chain(momenta));
    let why = if has_action { NOT_POLARISED_OF_ACTION } else { NOT_POLARISED };
    let (polarised, summed) = match is_quadratic(legendre) {
        true => {
            let step = polarised(graph, equation, &positions);
            (Ok(step), if has_action { vec![] } else { summed_momenta(graph, equation, shape) })
        }
        false => (Err(Missing::new("Polarised", obstacle, why)), vec![]),
    };
    let kept = momenta_kept.into_iter().map(|momentum| {
        let by_gradient = summed.contains(&momentum.value);
        KeptMomentum { momentum, by_gradient }
    });
    let (marker, why) = match has_action {
        true => ("MechanicalIn", FULL_MASS_OF_ACTION),
        false => ("Uncoupled", FULL_MASS),
    };
    let no_pieces = || pieces::kernels(graph, Followed::Contact, &Err(obstacle), NO_PIECES_OF_VELOCITIES);
    let pieces = has_action.then(no_pieces).into_iter().collect();
    let conformal = stages.decay == Decay::OfTime;
    let kernels = Kernels::Velocities(VelocityKernels {
        keeps: !has_action && damping.is_none() && applied.is_none() && !graph.reads(*lagrangian).t,
        stages,
        polarised,
        momenta: kept.collect(),
    });
    // The discrete gradient divides L as a whole, with the parts that do not read velocities.
    let divided = &[*lagrangian];
    let formulas = Formulas { all: &roots, damping, ..Formulas::new(divided, &legendre.partial) };
    System {
        facts: if conformal { vec![Fact::ConformalContact] } else { vec![] },
        splitting: Some(Err(Missing::new(marker, obstacle, why))),
        pieces,
        ..System::new(kernels, Domain::of(graph, compilation.form, formulas))
    }
}

/// Derives stages of collocation of a contact system whose energy belongs to a Lagrangian. Half of the unknowns are velocities. Returns `None` unless L
/// is quadratic in v: other energies may have states whose momenta belong to no velocity.
pub(super) fn stages_of_energy(graph: &mut Graph, legendre: &Legendre, positions: &[usize]) -> Option<VelocityStages> {
    is_quadratic(legendre).then(|| stages(graph, legendre, euler_lagrange(legendre), positions))
}

/// Returns the terms of the equation of motion of a Lagrangian with an action, and without other forces.
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

/// Derives stages of collocation: the routines `stage` and `force`.
fn stages(graph: &mut Graph, legendre: &Legendre, equation: EulerLagrange<'_>, positions: &[usize]) -> VelocityStages {
    let mut stage = lagrangian::stage(graph, equation);
    let back = stage.force.iter().chain(&stage.momentum).copied();
    let decay = match &stage.action {
        None => Decay::None,
        Some(action) if analyze::acts_back(graph, action.decay, back) => Decay::OfState,
        Some(_) => Decay::OfTime,
    };
    stage.collect_terms(graph);
    let lagrangian::Stage { momentum, force, momentum_by_q, mass, force_by_q, force_by_v, action: of_action } = stage;
    let given = |ids: &[Id]| ids.iter().any(|id| !graph.is_zero(*id));
    let mixed = MixedDerivatives {
        momentum_by_q: given(&momentum_by_q.concat()),
        momentum_by_s: of_action.as_ref().is_some_and(|of_action| given(&of_action.momentum_by_action)),
        force_by_v: given(&force_by_v.concat()),
        force_by_s: of_action.as_ref().is_some_and(|of_action| given(&of_action.force_by_action)),
    };
    let vector = |name, nodes| Output::array(name, positions, nodes);
    let (mut all, mut rates) =
        (vec![vector("momentum", momentum), vector("force", force.clone())], vec![vector("force", force)]);
    let matrices =
        [("momentum_by_q", momentum_by_q), ("mass", mass), ("force_by_q", force_by_q), ("force_by_v", force_by_v)];
    all.extend(matrices.map(|(name, rows)| Output::square(name, positions, &rows)));
    let rate_of_decay = of_action.as_ref().map_or(graph.zero(), |of_action| of_action.decay);
    if let Some(of_action) = of_action {
        all.extend([Output::number("lagrangian", of_action.lagrangian), Output::number("decay", of_action.decay)]);
        all.extend([
            vector("momentum_by_s", of_action.momentum_by_action),
            vector("force_by_s", of_action.force_by_action),
        ]);
        all.push(Output::number("decay_by_action", of_action.decay_by_action));
    }
    rates.push(Output::number("decay", rate_of_decay));
    let routines = vec![Routine::new("stage", all), Routine::new("force", rates)];
    VelocityStages {
        decay,
        mixed,
        mass: mass_kernels(graph, legendre, positions),
        stage: Kernel::new(Levels::Prepared, routines),
    }
}

/// Derives the polarised discrete gradient: the routine `equation`.
fn polarised(graph: &mut Graph, equation: EulerLagrange<'_>, positions: &[usize]) -> StepKernel {
    let Polarised { unknowns, residual, impulse, matrix, impulse_by_increment } =
        lagrangian::polarised(graph, equation);
    let unknowns = Space::of_unknowns(unknowns, positions);
    let outputs = vec![
        Output::array("residual", &unknowns.extents, residual),
        Output::array("increments", &unknowns.extents, impulse),
        Output::square("matrix", &unknowns.extents, &matrix),
        Output::square("increments_by_d", &unknowns.extents, &impulse_by_increment),
    ];
    let equation = Routine::new("equation", outputs).reading("d", &unknowns);
    StepKernel { unknowns, kernel: Kernel::new(Levels::Iterated, vec![equation]) }
}

/// Returns the momenta that the polarised discrete gradient keeps.
fn summed_momenta(graph: &mut Graph, equation: EulerLagrange<'_>, shape: &Shape) -> Vec<Id> {
    let polarisation = lagrangian::polarisation(graph, equation);
    analyze::translations(graph, polarisation, shape).into_iter().map(|momentum| momentum.value).collect()
}

/// Returns whether L is quadratic in v.
fn is_quadratic(legendre: &Legendre) -> bool {
    legendre.parts.iter().all(|part| matches!(part.kinetic, Kinetic::Quadratic { .. }))
}

/// Derives ∂L/∂v and M. Terms that differ in parameters only are collected.
fn mass_kernels(graph: &mut Graph, legendre: &Legendre, positions: &[usize]) -> MassKernels {
    let Legendre { lagrangian, momenta, mass, .. } = legendre;
    let mut outputs = [Output::array("momentum", positions, momenta.clone()), Output::square("mass", positions, mass)];
    let nodes: Vec<Id> = outputs.iter().flat_map(|output| &output.nodes).copied().collect();
    let all = outputs.iter_mut().flat_map(|output| &mut output.nodes);
    all.zip(collected(graph, &nodes)).for_each(|(node, collected)| *node = collected);
    MassKernels {
        mass: Routine::new("mass", outputs.to_vec()),
        definite: definite(graph, *lagrangian, momenta.len() as u32).map(|Definite { not_negative, positive }| {
            let outputs = vec![Output::row("not_negative", not_negative), Output::row("positive", positive)];
            Routine::new("is_definite", outputs)
        }),
        quadratic: is_quadratic(legendre),
    }
}

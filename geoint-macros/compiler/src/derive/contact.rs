//! Routines of H(q, p, s, t).

use super::domain::{Domain, Formulas};
use super::exact::pieces::{self, Followed};
use super::facts::Fact;
use super::jet::{self, JetKernel};
use super::system::{
    ContactKernels, ContactStages, FlowKernel, GradientKick, Kernels, KickDrift, Missing, Modified, System, Undamped,
};
use super::{implicit, velocities};
use crate::analyze;
use crate::compilation::Compilation;
use crate::diff::{Gradient, equations};
use crate::ir::{Graph, Id, UndefinedAt};
use crate::legendre::Legendre;
use crate::messages::{NO_PIECES, NOT_MECHANICAL, NOT_NYSTROM};
use crate::schedule::{Levels, Output, Routine, phase};
use crate::split::{self, Clock, Flow, Mechanics, Pieces};

/// The energy of a contact system, and its decompositions.
pub(crate) struct ContactEnergy<'a> {
    pub(crate) energy: Id,
    pub(crate) gradient: &'a Gradient,
    /// Flows in closed form.
    pub(crate) pieces: &'a Pieces,
    /// T + g·s + V, or the term that does not fit.
    pub(crate) mechanics: &'a Result<Mechanics, Id>,
    /// True if the system is the lift of a field. Its momenta are not followed.
    pub(crate) lift: bool,
    /// The Lagrangian of the energy.
    pub(crate) legendre: Option<&'a Legendre>,
}

/// Derives the routines of every method.
pub(crate) fn contact(compilation: &mut Compilation<'_>, of: &ContactEnergy<'_>, partial: &[UndefinedAt]) -> System {
    let ContactEnergy { energy, gradient, pieces: found, mechanics, lift, legendre } = *of;
    let (degrees, positions, graph) = (compilation.degrees(), compilation.positions(), &mut compilation.graph);
    let rates = lift.then(|| equations::lift(graph, energy, gradient).concat());
    let forms = match &rates {
        Some(rates) => vec![rates.clone()],
        None => all_rates(graph, energy, gradient, legendre),
    };
    let jet = JetKernel::canonical(graph, &forms, energy, degrees);
    let rate = rates.map(|rates| rate_routine(rates, &positions));
    let followed = if lift { Followed::Lift } else { Followed::Contact };
    let pieces = pieces::kernels(graph, followed, found, NO_PIECES);
    let modified = found.as_ref().ok().filter(|_| !lift).map(|found| {
        let modified = split::modified_energy(graph, &found.pieces, degrees);
        Modified::Value(Routine::number("modified", modified))
    });
    let splitting = match mechanics {
        Ok(mechanics) => Ok(kick_drift(graph, mechanics)),
        Err(term) => Err(Missing::new("MechanicalIn", *term, NOT_MECHANICAL)),
    };
    // The rates of positions and momenta do not read s, and friction reads time alone.
    let conformal = !analyze::acts_back(graph, gradient.s, gradient.q.iter().chain(&gradient.p).copied());
    let by_velocities = legendre.and_then(|legendre| velocities::stages_of_energy(graph, legendre, &positions));
    let stages = match by_velocities {
        Some(stages) => ContactStages::Velocities(Box::new(stages)),
        None => ContactStages::Points(implicit::stages(graph, energy, gradient, &positions)),
    };
    let kernels = if lift {
        ContactKernels { steps: vec![], stages: None }
    } else {
        ContactKernels { steps: implicit::steps(graph, energy, degrees, &positions), stages: Some(stages) }
    };
    let domain = Domain::of(graph, compilation.form, Formulas::new(&[energy], partial));
    System {
        facts: if conformal { vec![Fact::ConformalContact] } else { vec![] },
        value: (!lift).then(|| Routine::number("hamiltonian", energy)),
        gradient: Some(gradient_routine(gradient, &positions)),
        rate,
        splitting: Some(splitting),
        modified,
        pieces: vec![pieces],
        jet,
        ..System::new(Kernels::Contact(kernels), domain)
    }
}

/// Creates the routine of ∂H/∂q, ∂H/∂p and ∂H/∂s.
pub(super) fn gradient_routine(gradient: &Gradient, positions: &[usize]) -> Routine {
    let slopes = Output::array("slopes", &phase(positions), [&gradient.q[..], &gradient.p].concat());
    Routine::new("gradient", vec![slopes, Output::number("ds", gradient.s)])
}

/// Creates the routine of q', p' and s'.
pub(super) fn rate_routine(mut rates: Vec<Id>, positions: &[usize]) -> Routine {
    let action = rates.pop().map(|rate| Output::number("ds", rate));
    let slopes = Output::array("slopes", &phase(positions), rates);
    Routine::new("rate", [slopes].into_iter().chain(action).collect())
}

/// Returns the rates of q, p and s for every known form of the gradient.
fn all_rates(graph: &mut Graph, energy: Id, gradient: &Gradient, legendre: Option<&Legendre>) -> Vec<Vec<Id>> {
    let forms = jet::forms(graph, energy, gradient, legendre);
    let mut rates = |gradient: &Gradient| {
        let momenta = equations::momenta(graph, gradient);
        equations::contact(graph, energy, gradient, &momenta, &momenta).concat()
    };
    forms.iter().map(&mut rates).collect()
}

/// Derives kick and drift of an energy T + g·s + V.
fn kick_drift(graph: &mut Graph, mechanics: &Mechanics) -> KickDrift {
    let [kick, damped_drift] = [&mechanics.kick, &mechanics.drift].map(|flow| {
        let changed = flow.changed(graph);
        FlowKernel::with_increments(graph, Levels::Prepared, changed)
    });
    // Flows without damping only add increments.
    let mut kernel = |flow: &Flow| FlowKernel::new(Levels::Prepared, flow.changed(graph));
    KickDrift {
        kick,
        drift: damped_drift,
        time_passes_in_drift: mechanics.clock == Clock::Own,
        kicks_repeat: false,
        kicks_show: false,
        undamped: Some(Undamped {
            kick: (mechanics.free_kick != mechanics.kick).then(|| kernel(&mechanics.free_kick)),
            drift: (mechanics.free_drift != mechanics.drift).then(|| kernel(&mechanics.free_drift)),
            damping: Routine::number("damping", mechanics.damping),
        }),
        gradient_kick: match &mechanics.gradient_kick {
            Ok(flow) => Ok(GradientKick::Flow(kernel(flow))),
            Err(term) => Err(Missing::new("NystromIn", *term, NOT_NYSTROM)),
        },
    }
}

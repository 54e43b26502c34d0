//! What is derived from H(q, p, s, t).

use super::domain::{Domain, Roots};
use super::exact::pieces::{self, Followed};
use super::facts::Fact;
use super::jet::{self, JetKernel};
use super::system::{
    ContactKernels, ContactStages, FlowKernel, GradientKick, Implicit, KickDrift, Missing, Modified, System, Undamped,
};
use super::{implicit, velocities};
use crate::analyze;
use crate::diff::{self, Gradient, equations};
use crate::ir::{Graph, Id, Partial};
use crate::legendre::Legendre;
use crate::messages::{NO_PIECES, NOT_MECHANICAL, NOT_NYSTROM};
use crate::parse::Form;
use crate::schedule::{Kernel, Levels};
use crate::split::{self, Clock, Flow, Mechanics, Pieces};

/// Derives everything that some method needs. The momenta of a lift are not followed.
pub(crate) fn contact(
    graph: &mut Graph,
    energy: Id,
    (found, mechanics): (&Pieces, &Result<Mechanics, Id>),
    partial: &[Partial],
    (degrees, lift): (u32, bool),
    legendre: Option<&Legendre>,
) -> (System, Gradient) {
    let gradient = diff::gradient(graph, energy, degrees);
    let rates = lift.then(|| equations::lift(graph, energy, &gradient).concat());
    let followed = match &rates {
        Some(rates) => vec![rates.clone()],
        None => all_rates(graph, energy, &gradient, legendre),
    };
    let jet = JetKernel::canonical(graph, &followed, (energy, degrees));
    let rate = rates.map(|rates| Kernel::new(Levels::One, rates));
    let what = if lift { Followed::Lift } else { Followed::Contact };
    let pieces = pieces::kernels(graph, what, (found, NO_PIECES));
    let modified = found.as_ref().ok().filter(|_| !lift).map(|found| {
        let modified = split::modified_energy(graph, &found.pieces, degrees);
        Modified::Value(Kernel::new(Levels::One, vec![modified]))
    });
    let splitting = match mechanics {
        Ok(mechanics) => Ok(kick_drift(graph, mechanics)),
        Err(term) => Err(Missing { marker: "MechanicalIn", term: *term, why: NOT_MECHANICAL, pair: None }),
    };
    // Positions and momenta move without s.
    let conformal = !analyze::acts_back(graph, gradient.s, gradient.q.iter().chain(&gradient.p).copied());
    let by_velocities = legendre.and_then(|legendre| velocities::stages_of_energy(graph, legendre));
    let stages = match by_velocities {
        Some(stages) => ContactStages::Velocities(stages),
        None => ContactStages::Points(implicit::stages(graph, energy, &gradient)),
    };
    let system = System {
        facts: if conformal { vec![Fact::ConformalContact] } else { vec![] },
        value: (!lift).then(|| Kernel::new(Levels::One, vec![energy])),
        slopes: Some(Kernel::new(Levels::One, [&gradient.q[..], &gradient.p, &[gradient.s]].concat())),
        rate,
        splitting: Some(splitting),
        perturbed: None,
        modified,
        pieces: vec![pieces],
        implicit: Implicit::Contact(if lift {
            ContactKernels { steps: vec![], stages: None }
        } else {
            ContactKernels { steps: implicit::steps(graph, energy, degrees), stages: Some(stages) }
        }),
        integrals: None,
        lagrangian: None,
        jet,
        domain: Domain::of(graph, Roots::of_energy(&energy), Form::Contact, partial, (None, &[])),
    };
    (system, gradient)
}

/// The rates of q, p and s for every known form of the gradient.
fn all_rates(graph: &mut Graph, energy: Id, gradient: &Gradient, legendre: Option<&Legendre>) -> Vec<Vec<Id>> {
    let forms = jet::forms(graph, energy, gradient, legendre);
    let mut rates = |gradient: &Gradient| {
        let momenta = equations::momenta(graph, gradient);
        equations::contact(graph, energy, gradient, &momenta, &momenta).concat()
    };
    forms.iter().map(&mut rates).collect()
}

fn kick_drift(graph: &mut Graph, mechanics: &Mechanics) -> KickDrift<Kernel> {
    let (drift, clock) = &mechanics.drift;
    let [kick, damped_drift] = [&mechanics.kick, drift].map(|flow| {
        let changed = flow.changed(graph);
        FlowKernel::with_increments(graph, Levels::Prepared, changed)
    });
    // Without damping flows add.
    let mut kernel = |flow: &Flow| FlowKernel::new(Levels::Prepared, flow.changed(graph));
    KickDrift {
        kick,
        drift: damped_drift,
        exact_in_time: *clock == Clock::Own,
        repeats: false,
        shows: false,
        undamped: Some(Undamped {
            kick: (mechanics.free_kick != mechanics.kick).then(|| kernel(&mechanics.free_kick)),
            drift: (mechanics.free_drift != *drift).then(|| kernel(&mechanics.free_drift)),
            damping: Kernel::new(Levels::One, vec![mechanics.damping]),
        }),
        gradient_kick: match &mechanics.gradient_kick {
            Ok(flow) => Ok(GradientKick::Flow(kernel(flow))),
            Err(term) => Err(Missing { marker: "NystromIn", term: *term, why: NOT_NYSTROM, pair: None }),
        },
    }
}

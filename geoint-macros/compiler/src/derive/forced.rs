//! What is derived from H(q, p, s, t) with forces beside it, p' = −∂H/∂q − p ∂H/∂s + F − ∂R/∂v: rates alone, because no step is a contact map.

use super::contact::{gradient_routine, rate_routine};
use super::domain::{Domain, Friction, Roots};
use super::exact::pieces::{self, Followed};
use super::jet::JetKernel;
use super::system::{ContactKernels, Implicit, Missing, System};
use crate::analyze::{Damping, Forces};
use crate::diff::{self, equations};
use crate::ir::{Graph, Id, Symbol, UndefinedAt};
use crate::messages::FORCED_ACTION;
use crate::parse::Form;
use crate::schedule::Routine;

/// A system with an action and forces beside its energy.
pub(crate) struct Forced {
    pub(crate) system: System,
    /// ∂R/∂v of a quadratic Rayleigh function R.
    pub(crate) drag: Option<Vec<Id>>,
}

/// Derives rates, and the Taylor coefficients of solutions.
pub(crate) fn forced(
    graph: &mut Graph,
    energy: Id,
    damping: Option<&Damping>,
    forces: Option<&Forces>,
    partial: &[UndefinedAt],
    positions: &[usize],
) -> Forced {
    let degrees = positions.iter().product::<usize>() as u32;
    let gradient = diff::gradient(graph, energy, degrees);
    let rates = equations::forced_contact(graph, energy, &gradient, damping, forces).concat();
    let velocities: Vec<Id> = (0..degrees).map(|i| graph.symbol(Symbol::Velocity(i))).collect();
    let drag = damping.map(|damping| damping.drag(graph, &velocities));
    let applied = forces.iter().flat_map(|forces| [&forces.applied, &forces.friction]).flatten().flatten();
    let term = applied.chain(drag.iter().flatten()).copied().find(|force| !graph.is_zero(*force)).unwrap_or(energy);
    let jet = JetKernel::canonical(graph, std::slice::from_ref(&rates), energy, degrees);
    let system = System {
        facts: vec![],
        value: Some(Routine::number("hamiltonian", energy)),
        gradient: Some(gradient_routine(&gradient, positions)),
        rate: Some(rate_routine(rates.clone(), positions)),
        splitting: Some(Err(Missing::new("MechanicalIn", term, FORCED_ACTION))),
        perturbed: None,
        modified: None,
        pieces: vec![pieces::kernels(graph, Followed::Contact, &Err(term), FORCED_ACTION)],
        implicit: Implicit::Contact(ContactKernels { steps: vec![], stages: None }),
        integrals: None,
        lagrangian: None,
        jet,
        domain: Domain::of(
            graph,
            Roots::of_energy(&energy),
            Form::Contact,
            partial,
            Friction { damping, rates: &rates },
        ),
    };
    Forced { system, drag }
}

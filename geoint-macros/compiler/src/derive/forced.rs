//! What is derived from H(q, p, s, t) with forces beside it, p' = −∂H/∂q − p ∂H/∂s + F − ∂R/∂v: rates alone, because no step is a contact map.

use super::domain::{Domain, Roots};
use super::exact::pieces::{self, Followed};
use super::jet::JetKernel;
use super::system::{ContactKernels, Implicit, Missing, System};
use crate::analyze::{Damping, Forces};
use crate::diff::{self, equations};
use crate::ir::{Graph, Id, Partial, Symbol};
use crate::messages::FORCED_ACTION;
use crate::parse::Form;
use crate::schedule::{Kernel, Levels};

/// Derives everything that some method needs; and ∂R/∂v where R is a quadratic form.
pub(crate) fn forced(
    graph: &mut Graph,
    energy: Id,
    (damping, forces): (Option<&Damping>, Option<&Forces>),
    partial: &[Partial],
    degrees: u32,
) -> (System, Option<Vec<Id>>) {
    let gradient = diff::gradient(graph, energy, degrees);
    let rates = equations::forced_contact(graph, energy, &gradient, damping, forces).concat();
    let velocities: Vec<Id> = (0..degrees).map(|i| graph.symbol(Symbol::Velocity(i))).collect();
    let drag = damping.map(|damping| damping.drag(graph, &velocities));
    let applied = forces.iter().flat_map(|forces| [&forces.applied, &forces.friction]).flatten().flatten();
    let term = applied.chain(drag.iter().flatten()).copied().find(|force| !graph.is_zero(*force)).unwrap_or(energy);
    let jet = JetKernel::canonical(graph, std::slice::from_ref(&rates), (energy, degrees));
    let system = System {
        facts: vec![],
        value: Some(Kernel::new(Levels::One, vec![energy])),
        slopes: Some(Kernel::new(Levels::One, [&gradient.q[..], &gradient.p, &[gradient.s]].concat())),
        rate: Some(Kernel::new(Levels::One, rates.clone())),
        splitting: Some(Err(Missing { marker: "MechanicalIn", term, why: FORCED_ACTION, pair: None })),
        perturbed: None,
        modified: None,
        pieces: vec![pieces::kernels(graph, Followed::Contact, (&Err(term), FORCED_ACTION))],
        implicit: Implicit::Contact(ContactKernels { steps: vec![], stages: None }),
        integrals: None,
        lagrangian: None,
        jet,
        domain: Domain::of(graph, Roots::of_energy(&energy), Form::Contact, partial, (damping, &rates)),
    };
    (system, drag)
}

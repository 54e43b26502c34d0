//! Routines of H(q, p, s, t) with forces beside it: p' = −∂H/∂q − p ∂H/∂s + F − ∂R/∂v. Only rates are derived, because no step is a contact map.

use super::contact::{gradient_routine, rate_routine};
use super::domain::{Domain, Formulas};
use super::exact::pieces::{self, Followed};
use super::jet::JetKernel;
use super::system::{ContactKernels, Kernels, Missing, System};
use crate::analyze::{Damping, Forces};
use crate::compilation::Compilation;
use crate::diff::{self, equations};
use crate::ir::{Id, Symbol, UndefinedAt};
use crate::messages::FORCED_ACTION;
use crate::schedule::Routine;

/// A system with an action and forces beside its energy.
pub(crate) struct Forced {
    pub(crate) system: System,
    /// ∂R/∂v of a quadratic Rayleigh function R.
    pub(crate) drag: Option<Vec<Id>>,
}

/// Derives the rates, and the Taylor coefficients of solutions.
pub(crate) fn forced(
    compilation: &mut Compilation<'_>,
    energy: Id,
    damping: Option<&Damping>,
    forces: Option<&Forces>,
    partial: &[UndefinedAt],
) -> Forced {
    let (degrees, positions, graph) = (compilation.degrees(), compilation.positions(), &mut compilation.graph);
    let gradient = diff::gradient(graph, energy, degrees);
    let rates = equations::forced_contact(graph, energy, &gradient, damping, forces).concat();
    let velocities: Vec<Id> = (0..degrees).map(|i| graph.symbol(Symbol::Velocity(i))).collect();
    let drag = damping.map(|damping| damping.drag(graph, &velocities));
    let applied = forces.iter().flat_map(|forces| [&forces.applied, &forces.friction]).flatten().flatten();
    let term = applied.chain(drag.iter().flatten()).copied().find(|force| !graph.is_zero(*force)).unwrap_or(energy);
    let jet = JetKernel::canonical(graph, std::slice::from_ref(&rates), energy, degrees);
    let pieces = pieces::kernels(graph, Followed::Contact, &Err(term), FORCED_ACTION);
    let formulas = &[energy];
    let formulas = Formulas { damping, rates: &rates, ..Formulas::new(formulas, partial) };
    let domain = Domain::of(graph, compilation.form, formulas);
    let system = System {
        value: Some(Routine::number("hamiltonian", energy)),
        gradient: Some(gradient_routine(&gradient, &positions)),
        rate: Some(rate_routine(rates, &positions)),
        splitting: Some(Err(Missing::new("MechanicalIn", term, FORCED_ACTION))),
        pieces: vec![pieces],
        jet,
        ..System::new(Kernels::Contact(ContactKernels { steps: vec![], stages: None }), domain)
    };
    Forced { system, drag }
}

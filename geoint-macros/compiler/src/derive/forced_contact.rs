//! Systems of H(q, p, s, t) with forces F, or a Rayleigh function R, or both, in terms of v = ∂H/∂p:
//!
//! q' = v, p' = −∂H/∂q − p ∂H/∂s + F − ∂R/∂v, s' = p·v − H.
//!
//! With forces, the flow is no contact map, so methods that preserve the contact form are absent. Taylor methods and the methods of Runge and Kutta remain. They
//! use the energy, its gradient, rates, the domain, and Taylor coefficients.

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

/// A contact system with forces beside its energy.
pub(crate) struct ForcedContact {
    pub(crate) system: System,
    /// ∂R/∂v of a quadratic Rayleigh function R, in terms of the symbols of v. The report shows it.
    pub(crate) drag: Option<Vec<Id>>,
}

/// Derives the system. `damping` is a quadratic Rayleigh function. `forces` contains F, and the friction of other Rayleigh functions. At least one is present.
/// `partial` lists the nodes of the energy that are undefined at some states.
pub(crate) fn forced_contact(
    compilation: &mut Compilation<'_>,
    energy: Id,
    damping: Option<&Damping>,
    forces: Option<&Forces>,
    partial: &[UndefinedAt],
) -> ForcedContact {
    let (degrees, positions, graph) = (compilation.degrees(), compilation.positions(), &mut compilation.graph);
    let gradient = diff::gradient(graph, energy, degrees);
    let rates = equations::forced_contact(graph, energy, &gradient, damping, forces).concat();
    let velocities: Vec<Id> = (0..degrees).map(|i| graph.symbol(Symbol::Velocity(i))).collect();
    let drag = damping.map(|damping| damping.drag(graph, &velocities));
    let applied = forces.iter().flat_map(|forces| [&forces.applied, &forces.friction]).flatten().flatten();
    // Messages about absent methods point at the first force that acts.
    let obstacle = applied.chain(drag.iter().flatten()).copied().find(|force| !graph.is_zero(*force)).unwrap_or(energy);
    // One rate for each coordinate, in one piece.
    let jet = JetKernel::canonical(graph, std::slice::from_ref(&rates), energy, degrees);
    // There are no pieces. Their absence is reported with a reason.
    let pieces = pieces::kernels(graph, Followed::Contact, &Err(obstacle), FORCED_ACTION);
    let values = &[energy];
    let formulas = Formulas { damping, rates: &rates, ..Formulas::new(values, partial) };
    let domain = Domain::of(graph, compilation.form, formulas);
    let system = System {
        value: Some(Routine::number("hamiltonian", energy)),
        gradient: Some(gradient_routine(&gradient, &positions)),
        rate: Some(rate_routine(rates, &positions)),
        // The name of the trait appears in rustc's error about an absent method.
        splitting: Some(Err(Missing::new("MechanicalIn", obstacle, FORCED_ACTION))),
        pieces: vec![pieces],
        jet,
        ..System::new(Kernels::Contact(ContactKernels { steps: vec![], stages: None }), domain)
    };
    ForcedContact { system, drag }
}

//! Equations of implicit methods: fields with derivatives for collocation, fields with divided differences for discrete gradients, and equations of whole
//! steps.

mod canonical;
mod collocation;
mod constraints;
mod contact;
mod discrete;
mod methods;
mod prepared;
mod velocities;

use super::context::Context;
use super::exact;
use super::implementation::flag;
use crate::derive::{ContactStages, Fact, FieldKernels, Kernels, System};
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the implementations for implicit methods.
pub(super) fn implicit(context: &Context<'_>, system: &System) -> TokenStream {
    match &system.kernels {
        Kernels::Field(kernels) => field(context, kernels, system),
        Kernels::Bodies(kernels) => exact::bodies(context, kernels),
        Kernels::Constrained(kernels) => constraints::constraints(context, kernels),
        Kernels::Velocities(kernels) => velocities::velocities(context, kernels),
        Kernels::Contact(kernels) => {
            let steps = kernels.steps.iter().map(|(method, step)| contact::step(context, method, step));
            let stages = kernels.stages.as_ref().map(|stages| {
                let stages = match stages {
                    ContactStages::Points(stages) => contact::stages(context, stages),
                    ContactStages::Velocities(stages) => velocities::stages(context, stages),
                };
                let solved = ["ContactMidpoint", "ContactDiscreteGradient"];
                let solved = solved.map(|method| methods::solved_by(context, method, "ContactStep"));
                quote!(#(#solved)* #stages)
            });
            quote!(#(#steps)* #stages)
        }
    }
}

/// Returns the implementations for a system that is given by its field.
fn field(context: &Context<'_>, field: &FieldKernels, system: &System) -> TokenStream {
    let kept = kept(field, system);
    // The conserved quantities of this field are nowhere steep.
    let nowhere_steep = system.integrals.as_ref().filter(|integrals| !integrals.steep).map(|_| flag("STEEP", false));
    let discrete = field.discrete.as_ref();
    let discrete = discrete.map(|kernel| discrete::discrete_field(context, field, kernel, &kept, nowhere_steep));
    let nothing_kept = field.nothing_kept.map(|missing| discrete::nothing_kept(context, missing));
    let fourth = match &field.fourth {
        Some(plan) => Some(discrete::fourth_order(context, field, plan)),
        None => {
            system.has(Fact::Conservative).then(|| discrete::canonical_fourth_order(context, &field.momenta, system))
        }
    };
    let forward = field.forward.map(|missing| discrete::no_fourth_order(context, missing));
    let collocation = collocation::collocation(context, field);
    let canonical = field.canonical.as_ref().map(|plan| canonical::canonical(context, plan));
    quote!(#discrete #nothing_kept #fourth #forward #collocation #canonical)
}

/// Returns the type of the quantities that steps along discrete gradients keep: the energy, with momenta if there are some, or the integrals of a field.
/// The integrals do not depend on time.
fn kept(field: &FieldKernels, system: &System) -> TokenStream {
    let autonomous = system.has(Fact::Autonomous);
    match &system.integrals {
        None if !field.momenta.nodes().is_empty() => quote!(EnergyAndMomenta<#autonomous>),
        None if autonomous => quote!(CanonicalEnergy),
        Some(integrals) if !integrals.steady.is_empty() => quote!(KeptIntegrals),
        _ => quote!(()),
    }
}

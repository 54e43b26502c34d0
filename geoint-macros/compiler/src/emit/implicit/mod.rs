//! What implicit methods solve: fields with derivatives for collocation, with divided differences for discrete gradients; and the equations
//! of whole steps.

mod canonical;
mod collocation;
mod constraints;
mod contact;
mod discrete;
mod prepared;
mod velocities;

use super::exact;
use super::kernel::Context;
use super::structure::self_type;
use crate::derive::{ContactStages, Fact, FieldKernels, Kernels, System};

use proc_macro2::TokenStream;
use quote::quote;

/// The implementations for implicit methods, of any form.
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
                    ContactStages::Velocities(stages) => velocities::stages(context, stages, &quote!(ByField)),
                };
                let name = self_type(context);
                quote! {
                    impl<R: Real> ContactGraded<R> for #name {
                        type Proof = ();
                        type Gradient = ByTree;
                    }
                    #stages
                }
            });
            quote!(#(#steps)* #stages)
        }
    }
}

fn field(context: &Context<'_>, field: &FieldKernels, system: &System) -> TokenStream {
    let kept = kept(field, system);
    let discrete = field
        .discrete
        .as_ref()
        .map(|kernel| discrete::discrete_field(context, field, kernel, &kept, nowhere_steep(system)));
    let nothing_kept = field.nothing_kept.map(|missing| discrete::nothing_kept(context, missing));
    let fourth = match &field.fourth {
        Some(plan) => Some(discrete::fourth_order(context, field, plan)),
        None => system.has(Fact::Conservative).then(|| {
            let autonomous = system.has(Fact::Autonomous);
            discrete::canonical_fourth_order(context, &field.momenta, autonomous)
        }),
    };
    let collocation = collocation::collocation(context, field);
    let canonical = field.canonical.as_ref().map(|plan| canonical::canonical(context, plan));
    quote!(#discrete #nothing_kept #fourth #collocation #canonical)
}

/// What steps along discrete gradients keep and does not read time: the energy and the momenta beside it, or all integrals of a field.
fn kept(field: &FieldKernels, system: &System) -> TokenStream {
    let autonomous = system.has(Fact::Autonomous);
    match &system.integrals {
        None if !field.momenta.nodes().is_empty() => quote!(EnergyAndMomenta<#autonomous>),
        None if autonomous => quote!(CanonicalEnergy),
        Some(integrals) if !integrals.steady.is_empty() => quote!(KeptIntegrals),
        _ => quote!(()),
    }
}

/// That what a field keeps is nowhere steep, if so.
fn nowhere_steep(system: &System) -> Option<TokenStream> {
    let steep = system.integrals.as_ref().is_none_or(|integrals| integrals.steep);
    (!steep).then(|| {
        quote!(
            const STEEP: bool = false;
        )
    })
}

//! What implicit methods solve: fields with derivatives for collocation, with divided differences for discrete gradients; and the equations
//! of whole steps.

mod canonical;
mod collocation;
mod constraints;
mod contact;
mod discrete;
mod herglotz;
mod prepared;
mod velocities;

use super::kernel::{Context, write};
use super::structure::self_type;
use super::tokens::Tokens;
use crate::derive::{ContactStages, Fact, FieldKernels, Implicit, MOST_UNKNOWNS, System};
use crate::ir::{Graph, Number};
use crate::schedule::{Block, Operand, Plan};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The implementations for implicit methods, of any form.
pub(super) fn implicit(context: &Context<'_>, graph: &Graph, system: &System<Plan>) -> TokenStream {
    match &system.implicit {
        Implicit::Field(kernels) => field(context, graph, (kernels, system)),
        Implicit::Constrained(kernels) => constraints::constraints(context, graph, kernels),
        Implicit::Velocities(kernels) => velocities::velocities(context, graph, kernels),
        Implicit::Herglotz(kernels) => herglotz::herglotz(context, graph, kernels),
        Implicit::Contact(kernels) => {
            let steps = kernels.steps.iter().map(|(method, step)| contact::step(context, method, step));
            let stages = kernels.stages.as_ref().map(|stages| {
                let stages = match stages {
                    ContactStages::Points(stages) => contact::stages(context, stages),
                    ContactStages::Velocities(stages) => herglotz::stages(context, stages, &quote!(ByField)),
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

fn field(context: &Context<'_>, graph: &Graph, (field, system): (&FieldKernels<Plan>, &System<Plan>)) -> TokenStream {
    let kept = kept(field, system);
    let discrete = field
        .discrete
        .as_ref()
        .map(|plan| discrete::discrete_field(context, field, (plan, kept, nowhere_steep(system))));
    let nothing_kept = field.nothing_kept.map(|missing| discrete::nothing_kept(context, graph, missing));
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
fn kept(field: &FieldKernels<Plan>, system: &System<Plan>) -> TokenStream {
    let autonomous = system.has(Fact::Autonomous);
    match &system.integrals {
        None if !field.momenta.last[0].results.is_empty() => quote!(EnergyAndMomenta<#autonomous>),
        None if autonomous => quote!(CanonicalEnergy),
        Some(integrals) if !integrals.steady.is_empty() => quote!(KeptIntegrals),
        _ => quote!(()),
    }
}

/// That what a field keeps is nowhere steep, if so.
fn nowhere_steep(system: &System<Plan>) -> Option<TokenStream> {
    let steep = system.integrals.as_ref().is_none_or(|integrals| integrals.steep);
    (!steep).then(|| {
        quote!(
            const STEEP: bool = false;
        )
    })
}

/// The places of a square matrix, row by row.
pub(super) fn square(places: &[Vec<usize>]) -> Vec<Vec<usize>> {
    places.iter().flat_map(|row| places.iter().map(move |column| [&row[..], &column[..]].concat())).collect()
}

/// The statements that write vectors, then matrices, from all their entries in a row.
pub(super) fn write_derivatives(
    places: &[Vec<usize>],
    (vectors, matrices): (&[&str], &[&str]),
    values: &[Tokens],
) -> TokenStream {
    let n = places.len();
    let (of_vectors, of_matrices) = values.split_at(vectors.len() * n);
    let vectors = vectors.iter().zip(of_vectors.chunks(n)).map(|(name, entries)| write(name, places, entries));
    let squares = square(places);
    let matrices = matrices.iter().zip(of_matrices.chunks(n * n)).map(|(name, entries)| write(name, &squares, entries));
    quote!(#(#vectors)* #(#matrices)*)
}

/// The statements that write f and its derivative, the results of a block. Of many unknowns most depend on few others: entries that are
/// zero are written all at once.
pub(super) fn write_field(context: &Context<'_>, names: [&str; 2], block: &Block, values: &[Tokens]) -> TokenStream {
    let unknowns = values.len().isqrt();
    let places = context.unknown_places(unknowns);
    let (f, jacobian) = values.split_at(unknowns);
    let f = write(names[0], &places, f);
    let places = square(&places);
    if unknowns <= MOST_UNKNOWNS {
        let jacobian = write(names[1], &places, jacobian);
        return quote!(#f #jacobian);
    }
    let is_zero = |i: &usize| block.results[unknowns + i] == Operand::Constant(Number::ZERO);
    let (mut some_places, mut some) = (vec![], vec![]);
    for i in (0..jacobian.len()).filter(|i| !is_zero(i)) {
        some_places.push(places[i].clone());
        some.push(jacobian[i].clone());
    }
    let (matrix, unknown) = (format_ident!("{}", names[1]), context.unknown_type(unknowns));
    let zeros = (some.len() < jacobian.len())
        .then(|| quote!(*#matrix = <#unknown as Array>::fill(<#unknown as Array>::zero());));
    let jacobian = write(names[1], &some_places, &some);
    quote!(#f #zeros #jacobian)
}

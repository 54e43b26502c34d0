//! Tokens: the struct with its docs, and the implementations of the runtime's traits.
//!
//! Tokens are built, never printed and parsed again. They name nothing but `::core` and the runtime, and what the
//! user's own signature names.

mod attributes;
mod contact;
mod damping;
mod domain;
mod flows;
mod implicit;
mod kernel;
mod poles;
mod report;
mod straight_line;
mod system;

use crate::analyze::Structure;
use crate::diff::Derivatives;
use crate::ir::{Graph, Id};
use crate::parse::{Energy, IMPORTED};
pub(crate) use contact::contact_items;
pub(crate) use implicit::MOST_UNKNOWNS;
pub(crate) use kernel::Context;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The user's function as it is. Coordinates and parameters may be many: clippy would not have it beyond seven.
pub(crate) fn function(energy: &Energy, item: TokenStream) -> TokenStream {
    let function = damping::function(energy).unwrap_or(item);
    if energy.item.sig.inputs.len() > 7 { quote!(#[allow(clippy::too_many_arguments)] #function) } else { function }
}

/// Everything that is emitted beside the user's function.
pub(crate) fn items(
    context: &Context<'_>,
    graph: &mut Graph,
    structure: &Structure,
    derivatives: &Derivatives,
) -> TokenStream {
    let damping = structure.damping.iter().flat_map(|damping| damping.matrix.iter().flatten());
    let roots: Vec<Id> = damping.copied().chain([structure.energy]).collect();
    let bounds = system::bounds(graph, &roots);
    let (flows, flow_costs) = flows::flows(context, graph, structure, derivatives, &bounds);
    let field = &derivatives.field;
    let (collocation, field_cost) =
        implicit::collocation(context, graph, field, derivatives.second_order.as_ref(), &bounds);
    let discrete = (&derivatives.discrete, &field.unknowns[..], derivatives.second_order.as_ref());
    let (discrete, discrete_cost) = implicit::discrete_field(context, graph, discrete, structure, &bounds);
    let hamiltonian = system::hamiltonian(context, graph, structure, derivatives, &bounds);

    let costs = report::Costs { flows: flow_costs, field: field_cost, discrete: discrete_cost };
    let report = report::report(context, graph, structure, derivatives, &costs);
    let inherent = system::inherent(context, &report);
    around(context, &report, &quote!(#inherent #hamiltonian #flows #discrete #collocation))
}

/// The struct with its docs, and implementations, in a scope of their own.
fn around(context: &Context<'_>, report: &str, implementations: &TokenStream) -> TokenStream {
    let docs = format!("\n# What was derived\n\n```text\n{report}```");
    let Energy { runtime, .. } = context.energy;
    let (structure, assertions) = (system::structure(context, &docs), context.energy.outside.assertions());
    // The function is the source of all this, and the user need not call it.
    let used = (!attributes::expected_dead(context.energy)).then(|| {
        let function = &context.energy.item.sig.ident;
        quote! {
            const _: fn() = || {
                let _ = #function;
            };
        }
    });
    let imported = IMPORTED.iter().map(|name| format_ident!("{name}"));
    quote! {
        #structure
        #assertions

        #[allow(
            clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction, deprecated, missing_docs, private_bounds,
            unreachable_pub, unused_imports, unused_mut, unused_variables, reason = "generated code"
        )]
        const _: () = {
            use #runtime::private::{#(#imported),*};

            #used

            #implementations
        };
    }
}

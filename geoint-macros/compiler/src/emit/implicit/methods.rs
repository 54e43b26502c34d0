//! Methods of the runtime whose steps are implicit: `impl ImplicitMethod` names the step of a method for the system.

use crate::derive::Missing;
use crate::emit::context::Context;
use crate::emit::missing::marker;
use crate::emit::structure::self_type;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns `impl ImplicitMethod` of a method with one step for the system.
pub(super) fn solved(context: &Context<'_>, method: &str, step: &str) -> TokenStream {
    let [method, step] = [method, step].map(|name| format_ident!("{name}"));
    implementation(context, &quote!(R: Real), &quote!(#method), [quote!(()), quote!(#step), quote!(#step)])
}

/// Returns `impl ImplicitMethod` of a method whose step contains it.
pub(super) fn solved_by(context: &Context<'_>, method: &str, step: &str) -> TokenStream {
    let [method, step] = [method, step].map(|name| format_ident!("{name}"));
    implementation(
        context,
        &quote!(R: Real),
        &quote!(#method),
        [quote!(()), quote!(#step<#method>), quote!(#step(self))],
    )
}

/// Returns `impl ImplicitMethod` of a method with Gauss stages, for each number of stages.
pub(super) fn collocated(context: &Context<'_>, method: &str, stages: &str) -> TokenStream {
    let [method, stages] = [method, stages].map(|name| format_ident!("{name}"));
    let name = self_type(context);
    quote! {
        impl<R: Real, const STAGES: usize> ImplicitMethod<#name, R> for #method<{ STAGES }>
        where
            GaussCollocation<{ STAGES }>: GaussTableau<{ STAGES }>,
        {
            type Proof = <GaussCollocation<{ STAGES }> as GaussTableau<{ STAGES }>>::Proof;
            type Step = #stages<{ STAGES }>;
            fn step(self) -> Self::Step {
                #stages
            }
        }
    }
}

/// Returns `impl ImplicitMethod` of a method that is solved as one of its own kind with one stage.
pub(super) fn solved_in_one_stage(context: &Context<'_>, method: &str, stages: &str) -> TokenStream {
    let [method, stages] = [method, stages].map(|name| format_ident!("{name}"));
    implementation(context, &quote!(R: Real), &quote!(#method), [quote!(()), quote!(#stages<1>), quote!(#stages)])
}

/// Returns `impl ImplicitMethod` for no scalar. The message of rustc states what the system lacks.
pub(super) fn unsolved(context: &Context<'_>, missing: Missing, method: &str, step: &str) -> TokenStream {
    let ([method, step], marker) = ([method, step].map(|name| format_ident!("{name}")), marker(context, missing));
    let proof = quote!(<R as #marker>::Proof);
    implementation(context, &quote!(R: Real + #marker), &quote!(#method), [proof, quote!(#step), quote!(#step)])
}

/// Returns `impl ImplicitMethod` with these types `Proof` and `Step`, and the value of the step.
fn implementation(
    context: &Context<'_>,
    generics: &TokenStream,
    method: &TokenStream,
    [proof, step, value]: [TokenStream; 3],
) -> TokenStream {
    let name = self_type(context);
    quote! {
        impl<#generics> ImplicitMethod<#name, R> for #method {
            type Proof = #proof;
            type Step = #step;
            fn step(self) -> Self::Step {
                #value
            }
        }
    }
}

//! Methods of the runtime whose steps are implicit: `impl ImplicitMethod` names the step of a method for the system.
//!
//! The macro implements the trait for each system, because the step depends on the structure that it has found. A method that the system lacks may have an
//! implementation that no scalar satisfies. Its use is a compile error, and the message of rustc states the reason.

use crate::derive::Missing;
use crate::emit::context::Context;
use crate::emit::missing::marker;
use crate::emit::structure::self_type;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// Returns `impl ImplicitMethod` of a method whose step is the unit struct `step`.
pub(super) fn solved(context: &Context<'_>, method: &str, step: &str) -> TokenStream {
    let [method, step] = [method, step].map(|name| format_ident!("{name}"));
    Solved::by(method, quote!(#step)).implementation(context)
}

/// Returns `impl ImplicitMethod` of a method whose laws hold forward in time only: for h > 0 the entropy never falls. The proof `ForwardInTime` excludes the
/// method from compositions of order 4 and more, because some of their steps lead back in time.
pub(super) fn solved_forward(context: &Context<'_>, method: &str, step: &str) -> TokenStream {
    let [method, step] = [method, step].map(|name| format_ident!("{name}"));
    let runtime = &context.energy.runtime;
    let proof = quote!(#runtime::private::ForwardInTime);
    Solved { proof, ..Solved::by(method, quote!(#step)) }.implementation(context)
}

/// Returns `impl ImplicitMethod` of a method whose step is generic over methods and holds the method: `ContactStep(self)`.
pub(super) fn solved_by(context: &Context<'_>, method: &str, step: &str) -> TokenStream {
    let [method, step] = [method, step].map(|name| format_ident!("{name}"));
    let (step, value) = (quote!(#step<#method>), quote!(#step(self)));
    Solved { step, ..Solved::by(method, value) }.implementation(context)
}

/// Returns `impl ImplicitMethod` of a method with Gauss stages, for each number of stages with a table of Gauss points.
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

/// Returns `impl ImplicitMethod` of a method that equals Gauss collocation with one stage: `ContactMidpoint`. For `ImplicitMidpoint` the runtime has such an
/// implementation.
pub(super) fn solved_in_one_stage(context: &Context<'_>, method: &str, stages: &str) -> TokenStream {
    let [method, stages] = [method, stages].map(|name| format_ident!("{name}"));
    Solved { step: quote!(#stages<1>), ..Solved::by(method, quote!(#stages)) }.implementation(context)
}

/// Returns `impl ImplicitMethod` under a bound that no scalar satisfies. The message of rustc states what the system lacks.
pub(super) fn unsolved(context: &Context<'_>, missing: Missing, method: &str, step: &str) -> TokenStream {
    let [method, step] = [method, step].map(|name| format_ident!("{name}"));
    let marker = marker(context, missing);
    let proof = quote!(<R as #marker>::Proof);
    Solved { marker: Some(marker), proof, ..Solved::by(method, quote!(#step)) }.implementation(context)
}

/// One implementation of `ImplicitMethod`.
struct Solved {
    /// A trait that no scalar implements, if the system lacks the step. Its message is the reason.
    marker: Option<Ident>,
    /// The proof that the system has the properties that the method needs: `()`, `ForwardInTime` (not for compositions with steps back in time), or, if the
    /// system lacks the step, a type of the marker that stays unknown.
    proof: TokenStream,
    /// The type of the method.
    method: Ident,
    /// The type of the step.
    step: TokenStream,
    /// The expression that makes the step from `self`, the method.
    value: TokenStream,
}

impl Solved {
    /// Returns the implementation of a method whose step is a unit struct, so that its name is both its type and its value.
    fn by(method: Ident, step: TokenStream) -> Solved {
        Solved { marker: None, proof: quote!(()), method, step: step.clone(), value: step }
    }

    /// Returns the tokens of the implementation.
    fn implementation(self, context: &Context<'_>) -> TokenStream {
        let (name, Solved { marker, proof, method, step, value }) = (self_type(context), self);
        let bound = marker.map(|marker| quote!(+ #marker));
        quote! {
            impl<R: Real #bound> ImplicitMethod<#name, R> for #method {
                type Proof = #proof;
                type Step = #step;
                fn step(self) -> Self::Step {
                    #value
                }
            }
        }
    }
}

//! The generated struct, its types, and the user's methods.

use super::attributes;
use super::context::Context;
use super::tokens::Tokens;
use crate::derive::{Kernels, System};
use crate::parse::{Energy, Form, Leaf, over_scalar};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns the generated struct. Each parameter is a field.
pub(super) fn structure(context: &Context<'_>, docs: &str) -> TokenStream {
    let energy = context.energy;
    let (name, vis, float) = (&energy.name, &energy.item.vis, &energy.float);
    // Lints about the name of a field need an attribute of the struct. An attribute of the field has no effect.
    let of_arguments = energy.parameters().flat_map(|parameter| attributes::repeated(&parameter.attributes));
    let own: Vec<TokenStream> = attributes::repeated(&energy.item.attrs).chain(of_arguments).collect();
    let scalar = format_ident!("R");
    let fields: Vec<TokenStream> = energy
        .parameters()
        .map(|parameter| {
            let (name, ty) = (&parameter.name, over_scalar(&parameter.ty, float, &scalar));
            let doc = format!("The parameter `{name}` of the energy.");
            quote!(#[doc = #doc] pub #name: #ty)
        })
        .collect();
    // Quaternions are comparable for scalars `R: Real` only. A derived comparison lacks this bound.
    let compared = energy.parameters().any(|parameter| parameter.shape.leaf == Leaf::Quaternion).then(|| {
        let (runtime, fields) = (&energy.runtime, energy.parameters().map(|parameter| &parameter.name));
        let old = attributes::is_deprecated(energy).then(|| quote!(#[allow(deprecated, reason = "generated code")]));
        quote! {
            #old
            impl<R: #runtime::private::Real> ::core::cmp::PartialEq for #name<R> {
                fn eq(&self, other: &Self) -> bool {
                    #(self.#fields == other.#fields)&&*
                }
            }
        }
    });
    let equal = compared.is_none().then(|| quote!(, ::core::cmp::PartialEq));
    // NaN differs from itself, so the struct has no `Eq`.
    let derives = quote! {
        #[allow(clippy::derive_partial_eq_without_eq, reason = "generated code")]
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug #equal)]
    };
    if fields.is_empty() {
        quote!(#derives #(#own)* #[doc = #docs] #vis struct #name;)
    } else {
        quote!(#derives #(#own)* #[doc = #docs] #vis struct #name<R = #float> { #(#fields),* } #compared)
    }
}

/// Returns the user's methods in the float type of the function. Methods of the generic traits would leave the scalar of literals open.
pub(super) fn inherent(context: &Context<'_>, system: &System, flow: Option<TokenStream>, report: &str) -> TokenStream {
    let Energy { name, float, .. } = context.energy;
    let state = state_type(context, |ty| quote!(#ty));
    let has_energy = !context.form.is_flow() || system.value.is_some();
    let energy = has_energy.then(|| {
        quote! {
            /// The energy of a state.
            pub fn energy(&self, state: &#state) -> #float {
                PhaseSpace::energy(self, state)
            }
        }
    });
    // The type `Given<P, Run>` is unknown if the method does not fit. Later uses of the run then add no errors to the one about the method.
    // An adaptive run guesses its first step from the rates, which systems with constraints of positions lack.
    let adaptive = (!matches!(system.kernels, Kernels::Constrained(_)) || system.rate.is_some()).then(|| {
        quote! {
            /// Returns an `Adaptive` run of this system under a method, with steps as long as the tolerance of a step's error allows, from
            /// `state` on.
            ///
            /// Nothing is checked yet: an unusable tolerance or state is reported by the first step.
            pub fn adaptive<M: Method<Self, #float, Proof = P>, P>(
                self,
                method: M,
                tolerance: f64,
                state: #state,
            ) -> Given<P, Adaptive<Self, M, #float>> {
                Adaptive::new(self, method, tolerance, state)
            }
        }
    });
    quote! {
        impl #name {
            /// What was derived from the energy: derivatives or pieces, structure, what is conserved, operations, and what is
            /// skipped and why.
            pub const REPORT: &'static str = #report;

            #energy
            #flow

            /// Returns an `Integrator` of this system under a method, with step size `h` (negative to go back in time), from `state` on.
            ///
            /// Nothing is checked yet: an unusable `h` or state is reported by the first step.
            pub fn integrator<M: Method<Self, #float, Proof = P>, P>(
                self,
                method: M,
                h: #float,
                state: #state,
            ) -> Given<P, Integrator<Self, M, #float>> {
                Integrator::new(self, method, h, state)
            }

            #adaptive
        }
    }
}

/// Returns the name of the type of states.
pub(super) fn state(form: Form) -> TokenStream {
    match form {
        Form::Hamiltonian | Form::Lagrangian => quote!(State),
        Form::Bodies => quote!(BodyState),
        Form::Contact | Form::Herglotz => quote!(ContactState),
        Form::Structured | Form::Field | Form::FirstOrder => quote!(FlowState),
    }
}

/// Returns the type of states with the types of its coordinates. The function `ty` maps the user's types.
pub(super) fn state_type(context: &Context<'_>, ty: impl Fn(&syn::Type) -> TokenStream) -> TokenStream {
    let (state, coordinates) = (state(context.form), ty(&context.energy.coordinates.ty));
    let centres = (context.form == Form::Bodies).then(|| context.energy.centres()).flatten().map(ty);
    match centres {
        Some(centres) => quote!(#state<#coordinates, #centres>),
        None => quote!(#state<#coordinates>),
    }
}

/// Returns `Name<R>`, or `Name` for a system without parameters.
pub(super) fn self_type(context: &Context<'_>) -> Tokens {
    let name = &context.energy.name;
    if context.energy.parameters().next().is_some() {
        quote!(#name<R>).into()
    } else {
        Tokens::from(vec![name.clone().into()])
    }
}

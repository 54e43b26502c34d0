//! The struct, and what every system offers: its energy, its gradient.

use super::attributes;
use super::domain::domain;
use super::kernel::{Context, write};
use crate::derive::{Implicit, Modified, System};
use crate::ir::Graph;
use crate::parse::{Energy, Form, Leaf, over_scalar};
use crate::schedule::Plan;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The generated struct: a field a parameter.
pub(super) fn structure(context: &Context<'_>, docs: &str) -> TokenStream {
    let energy = context.energy;
    let (name, vis, float) = (&energy.name, &energy.item.vis, &energy.float);
    // rustc asks the struct, not the field, whether the name of a field is as it should be.
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
    // Quaternions are compared for scalars alone, which a derived comparison does not ask for.
    let compared = energy.parameters().any(|parameter| parameter.shape.leaf == Leaf::Quaternion).then(|| {
        let (runtime, fields) = (&energy.runtime, energy.parameters().map(|parameter| &parameter.name));
        quote! {
            impl<R: #runtime::private::Real> ::core::cmp::PartialEq for #name<R> {
                fn eq(&self, other: &Self) -> bool {
                    #(self.#fields == other.#fields)&&*
                }
            }
        }
    });
    let equal = compared.is_none().then(|| quote!(, ::core::cmp::PartialEq));
    // Numbers are equal to numbers, but not all of them to themselves.
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

/// What users call, in the float type of the function: the traits are generic, and literals would leave their scalar
/// open.
pub(super) fn inherent(
    context: &Context<'_>,
    (energy, rates, flow): (bool, bool, Option<TokenStream>),
    report: &str,
) -> TokenStream {
    let Energy { name, float, .. } = context.energy;
    let state = state_type(context, |ty| quote!(#ty));
    let energy = energy.then(|| {
        quote! {
            /// The energy of a state.
            pub fn energy(&self, state: &#state) -> #float {
                PhaseSpace::energy(self, state)
            }
        }
    });
    // An adaptive run guesses its first step from rates.
    let adaptive = rates.then(|| {
        quote! {
            /// This system under a method with steps as long as the tolerance of a step's error allows, from `state` on.
            ///
            /// Nothing is checked yet: an unusable tolerance or state is reported by the first step.
            pub fn adaptive<M: Method<Self, #float, Proof = P>, P>(
                self,
                method: M,
                tolerance: f64,
                state: #state,
            ) -> <P as ProofAnd<Adaptive<Self, M, #float>>>::Both {
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

            /// This system under a method, with step size `h` (negative to go back in time), from `state` on.
            ///
            /// Nothing is checked yet: an unusable `h` or state is reported by the first step.
            pub fn integrator<M: Method<Self, #float, Proof = P>, P>(
                self,
                method: M,
                h: #float,
                state: #state,
            ) -> <P as ProofAnd<Integrator<Self, M, #float>>>::Both {
                Integrator::new(self, method, h, state)
            }

            #adaptive
        }
    }
}

/// The type of states.
pub(super) fn state(form: Form) -> TokenStream {
    match form {
        Form::Hamiltonian | Form::Lagrangian => quote!(State),
        Form::Bodies => quote!(BodyState),
        Form::Contact | Form::Herglotz => quote!(ContactState),
        Form::Structured | Form::Field | Form::FirstOrder => quote!(FlowState),
    }
}

/// The same with the types of its coordinates.
pub(super) fn state_type(context: &Context<'_>, ty: impl Fn(&syn::Type) -> TokenStream) -> TokenStream {
    let Energy { form, coordinates, .. } = context.energy;
    let (state, coordinates) = (state(*form), ty(&coordinates.ty));
    let centres = (*form == Form::Bodies).then(|| context.energy.centres()).flatten().map(ty);
    match centres {
        Some(centres) => quote!(#state<#coordinates, #centres>),
        None => quote!(#state<#coordinates>),
    }
}

/// `Name<R>`, or `Name` if there are no parameters.
pub(super) fn self_type(context: &Context<'_>) -> TokenStream {
    let name = &context.energy.name;
    if context.energy.parameters().next().is_some() { quote!(#name<R>) } else { quote!(#name) }
}

/// The energy with its gradient and where it is defined, and the traits of what was proven.
pub(super) fn phase_space(context: &Context<'_>, graph: &Graph, system: &System<Plan>) -> TokenStream {
    let (name, action) = (self_type(context), context.action());
    let (phase, parts, state) = (context.phase(), context.parts(), state(context.energy.form));
    let coordinates = over_scalar(&context.energy.coordinates.ty, &context.energy.float, &format_ident!("R"));
    // Momenta that are not followed give no energy.
    let value = match &system.value {
        Some(value) => context.values(value, |mut values| values.remove(0)),
        None if matches!(system.implicit, Implicit::Velocities(_)) => quote!(energy_of(self, t, z, &())),
        None if matches!(system.implicit, Implicit::Herglotz(_)) => quote!(energy_of(self, t, z, s)),
        None => quote!(R::from_f64(f64::NAN)),
    };
    let domain = domain(context, graph, &system.domain);
    let given = if context.energy.form.has_action() { quote!(s: &R) } else { quote!(_: &()) };
    let rate = vector_field(context, system);
    let gradient = system.slopes.as_ref().map(|slopes| gradient(context, system, slopes));
    let kept = system.proven.contains(&"Autonomous").then(|| keeps_energy(context, &quote!(CanonicalEnergy), None));
    let constrained = matches!(system.implicit, Implicit::Constrained(_)).then(|| {
        quote! {
            fn unmet(&self, t: R, h: R, z: &#phase) -> ::core::option::Option<Unmet> {
                unmet(self, t, h, z)
            }
        }
    });
    let proven = system.proven.iter().map(|name| format_ident!("{name}"));
    quote! {
        #(impl<R: Real> #proven<R> for #name { type Proof = (); })*
        impl<R: Real> PhaseSpace<R> for #name {
            type State = #state<#coordinates>;
            type Phase = #phase;
            type Action = #action;

            #[inline]
            fn hamiltonian(&self, t: R, z: &#phase, #given) -> R {
                #parts
                #value
            }
            #domain
            #constrained
        }
        #rate
        #gradient
        #kept
    }
}

/// `impl KeepsEnergy`; with the value of what is kept where it is not that of H.
pub(super) fn keeps_energy(context: &Context<'_>, kept: &TokenStream, value: Option<TokenStream>) -> TokenStream {
    let (name, phase) = (self_type(context), context.phase());
    let value = value.map(|value| {
        quote! {
            #[inline]
            fn kept_energy(&self, t: R, z: &#phase) -> R {
                #value
            }
        }
    });
    quote! {
        impl<R: Real> KeepsEnergy<R> for #name {
            type Proof = ();
            type Kept = #kept;
            #value
        }
    }
}

/// `impl DifferentialEquation`; nothing for contact systems.
fn vector_field(context: &Context<'_>, system: &System<Plan>) -> Option<TokenStream> {
    let (name, phase, parts) = (self_type(context), context.phase(), context.parts());
    let body = match (context.energy.form, &system.rate) {
        (form, _) if form.has_action() => return None,
        _ if matches!(system.implicit, Implicit::Constrained(_)) => return None,
        (Form::Hamiltonian | Form::Lagrangian, Some(rate)) => context.values(rate, |values| halves(context, &values)),
        (_, Some(rate)) => context.values(rate, |values| write("slopes", &context.coordinates(), &values)),
        (Form::Lagrangian, None) if system.slopes.is_none() => quote!(rate_of(self, t, z, slopes);),
        (_, None) => quote!(canonical_rate(self, t, z, slopes);),
    };
    Some(quote! {
        impl<R: Real> DifferentialEquation<R> for #name {
            type Proof = ();
            #[inline(always)]
            fn rate(&self, t: R, z: &#phase, slopes: &mut #phase) {
                #parts
                #body
            }
        }
    })
}

/// `impl CotangentSpace`.
pub(super) fn cotangent(context: &Context<'_>) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let coordinates = over_scalar(&context.energy.coordinates.ty, &context.energy.float, &format_ident!("R"));
    quote! {
        impl<R: Real> CotangentSpace<R> for #name {
            type Coordinates = #coordinates;
            type Array = #array;
        }
    }
}

/// `impl CotangentSpace`, and the gradient of an energy on it.
fn gradient(context: &Context<'_>, system: &System<Plan>, slopes: &Plan) -> TokenStream {
    let (name, phase, parts) = (self_type(context), context.phase(), context.parts());
    let (form, receives, returned) = match context.energy.form {
        form if form.has_action() => (quote!(ContactSystem), quote!(s: &R,), quote!(ds: &mut R,)),
        _ => (quote!(Hamiltonian), quote!(), quote!()),
    };
    let rate = system.rate.as_ref().filter(|_| context.energy.form.has_action()).map(|rate| {
        let body = context.values(rate, |values| halves(context, &values));
        quote! {
            #[inline]
            fn rate(&self, t: R, z: &#phase, s: &R, slopes: &mut #phase, ds: &mut R) {
                #parts
                #body
            }
        }
    });
    let slopes = context.values(slopes, |values| halves(context, &values));
    let cotangent = cotangent(context);
    quote! {
        #cotangent
        impl<R: Real> #form<R> for #name {
            type Proof = ();
            #[inline]
            fn gradient(&self, t: R, z: &#phase, #receives slopes: &mut #phase, #returned) {
                #parts
                #slopes
            }
            #rate
        }
    }
}

/// `slopes[0][i] = …; slopes[1][i] = …;`, and `*ds = …;` if there is one more value.
pub(super) fn halves(context: &Context<'_>, values: &[TokenStream]) -> TokenStream {
    let places = context.coordinates();
    let (q, rest) = values.split_at(places.len());
    let (p, s) = rest.split_at(places.len());
    let half = |half: usize| -> Vec<Vec<usize>> { places.iter().map(|place| [&[half], &place[..]].concat()).collect() };
    let (q, p) = (write("slopes", &half(0), q), write("slopes", &half(1), p));
    quote!(#q #p #(*ds = #s;)*)
}

/// `impl ModifiedEnergy`, and the method that users call.
pub(super) fn modified_energy(context: &Context<'_>, modified: &Modified<Plan>) -> TokenStream {
    let value = match modified {
        Modified::Implicit => quote!(modified_verlet(self, h, t, z)),
        Modified::Value(plan) => context.values(plan, |mut values| values.remove(0)),
    };
    let (name, phase, parts) = (self_type(context), context.phase(), context.parts());
    let state = state(context.energy.form);
    let Energy { name: plain, float, coordinates, .. } = context.energy;
    let coordinates = &coordinates.ty;
    quote! {
        impl<R: Real> ModifiedEnergy<R> for #name {
            fn modified_hamiltonian(&self, h: R, t: R, z: &#phase, s: &Self::Action) -> R {
                #parts
                #value
            }
        }
        impl #plain {
            /// H + h²H₂, which steps of length `h` keep, or let decay as the flow of H + h²H₂ does, up to h⁴.
            pub fn modified_energy(&self, h: #float, state: &#state<#coordinates>) -> #float {
                ModifiedEnergy::modified_energy(self, h, state)
            }
        }
    }
}

//! Implementations of all systems: energy, gradient, vector field, and proven facts.

use super::context::Context;
use super::domain::domain;
use super::exact;
use super::implementation::{flag, proven};
use super::structure::{self_type, state, state_type};
use crate::derive::{Fact, Kernels, Modified, System};
use crate::parse::{Energy, Form, over_scalar};
use crate::schedule::Routine;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns `impl PhaseSpace`, the gradient, the vector field, and the traits of proven facts.
pub(super) fn phase_space(context: &Context<'_>, system: &System) -> TokenStream {
    let (name, action) = (self_type(context), context.action_type());
    let (phase, parts) = (context.phase_type(), context.parts());
    let scalar = format_ident!("R");
    let state = state_type(context, |ty| over_scalar(ty, &context.energy.float, &scalar));
    // Without a formula, the runtime computes the energy from the velocities. A field without momenta has no energy.
    let value = match &system.value {
        Some(value) => context.returned(value),
        None if matches!(system.kernels, Kernels::Velocities(_)) => {
            let action = if context.form.has_action() { quote!(s) } else { quote!(&()) };
            quote!(energy_of(self, t, z, #action))
        }
        None => quote!(R::from_f64(f64::NAN)),
    };
    let domain = domain(context, &system.domain);
    let given = if context.form.has_action() { quote!(s: &R) } else { quote!(_: &()) };
    let rate = vector_field(context, system);
    let gradient = system.gradient.as_ref().map(|slopes| gradient(context, system, slopes));
    let kept = system.has(Fact::Autonomous).then(|| keeps_energy(context, &quote!(CanonicalEnergy), None));
    let constrained = matches!(system.kernels, Kernels::Constrained(_)).then(|| {
        quote! {
            fn unmet(&self, t: R, h: R, z: &#phase) -> ::core::option::Option<Unmet> {
                unmet(self, t, h, z)
            }
        }
    });
    let runtime = &context.energy.runtime;
    let solved = matches!(system.kernels, Kernels::Velocities(_)).then(|| {
        quote! {
            const SOLVED_FOR_VELOCITIES: bool = true;
            fn singular_mass(
                &self, t: [R; 2], z: [&#phase; 2], s: [&#action; 2],
            ) -> ::core::option::Option<&'static str> {
                #runtime::private::singular_mass(self, t, z, s)
            }
        }
    });
    let is_lagrangian = matches!(context.form, Form::Lagrangian | Form::Herglotz);
    let of_velocities = is_lagrangian.then(|| flag("OF_VELOCITIES", true));
    let (attitudes, cotangent) = match &system.kernels {
        Kernels::Bodies(kernels) => {
            let attitudes = exact::attitudes(context, kernels);
            (Some(attitudes), Some(cotangent(context)))
        }
        _ => (None, None),
    };
    let facts = system.facts.iter().map(|fact| {
        let fact = format_ident!("{}", fact.trait_name());
        proven(context, quote!(#fact<R>), quote!())
    });
    quote! {
        #(#facts)*
        impl<R: Real> PhaseSpace<R> for #name {
            type State = #state;
            type Phase = #phase;
            type Action = #action;

            #[inline]
            fn hamiltonian(&self, t: R, z: &#phase, #given) -> R {
                #parts
                #value
            }
            #of_velocities
            #solved
            #attitudes
            #domain
            #constrained
        }
        #cotangent
        #rate
        #gradient
        #kept
    }
}

/// Returns `impl KeepsEnergy`. The tokens `value` compute the conserved quantity if it is not H.
pub(super) fn keeps_energy(context: &Context<'_>, kept: &TokenStream, value: Option<TokenStream>) -> TokenStream {
    let phase = context.phase_type();
    let value = value.map(|value| {
        quote! {
            #[inline]
            fn kept_energy(&self, t: R, z: &#phase) -> R {
                #value
            }
        }
    });
    proven(context, quote!(KeepsEnergy<R>), quote!(type Kept = #kept; #value))
}

/// Returns `impl DifferentialEquation`. Systems with an action or with constraints of positions have none.
fn vector_field(context: &Context<'_>, system: &System) -> Option<TokenStream> {
    let (phase, parts) = (context.phase_type(), context.parts());
    let body = match (context.form, &system.rate) {
        (form, _) if form.has_action() => return None,
        (_, Some(rate)) => context.assigned(rate),
        _ if matches!(system.kernels, Kernels::Constrained(_)) => return None,
        (Form::Lagrangian, None) if system.gradient.is_none() => quote!(rate_of(self, t, z, slopes);),
        (_, None) => quote!(canonical_rate(self, t, z, slopes);),
    };
    let items = quote! {
        #[inline(always)]
        fn rate(&self, t: R, z: &#phase, slopes: &mut #phase) {
            #parts
            #body
        }
    };
    Some(proven(context, quote!(DifferentialEquation<R>), items))
}

/// Returns `impl CotangentSpace`.
pub(super) fn cotangent(context: &Context<'_>) -> TokenStream {
    let (name, array) = (self_type(context), context.positions_type());
    let over_scalar = |ty| over_scalar(ty, &context.energy.float, &format_ident!("R"));
    let mut coordinates = over_scalar(&context.energy.coordinates.ty);
    if let Some(centres) = context.energy.centres().map(over_scalar) {
        coordinates = quote!(Placed<#coordinates, #centres>);
    }
    quote! {
        impl<R: Real> CotangentSpace<R> for #name {
            type Coordinates = #coordinates;
            type Array = #array;
        }
    }
}

/// Returns `impl CotangentSpace`, and `impl Hamiltonian` or `impl ContactSystem` with the gradient of the energy.
fn gradient(context: &Context<'_>, system: &System, slopes: &Routine) -> TokenStream {
    let (phase, parts) = (context.phase_type(), context.parts());
    let (form, receives, returned) = match context.form {
        form if form.has_action() => (quote!(ContactSystem), quote!(s: &R,), quote!(ds: &mut R,)),
        _ => (quote!(Hamiltonian), quote!(), quote!()),
    };
    let rate = system.rate.as_ref().filter(|_| context.form.has_action()).map(|rate| {
        let body = context.assigned(rate);
        quote! {
            #[inline]
            fn rate(&self, t: R, z: &#phase, s: &R, slopes: &mut #phase, ds: &mut R) {
                #parts
                #body
            }
        }
    });
    let slopes = context.assigned(slopes);
    let items = quote! {
        #[inline]
        fn gradient(&self, t: R, z: &#phase, #receives slopes: &mut #phase, #returned) {
            #parts
            #slopes
        }
        #rate
    };
    let (cotangent, gradient) = (cotangent(context), proven(context, quote!(#form<R>), items));
    quote!(#cotangent #gradient)
}

/// Returns `impl ModifiedEnergy`, and the user's method.
pub(super) fn modified_energy(context: &Context<'_>, modified: &Modified) -> TokenStream {
    let value = match modified {
        Modified::Implicit => quote!(modified_verlet(self, h, t, z)),
        Modified::Value(value) => context.returned(value),
    };
    let (name, phase, parts) = (self_type(context), context.phase_type(), context.parts());
    let state = state(context.form);
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

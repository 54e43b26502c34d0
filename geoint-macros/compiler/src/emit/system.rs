//! What every system offers: its energy, its gradient.

use super::domain::domain;
use super::kernel::{Context, write};
use super::structure::{self_type, state};
use super::tokens::Tokens;
use crate::derive::{Fact, Implicit, Modified, System};
use crate::ir::Graph;
use crate::parse::{Energy, Form, over_scalar};
use crate::schedule::Plan;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

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
    let kept = system.has(Fact::Autonomous).then(|| keeps_energy(context, &quote!(CanonicalEnergy), None));
    let constrained = matches!(system.implicit, Implicit::Constrained(_)).then(|| {
        quote! {
            fn unmet(&self, t: R, h: R, z: &#phase) -> ::core::option::Option<Unmet> {
                unmet(self, t, h, z)
            }
        }
    });
    let runtime = &context.energy.runtime;
    let solved = matches!(system.implicit, Implicit::Velocities(_) | Implicit::Herglotz(_)).then(|| {
        quote! {
            const SOLVED_FOR_VELOCITIES: bool = true;
            fn singular_mass(
                &self, t: [R; 2], z: [&#phase; 2], s: [&#action; 2],
            ) -> ::core::option::Option<&'static str> {
                #runtime::private::singular_mass(self, t, z, s)
            }
        }
    });
    let of_velocities = matches!(context.energy.form, Form::Lagrangian | Form::Herglotz).then(|| {
        quote!(
            const OF_VELOCITIES: bool = true;
        )
    });
    let facts = system.facts.iter().map(|fact| format_ident!("{}", fact.trait_name()));
    quote! {
        #(impl<R: Real> #facts<R> for #name { type Proof = (); })*
        impl<R: Real> PhaseSpace<R> for #name {
            type State = #state<#coordinates>;
            type Phase = #phase;
            type Action = #action;

            #[inline]
            fn hamiltonian(&self, t: R, z: &#phase, #given) -> R {
                #parts
                #value
            }
            #of_velocities
            #solved
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
pub(super) fn halves(context: &Context<'_>, values: &[Tokens]) -> TokenStream {
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

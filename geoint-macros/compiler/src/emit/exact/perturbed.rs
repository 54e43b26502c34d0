//! Perturbed systems H = A + B: the exact flow of A, and the flow of the perturbation B.

use super::kick_drift::moves;
use super::kind::{Kind, Time};
use super::{assign, flow, slots};
use crate::derive::{FlowKernel, Inner, Missing, Perturbed};
use crate::emit::context::{Context, Values};
use crate::emit::implementation::{Implementation, absent, flag};
use crate::emit::signature::{Absent, Trait, methods};
use crate::parse::Role;
use crate::split::OwnMotion;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The flows of A and B.
const PERTURBED_SYSTEM: Trait = Trait {
    name: "PerturbedSystem",
    has_proof: true,
    associated: &[("Exact", Absent::Never), ("Rest", Absent::Never)],
    methods: methods! {
        Hint fn prepare_exact("h": {R}) -> Exact;
        Always fn exact("prepared": {&Exact}, "t": {R}, "q": {&mut Array}, "p": {&mut Array}, "s or _": {&mut Action});
        Hint fn prepare_rest("h": {R}) -> Rest;
        Always fn rest("prepared": {&Rest}, "t": {R}, "q": {&mut Array}, "p": {&mut Array}, "s or _": {&mut Action});
    },
    provided: methods! {
        Always fn exact_increments("prepared": {&Exact}, "t": {R}, "x": {&PerCoordinate}) -> PerCoordinate;
        Always fn rest_increments("prepared": {&Rest}, "t": {R}, "x": {&PerCoordinate}) -> PerCoordinate;
    },
};

/// Kicks of B with the gradient of the squared force.
const PERTURBED_GRADIENT: Trait = Trait {
    name: "PerturbedGradient",
    has_proof: true,
    associated: &[("GradientKick", Absent::Never)],
    methods: methods! {
        Hint fn prepare_gradient_kick("h": {R}, "g": {R}) -> GradientKick;
        Always fn gradient_kick("prepared": {&GradientKick}, "t": {R}, "q": {&mut Array}, "p": {&mut Array});
    },
    provided: &[],
};

/// Returns `impl PerturbedSystem` and `impl PerturbedGradient`.
pub(in crate::emit) fn perturbed(context: &Context<'_>, found: &Result<Perturbed, Missing>) -> TokenStream {
    match found {
        Ok(found) => parts(context, found),
        Err(missing) => absent(context, *missing, &[&PERTURBED_SYSTEM, &PERTURBED_GRADIENT]),
    }
}

/// Returns the implementations for a system with an exact flow of A.
fn parts(context: &Context<'_>, found: &Perturbed) -> TokenStream {
    let (exact, rest) = (flow(context, &found.flow_of_a), flow(context, &found.flow_of_b));
    let types = [("Exact", exact.prepared.clone()), ("Rest", rest.prepared.clone())];
    let exact_kind = Kind {
        adds: false,
        time: if found.time_passes_in_a { Time::Exact } else { Time::Frozen },
        shows_domain: false,
        parts: Some(may_end(context, found)),
    };
    let rest_kind = Kind {
        adds: found.b_is_kick,
        time: if found.kicks_repeat { Time::Unread } else { Time::Frozen },
        shows_domain: false,
        parts: None,
    };
    let implementation = Implementation::new(context, &PERTURBED_SYSTEM, &types)
        .items(exact_kind.constant(context, "EXACT"))
        .items(rest_kind.constant(context, "REST"))
        .items((!found.b_is_exact).then(|| flag("REST_IS_EXACT", false)))
        .types();
    let implementation =
        implementation.method("prepare_exact", exact.prepare.clone()).method("prepare_rest", rest.prepare.clone());
    let implementation = moves(moves(implementation, "exact", &exact), "rest", &rest);
    let inner = found.inner.as_ref().map(|inner| {
        let [enter, leave] =
            [("enter", &inner.enter), ("leave", &inner.leave)].map(|(name, map)| way(context, name, map));
        let unsuitable = unsuitable(context, inner);
        quote! {
            const INNER: bool = true;
            #enter
            #leave
            #unsuitable
        }
    });
    let parts = implementation.items(inner).finish();
    let gradient = match &found.gradient_kick {
        Ok(kick) => gradient_kick(context, kick),
        Err(missing) => absent(context, *missing, &[&PERTURBED_GRADIENT]),
    };
    quote!(#parts #gradient)
}

/// Returns the list of the parts of A whose flows may end within a step.
fn may_end(context: &Context<'_>, found: &Perturbed) -> TokenStream {
    // The path is full, because a struct of the user may have this name.
    let runtime = &context.energy.runtime;
    let part = quote!(#runtime::private::FlowPart);
    let entries = found.own_motions.iter().map(|(motion, coordinates)| {
        let name = match motion {
            OwnMotion::Energy(energy) => context.printer().excerpt(*energy),
            OwnMotion::Orbit(body) => format!("Kepler's motion of {}[{body}]", context.name_of(Role::Position)),
        };
        let (first, count) = (coordinates.start, coordinates.len());
        quote!(#part { name: #name, first: #first, count: #count })
    });
    quote!(&[#(#entries),*])
}

/// Returns a function that maps all coordinates in place.
fn way(context: &Context<'_>, name: &str, map: &FlowKernel) -> TokenStream {
    let (name, phase, parts, body) =
        (format_ident!("{name}"), context.phase_type(), context.parts(), assign(context, map));
    quote! {
        #[inline]
        fn #name(&self, z: &mut #phase) {
            #parts
            #body
        }
    }
}

/// Returns the function that reports a mass beside which no digit of its divisor is left.
fn unsuitable(context: &Context<'_>, inner: &Inner) -> TokenStream {
    let runtime = &context.energy.runtime;
    let printer = context.printer();
    let body = context.outputs(&inner.check_of_masses, |outputs| {
        let values = |name: &'static str| outputs.iter().filter(move |values| values.output.name == name);
        let masses = values("masses").map(Values::listed);
        let shares =
            inner.shares.iter().zip(values("shares").flat_map(Values::rows_of_array)).map(|([mass, sum], values)| {
                let (mass, sum) = (printer.excerpt(*mass), printer.excerpt(*sum));
                let what = format!(
                    "coordinates in which no digit of {sum} is left beside {mass}; let heavy bodies come first"
                );
                quote!((#values, #what))
            });
        quote!(#runtime::private::unsuitable(#(&#masses)*, &[#(#shares),*]))
    });
    quote! {
        #[cold]
        fn unsuitable(&self) -> ::core::option::Option<&'static str> {
            #body
        }
    }
}

/// Returns `impl PerturbedGradient`.
fn gradient_kick(context: &Context<'_>, kick: &FlowKernel) -> TokenStream {
    let slots = slots(kick);
    let types = [("GradientKick", quote!([R; #slots]))];
    Implementation::new(context, &PERTURBED_GRADIENT, &types)
        .types()
        .method("prepare_gradient_kick", context.stored(&kick.kernel, 0))
        .method("gradient_kick", assign(context, kick))
        .finish()
}

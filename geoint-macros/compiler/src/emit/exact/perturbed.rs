//! A part with an exact flow, and a rest.

use super::kick_drift::moves;
use super::{assign, flow, slots};
use crate::derive::{FlowKernel, Inner, Missing, Perturbed};
use crate::emit::implementation::{Absent, Implementation, Inline, Method, Trait, Ty, absent, methods, ty};
use crate::emit::kernel::{Context, Values};
use crate::parse::Role;
use crate::split::OwnMotion;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

const PERTURBED_SYSTEM: Trait = Trait {
    name: "PerturbedSystem",
    has_proof: true,
    associated: &[("Exact", Absent::Never), ("After", Absent::Unit), ("Rest", Absent::Never)],
    methods: methods! {
        Hint fn prepare_after("h": {R}) -> After;
        Hint fn prepare_exact("h": {R}) -> Exact;
        Always fn exact("prepared": {&Exact}, "t": {R}, "q": {&mut Array}, "p": {&mut Array}, "s or _": {&mut Action});
        Hint fn prepare_rest("h": {R}) -> Rest;
        Always fn rest("prepared": {&Rest}, "t": {R}, "q": {&mut Array}, "p": {&mut Array}, "s or _": {&mut Action});
    },
    provided: methods! {
        Always fn exact_increments("prepared": {&Exact}, "t": {R}, "x": {&PerCoordinate}) -> PerCoordinate;
        Always fn rest_increments("prepared": {&Rest}, "t": {R}, "x": {&PerCoordinate}) -> PerCoordinate;
        Always fn exact_after("prepared": {&After}, "q": {&mut Array}, "p": {&mut Array}, "dp": {&Array});
    },
};

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

/// `impl PerturbedSystem` and `impl PerturbedGradient`.
pub(in crate::emit) fn perturbed(context: &Context<'_>, found: &Result<Perturbed, Missing>) -> TokenStream {
    match found {
        Ok(found) => parts(context, found),
        Err(missing) => absent(context, *missing, &[&PERTURBED_SYSTEM, &PERTURBED_GRADIENT]),
    }
}

fn parts(context: &Context<'_>, found: &Perturbed) -> TokenStream {
    let (exact_in_time, repeats) = (found.exact_in_time, found.repeats);
    let may_end = may_end(context, found);
    let no_kick = (!found.is_kick).then(|| {
        let is_exact = found.is_exact;
        quote! {
            const REST_IS_KICK: bool = false;
            const REST_IS_EXACT: bool = #is_exact;
        }
    });
    let (exact, rest) = (flow(context, &found.flow), flow(context, &found.kick));
    let after = found.flow_after_kick.as_ref().map(|after| flow(context, after));
    let after_type = after.as_ref().map_or_else(|| quote!(()), |after| after.prepared.clone());
    let (exact_type, rest_type) = (exact.prepared.clone(), rest.prepared.clone());
    let types = [("Exact", exact_type.clone()), ("After", after_type.clone()), ("Rest", rest_type.clone())];
    let implementation = Implementation::new(context, &PERTURBED_SYSTEM, &types).items(quote! {
        type Proof = ();
        const EXACT_IN_TIME: bool = #exact_in_time;
        const KICKS_REPEAT: bool = #repeats;
        #no_kick
        #may_end
        type Exact = #exact_type;
        type Rest = #rest_type;
        type After = #after_type;
    });
    let implementation = match &after {
        Some(after) => implementation
            .items(quote!(
                const IS_LINEAR: bool = true;
            ))
            .method("prepare_after", after.prepare.clone())
            .method("exact_after", after.flow.clone()),
        None => implementation.items(quote!(
            fn prepare_after(&self, _: R) {}
        )),
    };
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

/// Parts of the flow of A that may end within a step.
fn may_end(context: &Context<'_>, found: &Perturbed) -> TokenStream {
    // By its path: users' structs may have this name.
    let runtime = &context.energy.runtime;
    let part = quote!(#runtime::private::FlowPart);
    let entries = found.parts.iter().map(|(part_of, coordinates)| {
        let name = match part_of {
            OwnMotion::Energy(energy) => context.printer().excerpt(*energy),
            OwnMotion::Orbit(body) => format!("Kepler's motion of {}[{body}]", context.name_of(Role::Position)),
        };
        let (first, count) = (coordinates.start, coordinates.len());
        quote!(#part { name: #name, first: #first, count: #count })
    });
    quote!(const PARTS: &'static [#part] = &[#(#entries),*];)
}

/// A map of all coordinates, in place.
fn way(context: &Context<'_>, name: &str, map: &FlowKernel) -> TokenStream {
    let (name, phase, parts, body) = (format_ident!("{name}"), context.phase(), context.parts(), assign(context, map));
    quote! {
        #[inline]
        fn #name(&self, z: &mut #phase) {
            #parts
            #body
        }
    }
}

/// The first mass beside which nothing is left of what it is divided by.
fn unsuitable(context: &Context<'_>, inner: &Inner) -> TokenStream {
    let runtime = &context.energy.runtime;
    let printer = context.printer();
    let body = context.outputs(&inner.weighed, |outputs| {
        let values = |name: &'static str| outputs.iter().filter(move |values| values.output.name == name);
        let masses = values("masses").map(Values::listed);
        let shares = inner.shares.iter().zip(values("shares").flat_map(Values::rows)).map(|([mass, sum], values)| {
            let (mass, sum) = (printer.excerpt(*mass), printer.excerpt(*sum));
            let what =
                format!("coordinates in which no digit of {sum} is left beside {mass}; let heavy bodies come first");
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

fn gradient_kick(context: &Context<'_>, kick: &FlowKernel) -> TokenStream {
    let slots = slots(kick);
    let types = [("GradientKick", quote!([R; #slots]))];
    Implementation::new(context, &PERTURBED_GRADIENT, &types)
        .items(quote!(type Proof = (); type GradientKick = [R; #slots];))
        .method("prepare_gradient_kick", context.stored(&kick.kernel, 0))
        .method("gradient_kick", assign(context, kick))
        .finish()
}

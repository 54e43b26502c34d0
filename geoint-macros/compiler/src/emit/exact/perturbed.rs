//! A part with an exact flow and a rest that is a kick; or implementations that no scalar satisfies, whose message says why there is no
//! such part.

use super::{assign, flow, slots};
use crate::derive::{FlowKernel, Inner, Missing, Perturbed};
use crate::emit::kernel::{Context, Values};
use crate::emit::missing::unsatisfied;
use crate::emit::structure::self_type;
use crate::parse::Role;
use crate::split::OwnMotion;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// `impl PerturbedSystem` and `impl PerturbedGradient`.
pub(in crate::emit) fn perturbed(context: &Context<'_>, found: &Result<Perturbed, Missing>) -> TokenStream {
    match found {
        Ok(found) => parts(context, found),
        Err(missing) => none(context, *missing),
    }
}

fn parts(context: &Context<'_>, found: &Perturbed) -> TokenStream {
    let name = self_type(context);
    let (exact_in_time, repeats) = (found.exact_in_time, found.repeats);
    let may_end = may_end(context, found);
    let no_kick = (!found.is_kick).then(|| {
        let is_exact = found.is_exact;
        quote! {
            const REST_IS_KICK: bool = false;
            const REST_IS_EXACT: bool = #is_exact;
        }
    });
    let (exact_type, prepare_exact, exact) = flow(context, "exact", &found.flow);
    let after = after(context, found.flow_after_kick.as_ref());
    let (rest_type, prepare_rest, rest) = flow(context, "rest", &found.kick);
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
    let gradient = match &found.gradient_kick {
        Ok(kick) => gradient_kick(context, kick),
        Err(missing) => {
            let (marker, tokens) = unsatisfied(context, *missing);
            let never = no_gradient(context, &marker);
            quote!(#tokens #never)
        }
    };
    quote! {
        impl<R: Real> PerturbedSystem<R> for #name {
            type Proof = ();
            const EXACT_IN_TIME: bool = #exact_in_time;
            const KICKS_REPEAT: bool = #repeats;
            #no_kick
            #may_end
            type Exact = #exact_type;
            type Rest = #rest_type;
            #after
            #prepare_exact
            #prepare_rest
            #exact
            #rest
            #inner
        }
        #gradient
    }
}

/// The flow of A after a kick, as one map.
fn after(context: &Context<'_>, after: Option<&FlowKernel>) -> TokenStream {
    let Some(after) = after else {
        return quote! {
            type After = ();
            fn prepare_after(&self, _: R) {}
        };
    };
    let (array, slots) = (context.array(), slots(after));
    let (prepare, body) = (context.stored(&after.kernel, 0), assign(context, after));
    quote! {
        type After = [R; #slots];
        const IS_LINEAR: bool = true;
        #[inline]
        fn prepare_after(&self, h: R) -> [R; #slots] {
            #prepare
        }
        #[inline(always)]
        fn exact_after(&self, prepared: &[R; #slots], q: &mut #array, p: &mut #array, dp: &#array) {
            #body
        }
    }
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
    let (name, array, slots) = (self_type(context), context.array(), slots(kick));
    let (prepare, body) = (context.stored(&kick.kernel, 0), assign(context, kick));
    quote! {
        impl<R: Real> PerturbedGradient<R> for #name {
            type Proof = ();
            type GradientKick = [R; #slots];
            #[inline]
            fn prepare_gradient_kick(&self, h: R, g: R) -> [R; #slots] {
                #prepare
            }
            #[inline(always)]
            fn gradient_kick(&self, prepared: &[R; #slots], t: R, q: &mut #array, p: &mut #array) {
                #body
            }
        }
    }
}

/// No kick with a force gradient.
fn no_gradient(context: &Context<'_>, marker: &Ident) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let never = quote!(::core::convert::Infallible);
    quote! {
        impl<R: Real + #marker> PerturbedGradient<R> for #name {
            type Proof = <R as #marker>::Proof;
            type GradientKick = #never;
            fn prepare_gradient_kick(&self, _: R, _: R) -> #never {
                ::core::unreachable!()
            }
            fn gradient_kick(&self, never: &#never, _: R, _: &mut #array, _: &mut #array) {
                match *never {}
            }
        }
    }
}

/// Neither part.
fn none(context: &Context<'_>, missing: Missing) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let (marker, tokens) = unsatisfied(context, missing);
    let never = quote!(::core::convert::Infallible);
    let no_gradient = no_gradient(context, &marker);
    let flows = ["exact", "rest"].map(|flow| {
        let (prepare, flow) = (format_ident!("prepare_{flow}"), format_ident!("{flow}"));
        quote! {
            fn #prepare(&self, _: R) -> #never {
                ::core::unreachable!()
            }
            fn #flow(&self, never: &#never, _: R, _: &mut #array, _: &mut #array, _: &mut ()) {
                match *never {}
            }
        }
    });
    quote! {
        #tokens
        impl<R: Real + #marker> PerturbedSystem<R> for #name {
            type Proof = <R as #marker>::Proof;
            type Exact = #never;
            type After = ();
            type Rest = #never;
            fn prepare_after(&self, _: R) {}
            #(#flows)*
        }
        #no_gradient
    }
}

//! Kick, drift and damping of mechanical contact systems; or implementations that no scalar satisfies, whose messages name a
//! term.

use super::super::flows::{not_quadratic, quadratic, unsatisfied};
use super::super::kernel::{Context, place};
use super::super::system::self_type;
use crate::check::{NOT_MECHANICAL, NOT_NYSTROM};
use crate::ir::{Graph, Id, Symbol};
use crate::schedule;
use crate::split::{Clock, Flow, Mechanics};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// `impl Separable`, `impl QuadraticKinetic` and `impl Mechanical`.
pub(super) fn mechanics(
    context: &Context<'_>,
    graph: &mut Graph,
    found: &Result<Mechanics, Id>,
    bounds: &TokenStream,
) -> TokenStream {
    match found {
        Ok(mechanics) => separable(context, graph, mechanics, bounds),
        Err(term) => none(context, graph, *term, bounds),
    }
}

fn separable(context: &Context<'_>, graph: &mut Graph, mechanics: &Mechanics, bounds: &TokenStream) -> TokenStream {
    let name = self_type(context);
    let (drift, clock) = &mechanics.drift;
    let exact = *clock == Clock::Own;
    let (kick_type, prepare_kick, kick) = flow(context, graph, "kick", &mechanics.kick);
    let (drift_type, prepare_drift, drift) = flow(context, graph, "drift", drift);
    let free_kick = free_flow(context, graph, "kick", (&mechanics.free_kick, &mechanics.kick));
    let free_drift = free_flow(context, graph, "drift", (&mechanics.free_drift, &mechanics.drift.0));
    let damping = context.routine(graph, &[mechanics.damping], |mut values| values.remove(0));
    let nystrom = match &mechanics.gradient_kick {
        Ok(kick) => {
            let (slots, prepare, body) = planned(context, graph, kick);
            quadratic(context, (&quote!([R; #slots]), &prepare, &body), bounds)
        }
        Err(term) => {
            let (marker, tokens) = unsatisfied(context, graph, "NystromIn", *term, NOT_NYSTROM);
            let never = not_quadratic(context, &quote!(#bounds + #marker));
            quote!(#tokens #never)
        }
    };
    quote! {
        impl<R: #bounds> Separable<R> for #name {
            type Kick = #kick_type;
            type Drift = #drift_type;
            const DRIFTS_ARE_EXACT_IN_TIME: bool = #exact;
            #prepare_kick
            #prepare_drift
            #kick
            #drift
        }
        #nystrom
        impl<R: #bounds> MechanicalContact<R> for #name {
            #free_kick
            #free_drift
            #[inline(always)]
            fn damping(&self, t: R) -> R {
                #damping
            }
        }
    }
}

/// A kick or a drift without damping: the other one, if nothing of that is damped.
fn free_flow(context: &Context<'_>, graph: &mut Graph, name: &str, (own, damped): (&Flow, &Flow)) -> TokenStream {
    let upper = if name == "kick" { "Kick" } else { "Drift" };
    let [free_type, other_type] = ["Free", ""].map(|free| format_ident!("{free}{upper}"));
    let [free, prepare_free, other, prepare_other] =
        ["free_", "prepare_free_", "", "prepare_"].map(|prefix| format_ident!("{prefix}{name}"));
    if own != damped {
        let (prepared, prepare, flow) = flow(context, graph, &format!("free_{name}"), own);
        return quote!(type #free_type = #prepared; #prepare #flow);
    }
    let array = context.array();
    quote! {
        type #free_type = <Self as Separable<R>>::#other_type;
        #[inline]
        fn #prepare_free(&self, h: R) -> Self::#free_type {
            self.#prepare_other(h)
        }
        #[inline(always)]
        fn #free(&self, prepared: &Self::#free_type, t: R, q: &mut #array, p: &mut #array, s: &mut R) {
            self.#other(prepared, t, q, p, s);
        }
    }
}

/// The type of what is prepared for a flow, the function that prepares it, and the flow.
fn flow(context: &Context<'_>, graph: &mut Graph, name: &str, flow: &Flow) -> (TokenStream, TokenStream, TokenStream) {
    let (array, prepare_name, name) = (context.array(), format_ident!("prepare_{name}"), format_ident!("{name}"));
    let (slots, prepare, body) = planned(context, graph, flow);
    let prepare = quote! {
        #[inline]
        fn #prepare_name(&self, h: R) -> [R; #slots] {
            #prepare
        }
    };
    let flow = quote! {
        #[inline(always)]
        fn #name(&self, prepared: &[R; #slots], t: R, q: &mut #array, p: &mut #array, s: &mut R) {
            #body
        }
    };
    (quote!([R; #slots]), prepare, flow)
}

/// What a flow needs of parameters, h and g: how many numbers, which, and what it makes of them.
fn planned(context: &Context<'_>, graph: &mut Graph, flow: &Flow) -> (Literal, TokenStream, TokenStream) {
    let changed = flow.changed(graph);
    let roots: Vec<Id> = changed.iter().map(|(_, end)| *end).collect();
    let level = |symbol| usize::from(!matches!(symbol, Symbol::Parameter(_) | Symbol::H | Symbol::G));
    let plan = schedule::plan(graph, level, &[&[]], &[&roots]);
    let prepare = context.planned(&plan.stores[0], (&[], ""), |values| quote!([#(#values),*]));
    let body = context.planned(&plan.last[0], (&[], ""), |values| assign(context, &changed, &values));
    (Literal::usize_unsuffixed(plan.slots[0]), prepare, body)
}

/// `q[i] = …; p[i] = …; *s = …;`
pub(super) fn assign(context: &Context<'_>, changed: &[(Symbol, Id)], values: &[TokenStream]) -> TokenStream {
    let places = changed.iter().map(|(symbol, _)| match symbol {
        Symbol::Q(i) => place(quote!(q), &context.coordinate(*i)),
        Symbol::P(i) => place(quote!(p), &context.coordinate(*i)),
        _ => quote!(*s),
    });
    quote!(#(#places = #values;)*)
}

fn none(context: &Context<'_>, graph: &Graph, term: Id, bounds: &TokenStream) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let (marker, tokens) = unsatisfied(context, graph, "MechanicalIn", term, NOT_MECHANICAL);
    let never = quote!(::core::convert::Infallible);
    let not_quadratic = not_quadratic(context, &quote!(#bounds + #marker));
    let flow = |name: &str| {
        let (prepare, name) = (format_ident!("prepare_{name}"), format_ident!("{name}"));
        quote! {
            fn #prepare(&self, _: R) -> #never {
                ::core::unreachable!()
            }
            fn #name(&self, never: &#never, _: R, _: &mut #array, _: &mut #array, _: &mut R) {
                match *never {}
            }
        }
    };
    let [kick, drift, free_kick, free_drift] = ["kick", "drift", "free_kick", "free_drift"].map(flow);
    quote! {
        #tokens
        impl<R: #bounds + #marker> Separable<R> for #name {
            type Kick = #never;
            type Drift = #never;
            #kick
            #drift
        }
        #not_quadratic
        impl<R: #bounds + #marker> MechanicalContact<R> for #name {
            type FreeKick = #never;
            type FreeDrift = #never;
            #free_kick
            #free_drift
            fn damping(&self, t: R) -> R {
                t
            }
        }
    }
}

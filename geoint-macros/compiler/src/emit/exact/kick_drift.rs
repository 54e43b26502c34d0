//! Kick and drift; or implementations that no scalar satisfies, whose message names the term that couples, or damps.

use super::{assign, flow, slots};
use crate::derive::{FlowKernel, GradientKick, KickDrift, Missing, Undamped};
use crate::emit::kernel::Context;
use crate::emit::missing::unsatisfied;
use crate::emit::structure::self_type;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// `impl Separable`, `impl QuadraticKinetic`, `impl ForceGradient`, and `impl MechanicalContact` of contact systems.
pub(in crate::emit) fn splitting(context: &Context<'_>, found: &Result<KickDrift, Missing>) -> TokenStream {
    match found {
        Ok(flows) => separable(context, flows),
        Err(missing) => none(context, *missing),
    }
}

fn separable(context: &Context<'_>, flows: &KickDrift) -> TokenStream {
    let name = self_type(context);
    let exact = flows.exact_in_time.then(|| {
        quote!(
            const DRIFTS_ARE_EXACT_IN_TIME: bool = true;
        )
    });
    let repeats = flows.repeats;
    let shows = flows.shows.then(|| {
        quote!(
            const KICKS_SHOW: bool = true;
        )
    });
    let [kick, drift] = [("kick", &flows.kick), ("drift", &flows.drift)].map(|(name, each)| flow(context, name, each));
    let gradient_kick = match &flows.gradient_kick {
        Ok(GradientKick::Collocation) => quadratic(
            context,
            [
                &quote!((<Self as Collocation<R>>::Constants, [R; 2])),
                &quote!((self.constants(), [h, g])),
                &quote!(gradient_kick(self, prepared, t, q, p);),
            ],
        ),
        Ok(GradientKick::Flow(flow)) => {
            let slots = slots(flow);
            quadratic(context, [&quote!([R; #slots]), &context.stored(&flow.kernel, 0), &assign(context, flow)])
        }
        Err(missing) => {
            let (marker, tokens) = unsatisfied(context, *missing);
            let never = not_quadratic(context, &marker);
            quote!(#tokens #never)
        }
    };
    let mechanical = flows.undamped.as_ref().map(|undamped| mechanical(context, undamped));
    let [(kick_type, prepare_kick, kick), (drift_type, prepare_drift, drift)] = [kick, drift];
    quote! {
        impl<R: Real> Separable<R> for #name {
            type Proof = ();
            const KICKS_REPEAT: bool = #repeats;
            #shows
            type Kick = #kick_type;
            type Drift = #drift_type;
            #exact
            #prepare_kick
            #prepare_drift
            #kick
            #drift
        }
        #gradient_kick
        #mechanical
    }
}

/// `impl MechanicalContact`: kick and drift without damping, and the damping.
fn mechanical(context: &Context<'_>, undamped: &Undamped) -> TokenStream {
    let name = self_type(context);
    let kick = free_flow(context, ["Kick", "kick"], undamped.kick.as_ref());
    let drift = free_flow(context, ["Drift", "drift"], undamped.drift.as_ref());
    let damping = context.returned(&undamped.damping);
    quote! {
        impl<R: Real> MechanicalContact<R> for #name {
            type Proof = ();
            #kick
            #drift
            #[inline(always)]
            fn damping(&self, t: R) -> R {
                #damping
            }
        }
    }
}

/// A kick or a drift without damping: the one of `Separable`, if that is none other.
fn free_flow(context: &Context<'_>, [upper, lower]: [&str; 2], own: Option<&FlowKernel>) -> TokenStream {
    let [free_type, other_type] = ["Free", ""].map(|free| format_ident!("{free}{upper}"));
    if let Some(own) = own {
        let (prepared, prepare, flow) = flow(context, &format!("free_{lower}"), own);
        return quote!(type #free_type = #prepared; #prepare #flow);
    }
    let [free, prepare_free, other, prepare_other] =
        ["free_", "prepare_free_", "", "prepare_"].map(|prefix| format_ident!("{prefix}{lower}"));
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

/// `impl QuadraticKinetic` and `impl ForceGradient`, by what is prepared for a kick, how, and its body.
fn quadratic(context: &Context<'_>, [prepared, prepare, body]: [&TokenStream; 3]) -> TokenStream {
    let (name, array, action) = (self_type(context), context.array(), context.action());
    quote! {
        impl<R: Real> QuadraticKinetic<R> for #name {
            type Proof = ();
        }
        impl<R: Real> ForceGradient<R> for #name {
            type GradientKick = #prepared;
            #[inline]
            fn prepare_gradient_kick(&self, h: R, g: R) -> #prepared {
                #prepare
            }
            #[inline(always)]
            fn gradient_kick(&self, prepared: &#prepared, t: R, q: &mut #array, p: &mut #array, s: &mut #action) {
                #body
            }
        }
    }
}

/// The same for no scalar.
fn not_quadratic(context: &Context<'_>, marker: &Ident) -> TokenStream {
    let (name, array, action) = (self_type(context), context.array(), context.action());
    let never = quote!(::core::convert::Infallible);
    quote! {
        impl<R: Real + #marker> QuadraticKinetic<R> for #name {
            type Proof = <R as #marker>::Proof;
        }
        impl<R: Real + #marker> ForceGradient<R> for #name {
            type GradientKick = #never;
            fn prepare_gradient_kick(&self, _: R, _: R) -> #never {
                ::core::unreachable!()
            }
            fn gradient_kick(&self, never: &#never, _: R, _: &mut #array, _: &mut #array, _: &mut #action) {
                match *never {}
            }
        }
    }
}

/// Neither kick nor drift.
fn none(context: &Context<'_>, missing: Missing) -> TokenStream {
    let (name, array, action) = (self_type(context), context.array(), context.action());
    let (marker, tokens) = unsatisfied(context, missing);
    let never = quote!(::core::convert::Infallible);
    let not_quadratic = not_quadratic(context, &marker);
    let prepare = |name: &str| {
        let name = format_ident!("prepare_{name}");
        quote! {
            fn #name(&self, _: R) -> #never {
                ::core::unreachable!()
            }
        }
    };
    let flow = |name: &str| {
        let name = format_ident!("{name}");
        quote! {
            fn #name(&self, never: &#never, _: R, _: &mut #array, _: &mut #array, _: &mut #action) {
                match *never {}
            }
        }
    };
    let [prepare_kick, prepare_drift] = ["kick", "drift"].map(prepare);
    let [kick, drift] = ["kick", "drift"].map(flow);
    let mechanical = (context.form.has_action()).then(|| {
        let [prepare_kick, prepare_drift] = ["free_kick", "free_drift"].map(prepare);
        let [kick, drift] = ["free_kick", "free_drift"].map(flow);
        quote! {
            impl<R: Real + #marker> MechanicalContact<R> for #name {
                type Proof = <R as #marker>::Proof;
                type FreeKick = #never;
                type FreeDrift = #never;
                #prepare_kick
                #prepare_drift
                #kick
                #drift
                fn damping(&self, t: R) -> R {
                    t
                }
            }
        }
    });
    quote! {
        #tokens
        impl<R: Real + #marker> Separable<R> for #name {
            type Proof = <R as #marker>::Proof;
            type Kick = #never;
            type Drift = #never;
            #prepare_kick
            #prepare_drift
            #kick
            #drift
        }
        #not_quadratic
        #mechanical
    }
}

//! Flows of separable energies T + V: kicks, drifts, kicks with force gradients, and for contact systems also kick and drift of the system without its damping.

use super::kind::{Kind, Time};
use super::{FlowTokens, assign, flow, slots, stepped_as};
use crate::derive::{GradientKick, KickDrift, Missing, Undamped};
use crate::emit::context::Context;
use crate::emit::implementation::{Implementation, absent};
use crate::emit::signature::{Absent, Trait, methods};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Kick and drift. The argument `s or _` has the name `s` in a system with an action, and else `_`.
///
/// The provided methods have a default in the runtime: the flow, applied to zeros. A flow that does more than add overrides it.
pub(super) const SEPARABLE: Trait = Trait {
    name: "Separable",
    has_proof: true,
    associated: &[("Kick", Absent::Never), ("Drift", Absent::Never)],
    methods: methods! {
        Hint fn prepare_kick("h": {R}) -> Kick;
        Hint fn prepare_drift("h": {R}) -> Drift;
        Always fn kick("prepared": {&Kick}, "t": {R}, "q": {&mut Array}, "p": {&mut Array}, "s or _": {&mut Action});
        Always fn drift("prepared": {&Drift}, "t": {R}, "q": {&mut Array}, "p": {&mut Array}, "s or _": {&mut Action});
    },
    provided: methods! {
        Always fn kick_increments("prepared": {&Kick}, "t": {R}, "x": {&PerCoordinate}) -> PerCoordinate;
        Always fn drift_increments("prepared": {&Drift}, "t": {R}, "x": {&PerCoordinate}) -> PerCoordinate;
    },
};

/// The property that T is quadratic in the momenta, with a constant mass matrix M. Without it, Runge–Kutta–Nyström tables lose their order, and the bracket
/// \[V, \[T, V\]\] = F·M⁻¹F of a force gradient depends on momenta, so that its flow is no kick.
const QUADRATIC_KINETIC: Trait =
    Trait { name: "QuadraticKinetic", has_proof: true, associated: &[], methods: &[], provided: &[] };

/// Kicks with a force gradient, the gradient of F·M⁻¹F for the force F. The supertrait `QuadraticKinetic` has the proof.
const FORCE_GRADIENT: Trait = Trait {
    name: "ForceGradient",
    has_proof: false,
    associated: &[("GradientKick", Absent::Never)],
    methods: methods! {
        Hint fn prepare_gradient_kick("h": {R}, "g": {R}) -> GradientKick;
        Always fn gradient_kick("prepared": {&GradientKick}, "t": {R}, "q": {&mut Array}, "p": {&mut Array}, "s": {&mut Action});
    },
    provided: &[],
};

/// Kick and drift of a contact system without its damping, and the damping.
const MECHANICAL_CONTACT: Trait = Trait {
    name: "MechanicalContact",
    has_proof: true,
    associated: &[("FreeKick", Absent::Never), ("FreeDrift", Absent::Never)],
    methods: methods! {
        Hint fn prepare_free_kick("h": {R}) -> FreeKick;
        Hint fn prepare_free_drift("h": {R}) -> FreeDrift;
        Always fn free_kick("prepared": {&FreeKick}, "t": {R}, "q": {&mut Array}, "p": {&mut Array}, "s": {&mut Action});
        Always fn free_drift("prepared": {&FreeDrift}, "t": {R}, "q": {&mut Array}, "p": {&mut Array}, "s": {&mut Action});
        Always fn damping("t": {R}) -> R;
    },
    provided: &[],
};

/// Returns `impl Separable`, `impl QuadraticKinetic`, `impl ForceGradient`, and for contact systems `impl MechanicalContact`. If the system has no kick and
/// drift, no scalar satisfies them, so that their use is a compile error that states the reason.
pub(in crate::emit) fn splitting(context: &Context<'_>, found: &Result<KickDrift, Missing>) -> TokenStream {
    match found {
        Ok(flows) => separable(context, flows),
        Err(missing) if context.form.has_action() => {
            // `ContactLeapfrog` needs kick and drift without damping, so it is absent for the same reason.
            let stepped = stepped_as(context, "ContactLeapfrog", &quote!(ExplicitLeapfrog), Some(*missing));
            let absent =
                absent(context, *missing, &[&SEPARABLE, &QUADRATIC_KINETIC, &FORCE_GRADIENT, &MECHANICAL_CONTACT]);
            quote!(#absent #stepped)
        }
        Err(missing) => absent(context, *missing, &[&SEPARABLE, &QUADRATIC_KINETIC, &FORCE_GRADIENT]),
    }
}

/// Returns the implementations for a system with kick and drift.
fn separable(context: &Context<'_>, flows: &KickDrift) -> TokenStream {
    let [kick, drift] = [&flows.kick, &flows.drift].map(|each| flow(context, each));
    let types = [("Kick", kick.prepared.clone()), ("Drift", drift.prepared.clone())];
    // With an action, flows also change s, and a flow with damping multiplies p and s. They do more than add to one
    // array, so a compensated sum takes their increments.
    let adds = !context.form.has_action();
    // A kick is the flow of V at frozen time. If neither T nor V reads time, the last kick of a step and the first kick of the next step have the same
    // impulse, and the runtime may compute it once. If a kick outside the domain of the energy makes momenta non-finite, and a step ends with a kick, the
    // runtime omits the test of the domain.
    let kick_kind = Kind {
        adds,
        time: if flows.kicks_repeat { Time::Unread } else { Time::Frozen },
        shows_domain: flows.kicks_show,
        parts: None,
    };
    // A drift that is exact in time starts at the time that drifts have reached. Otherwise it is the flow of T at the time that kicks have reached. The
    // runtime reads `shows_domain` of kicks only.
    let drift_kind = Kind {
        adds,
        time: if flows.time_passes_in_drift { Time::Exact } else { Time::Frozen },
        shows_domain: false,
        parts: None,
    };
    let implementation = Implementation::new(context, &SEPARABLE, &types)
        .items(kick_kind.constant(context, "KICK"))
        .items(drift_kind.constant(context, "DRIFT"))
        .types()
        .method("prepare_kick", kick.prepare.clone())
        .method("prepare_drift", drift.prepare.clone());
    let implementation = moves(moves(implementation, "kick", &kick), "drift", &drift).finish();
    let gradient_kick = match &flows.gradient_kick {
        // The force gradient is 2 ∂F/∂q·M⁻¹F. The kernel of collocation has F and ∂F/∂q. With few degrees of freedom, a kernel for their product alone would
        // hardly be shorter, so the runtime's function `gradient_kick` uses that kernel, and users compile less code.
        Ok(GradientKick::Collocation) => quadratic(
            context,
            quote!((<Self as Collocation<R>>::Constants, [R; 2])),
            quote!((self.constants(), [h, g])),
            quote!(gradient_kick(self, prepared, t, q, p);),
        ),
        Ok(GradientKick::Flow(flow)) => {
            let slots = slots(flow);
            quadratic(context, quote!([R; #slots]), context.stored(&flow.kernel, 0), assign(context, flow))
        }
        Err(missing) => absent(context, *missing, &[&QUADRATIC_KINETIC, &FORCE_GRADIENT]),
    };
    let mechanical = flows.undamped.as_ref().map(|undamped| mechanical(context, undamped));
    quote!(#implementation #gradient_kick #mechanical)
}

/// Adds the methods of a flow to an implementation: `name` moves a point, `name_increments` returns its increments, if they have a kernel.
pub(super) fn moves<'a>(implementation: Implementation<'a>, name: &str, flow: &FlowTokens) -> Implementation<'a> {
    let implementation = implementation.method(name, flow.flow.clone());
    match &flow.increments {
        Some(increments) => implementation.method(&format!("{name}_increments"), increments.clone()),
        None => implementation,
    }
}

/// Returns `impl MechanicalContact` and the steps of `ContactLeapfrog`. `ContactLeapfrog` has its own factors of damping. It needs the flows of T and V
/// alone, at frozen time. A kick or drift that equals the one of `Separable` gets no kernel of its own, and calls that one.
fn mechanical(context: &Context<'_>, undamped: &Undamped) -> TokenStream {
    let damping = context.returned(&undamped.damping);
    let [kick, drift] =
        &[&undamped.kick, &undamped.drift].map(|found| found.as_ref().map(|found| flow(context, found)));
    // The type of the prepared numbers in signatures.
    let numbers = |own: &Option<FlowTokens>, name: TokenStream| own.as_ref().map_or(name, |own| own.prepared.clone());
    let types =
        [("FreeKick", numbers(kick, quote!(Self::FreeKick))), ("FreeDrift", numbers(drift, quote!(Self::FreeDrift)))];
    let mut implementation = Implementation::new(context, &MECHANICAL_CONTACT, &types);
    for (own, ty, name) in [(kick, "Kick", "kick"), (drift, "Drift", "drift")] {
        let [ty, free_type] = [format_ident!("{ty}"), format_ident!("Free{ty}")];
        let (given, prepare, flow) = match own {
            Some(FlowTokens { prepared, prepare, flow, .. }) => (prepared.clone(), prepare.clone(), flow.clone()),
            None => {
                let [prepare, name] = [format_ident!("prepare_{name}"), format_ident!("{name}")];
                let flow = quote!(self.#name(prepared, t, q, p, s););
                (quote!(<Self as Separable<R>>::#ty), quote!(self.#prepare(h)), flow)
            }
        };
        implementation = implementation
            .items(quote!(type #free_type = #given;))
            .method(&format!("prepare_free_{name}"), prepare)
            .method(&format!("free_{name}"), flow);
    }
    let implementation = implementation.method("damping", damping).finish();
    let stepped = stepped_as(context, "ContactLeapfrog", &quote!(ExplicitLeapfrog), None);
    quote!(#implementation #stepped)
}

/// Returns `impl QuadraticKinetic` and `impl ForceGradient`: `prepared` is the type of the prepared numbers of a kick with a force gradient, `prepare` computes
/// them, and `body` applies the kick.
pub(super) fn quadratic(
    context: &Context<'_>,
    prepared: TokenStream,
    prepare: TokenStream,
    body: TokenStream,
) -> TokenStream {
    let proof = Implementation::new(context, &QUADRATIC_KINETIC, &[]).finish();
    let types = [("GradientKick", prepared)];
    let kick = Implementation::new(context, &FORCE_GRADIENT, &types)
        .types()
        .method("prepare_gradient_kick", prepare)
        .method("gradient_kick", body)
        .finish();
    quote!(#proof #kick)
}

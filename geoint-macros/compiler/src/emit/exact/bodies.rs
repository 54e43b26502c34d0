//! Flows of rigid bodies, with or without centres of mass: kicks, the drift, and rotations about principal axes.

use super::kick_drift::{SEPARABLE, moves, quadratic};
use super::kind::{Kind, Time};
use super::{assign, flow, slots};
use crate::derive::{BodyKernels, Shift, Turn};
use crate::emit::context::Context;
use crate::emit::implementation::{Implementation, proven};
use crate::emit::tokens::{Tokens, element};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// Returns the implementations for rigid bodies.
pub(in crate::emit) fn bodies(context: &Context<'_>, bodies: &BodyKernels) -> TokenStream {
    let splitting = splitting(context, bodies);
    let rotations = bodies.principal.then(|| rotations(context, bodies));
    quote!(#splitting #rotations)
}

/// Returns the function of `PhaseSpace` that returns the attitudes of the bodies.
pub(in crate::emit) fn attitudes(context: &Context<'_>, bodies: &BodyKernels) -> TokenStream {
    let phase = context.phase_type();
    let rows = if bodies.centres.is_empty() { quote!(z[0]) } else { quote!(z[0][0]) };
    quote! {
        #[inline(always)]
        fn attitudes(z: &mut #phase) -> &mut [[R; 4]] {
            &mut #rows
        }
    }
}

/// Returns `impl Separable`, `impl QuadraticKinetic`, `impl ForceGradient`.
fn splitting(context: &Context<'_>, bodies: &BodyKernels) -> TokenStream {
    let phase = context.phase_type();
    let kick = flow(context, &bodies.kick);
    let entries = Literal::usize_unsuffixed(bodies.drift.nodes().len());
    let count = bodies.turns.len();
    let turns = bodies.turns.iter().enumerate().map(|(body, turn)| {
        let [attitude, momentum] = rows(bodies, body);
        free_rotation(turn, &attitude, &momentum)
    });
    let numbers = (0..count).map(Literal::usize_unsuffixed).collect::<Vec<_>>();
    let [mut places, mut changes] = [0, 1].map(|half| {
        let half = Literal::usize_unsuffixed(half);
        quote!([#(turned[#numbers][#half]),*])
    });
    if !bodies.centres.is_empty() {
        let shifts = bodies.centres.iter().map(|centre| {
            let shifts = centre.iter().map(|each| shift(context, each));
            quote!([#(#shifts,)* R::from_f64(0.0)])
        });
        let count = Literal::usize_unsuffixed(count);
        places = quote!([#places, [#(#shifts),*]]);
        changes = quote!([#changes, [[R::from_f64(0.0); 4]; #count]]);
    }
    let types = [("Kick", kick.prepared.clone()), ("Drift", quote!([R; #entries]))];
    let time = if bodies.kicks_repeat { Time::Unread } else { Time::Frozen };
    let kick_kind = Kind { adds: true, time, shows_domain: false, parts: None };
    let drift_kind = Kind { adds: false, time: Time::Frozen, shows_domain: false, parts: None };
    let implementation = Implementation::new(context, &SEPARABLE, &types)
        .items(kick_kind.constant(context, "KICK"))
        .items(drift_kind.constant(context, "DRIFT"))
        .types()
        .method("prepare_kick", kick.prepare.clone())
        .method("prepare_drift", context.returned(&bodies.drift));
    let array = context.positions_type();
    let separable = moves(implementation, "kick", &kick)
        .items(quote! {
            #[inline(always)]
            fn drift(&self, drift: &[R; #entries], t: R, q: &mut #array, p: &mut #array, _: &mut ()) {
                let d = self.drift_increments(drift, t, &PerCoordinate { z: [*q, *p], s: () });
                q.add_scaled(R::from_f64(1.0), &d.z[0]);
                p.add_scaled(R::from_f64(1.0), &d.z[1]);
            }
            #[inline]
            fn drift_increments(&self, drift: &[R; #entries], _: R, x: &PerCoordinate<#phase>) -> PerCoordinate<#phase> {
                let [q, p] = &x.z;
                let turned = [#(#turns),*];
                PerCoordinate { z: [#places, #changes], s: () }
            }
        })
        .finish();
    let slots = slots(&bodies.gradient_kick);
    let (prepare, body) = (context.stored(&bodies.gradient_kick.kernel, 0), assign(context, &bodies.gradient_kick));
    let gradient = quadratic(context, quote!([R; #slots]), prepare, body);
    quote!(#separable #gradient)
}

/// Returns a prepared number: `drift[place]`.
fn prepared(place: usize) -> TokenStream {
    let place = Literal::usize_unsuffixed(place);
    quote!(drift[#place])
}

/// Returns a prepared number, or zero.
fn or_zero(place: Option<usize>) -> TokenStream {
    place.map_or_else(|| quote!(R::from_f64(0.0)), prepared)
}

/// Returns the attitude and the momentum of a body: `q[body]` and `p[body]`, or `q[0][body]` and `p[0][body]` with centres of mass.
fn rows(bodies: &BodyKernels, body: usize) -> [Tokens; 2] {
    let indices = if bodies.centres.is_empty() { vec![body] } else { vec![0, body] };
    ["q", "p"].map(|half| element(half, &indices))
}

/// Returns the increment of a coordinate of a centre of mass in a drift.
fn shift(context: &Context<'_>, Shift { linear, constant }: &Shift) -> TokenStream {
    let products = linear.iter().map(|(place, symbol)| {
        let (entry, p) = (prepared(*place), context.input(*symbol));
        quote!(#entry * #p)
    });
    let terms = products.chain(constant.map(prepared));
    terms.reduce(|sum, term| quote!(#sum + #term)).unwrap_or_else(|| quote!(R::from_f64(0.0)))
}

/// Returns the increments of the attitude `r` and the momentum `m` of a body in a free rotation.
fn free_rotation(turn: &Turn, r: &Tokens, m: &Tokens) -> TokenStream {
    if let Some(axis) = turn.symmetry {
        let moments = [(axis + 1) % 3, axis].map(|i| or_zero(turn.linear[i][i]));
        let axis = Literal::usize_unsuffixed(axis);
        return quote!(slope::symmetric_rotation(#axis, [#(#moments),*], &#r, &#m));
    }
    let rows = turn.linear.iter().map(|row| {
        let terms = row.iter().enumerate().filter_map(|(j, place)| place.map(|place| (j, place)));
        let products = terms.map(|(j, place)| {
            let (j, entry) = (Literal::usize_unsuffixed(j), prepared(place));
            quote!(#entry * m[#j])
        });
        products.reduce(|sum, product| quote!(#sum + #product)).unwrap_or_else(|| quote!(R::from_f64(0.0)))
    });
    let constant = turn.constant.iter().map(|place| or_zero(*place));
    quote!(slope::free_rotation(|m: &[R; 3]| [#(#rows),*], &[#(#constant),*], &#r, &#m))
}

/// Returns `impl PrincipalAxes`.
fn rotations(context: &Context<'_>, bodies: &BodyKernels) -> TokenStream {
    let (array, entries) = (context.positions_type(), Literal::usize_unsuffixed(bodies.drift.nodes().len()));
    let rotations = bodies.turns.iter().enumerate().map(|(body, turn)| {
        let [r, m] = rows(bodies, body);
        let inverse = (0..3).map(|i| or_zero(turn.linear[i][i]));
        quote!(slope::five_rotations(&[#(#inverse),*], &mut #r, &mut #m);)
    });
    let mut shifts = TokenStream::new();
    for (body, centre) in bodies.centres.iter().enumerate() {
        for (axis, each) in centre.iter().enumerate() {
            let (place, change) = (element("q", &[1, body, axis]), shift(context, each));
            shifts.extend(quote!(#place = #place + (#change);));
        }
    }
    let items = quote! {
        #[inline(always)]
        fn rotate(&self, drift: &[R; #entries], q: &mut #array, p: &mut #array) {
            #(#rotations)*
            #shifts
        }
    };
    proven(context, quote!(PrincipalAxes<R>), items)
}

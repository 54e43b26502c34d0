//! Rigid bodies, with centres of mass or without: their phase space, kicks, and the exact drift.

use super::{assign, flow, slots};
use crate::derive::{Bodies, Shift, Turn};
use crate::emit::domain::domain;
use crate::emit::kernel::Context;
use crate::emit::structure::{self_type, state_type};
use crate::emit::system::halves;
use crate::emit::tokens::{Tokens, element};
use crate::ir::Graph;
use crate::parse::over_scalar;
use crate::schedule::Plan;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// Everything that is emitted beside the user's function and the inherent functions.
pub(in crate::emit) fn bodies(context: &Context<'_>, graph: &Graph, bodies: &Bodies<Plan>) -> TokenStream {
    let (space, splitting) = (space(context, graph, bodies), splitting(context, bodies));
    let rotations = bodies.principal.then(|| rotations(context, bodies));
    quote!(#space #splitting #rotations)
}

/// The energy, where it is defined, and the rates.
fn space(context: &Context<'_>, graph: &Graph, bodies: &Bodies<Plan>) -> TokenStream {
    let (name, array, phase, parts) = (self_type(context), context.array(), context.phase(), context.parts());
    let over_scalar = |ty: &syn::Type| over_scalar(ty, &context.energy.float, &format_ident!("R"));
    let state = state_type(context, over_scalar);
    let attitudes = over_scalar(&context.energy.coordinates.ty);
    let (coordinates, rows) = match context.energy.centres().map(over_scalar) {
        Some(centres) => (quote!(Placed<#attitudes, #centres>), quote!(z[0][0])),
        None => (quote!(#attitudes), quote!(z[0])),
    };
    let value = context.values(&bodies.value, |mut values| values.remove(0));
    let rate = context.values(&bodies.rate, |values| halves(context, &values));
    let domain = domain(context, graph, &bodies.domain);
    quote! {
        impl<R: Real> PhaseSpace<R> for #name {
            type State = #state;
            type Phase = #phase;
            type Action = ();

            #[inline]
            fn hamiltonian(&self, t: R, z: &#phase, _: &()) -> R {
                #parts
                #value
            }
            #[inline(always)]
            fn attitudes(z: &mut #phase) -> &mut [[R; 4]] {
                &mut #rows
            }
            #domain
        }
        impl<R: Real> CotangentSpace<R> for #name {
            type Coordinates = #coordinates;
            type Array = #array;
        }
        impl<R: Real> DifferentialEquation<R> for #name {
            type Proof = ();
            #[inline(always)]
            fn rate(&self, t: R, z: &#phase, slopes: &mut #phase) {
                #parts
                #rate
            }
        }
    }
}

/// `impl Separable`, `impl QuadraticKinetic`, `impl ForceGradient`.
fn splitting(context: &Context<'_>, bodies: &Bodies<Plan>) -> TokenStream {
    let (name, array, phase) = (self_type(context), context.array(), context.phase());
    let (kick_type, prepare_kick, kick) = flow(context, "kick", &bodies.kick);
    let repeats = bodies.repeats;
    let entries = Literal::usize_unsuffixed(bodies.drift.last[0].results.len());
    let drift = context.values(&bodies.drift, |values| quote!([#(#values),*]));
    let (count, centres) = (bodies.turns.len(), !bodies.shifts.is_empty());
    let turns = bodies.turns.iter().enumerate().map(|(body, turn)| {
        let [r, m] = ["q", "p"].map(|half| row(half, centres.then_some(0), body));
        free_rotation(turn, &r, &m)
    });
    let numbers = (0..count).map(Literal::usize_unsuffixed).collect::<Vec<_>>();
    let [mut places, mut changes] = [0, 1].map(|half| {
        let half = Literal::usize_unsuffixed(half);
        quote!([#(turned[#numbers][#half]),*])
    });
    if centres {
        let shifts = bodies.shifts.chunks(3).map(|row| {
            let shifts = row.iter().map(|each| shift(context, each));
            quote!([#(#shifts,)* R::from_f64(0.0)])
        });
        let count = Literal::usize_unsuffixed(count);
        places = quote!([#places, [#(#shifts),*]]);
        changes = quote!([#changes, [[R::from_f64(0.0); 4]; #count]]);
    }
    let (gradient_slots, prepare_gradient) =
        (slots(&bodies.gradient_kick), context.stored(&bodies.gradient_kick.kernel, 0));
    let gradient_kick = assign(context, &bodies.gradient_kick);
    quote! {
        impl<R: Real> Separable<R> for #name {
            type Proof = ();
            const KICKS_REPEAT: bool = #repeats;
            const DRIFTS_SHIFT: bool = false;
            type Kick = #kick_type;
            type Drift = [R; #entries];
            #prepare_kick
            #[inline]
            fn prepare_drift(&self, h: R) -> [R; #entries] {
                #drift
            }
            #kick
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
        }
        impl<R: Real> QuadraticKinetic<R> for #name {
            type Proof = ();
        }
        impl<R: Real> ForceGradient<R> for #name {
            type GradientKick = [R; #gradient_slots];
            #[inline]
            fn prepare_gradient_kick(&self, h: R, g: R) -> [R; #gradient_slots] {
                #prepare_gradient
            }
            #[inline(always)]
            fn gradient_kick(&self, prepared: &[R; #gradient_slots], t: R, q: &mut #array, p: &mut #array, _: &mut ()) {
                #gradient_kick
            }
        }
    }
}

/// `drift[k]`
fn prepared(place: usize) -> TokenStream {
    let place = Literal::usize_unsuffixed(place);
    quote!(drift[#place])
}

/// A place, or zero.
fn or_zero(place: Option<usize>) -> TokenStream {
    place.map_or_else(|| quote!(R::from_f64(0.0)), prepared)
}

/// `q[0][body]`, or `q[body]`
fn row(half: &str, level: Option<usize>, body: usize) -> Tokens {
    element(half, &level.into_iter().chain([body]).collect::<Vec<_>>())
}

/// What a drift adds to a coordinate of a centre of mass.
fn shift(context: &Context<'_>, Shift { linear, constant }: &Shift) -> TokenStream {
    let products = linear.iter().map(|(place, symbol)| {
        let (entry, p) = (prepared(*place), context.input(*symbol));
        quote!(#entry * #p)
    });
    let terms = products.chain(constant.map(prepared));
    terms.reduce(|sum, term| quote!(#sum + #term)).unwrap_or_else(|| quote!(R::from_f64(0.0)))
}

/// What a free rotation adds to the attitude and the momentum of a body.
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

/// `impl PrincipalAxes`.
fn rotations(context: &Context<'_>, bodies: &Bodies<Plan>) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let entries = Literal::usize_unsuffixed(bodies.drift.last[0].results.len());
    let centres = !bodies.shifts.is_empty();
    let rotations = bodies.turns.iter().enumerate().map(|(body, turn)| {
        let [r, m] = ["q", "p"].map(|half| row(half, centres.then_some(0), body));
        let inverse = (0..3).map(|i| or_zero(turn.linear[i][i]));
        quote!(slope::five_rotations(&[#(#inverse),*], &mut #r, &mut #m);)
    });
    let shifts = bodies.shifts.iter().enumerate().map(|(i, each)| {
        let (place, change) = (element("q", &[1, i / 3, i % 3]), shift(context, each));
        quote!(#place = #place + (#change);)
    });
    quote! {
        impl<R: Real> PrincipalAxes<R> for #name {
            type Proof = ();
            #[inline(always)]
            fn rotate(&self, drift: &[R; #entries], q: &mut #array, p: &mut #array) {
                #(#rotations)*
                #(#shifts)*
            }
        }
    }
}

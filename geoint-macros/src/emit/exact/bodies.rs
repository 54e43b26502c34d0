//! Rigid bodies: their phase space, kicks, and the exact drift.

use super::{assign, flow, slots};
use crate::derive::{Bodies, Turn};
use crate::emit::domain::domain;
use crate::emit::kernel::Context;
use crate::emit::system::{halves, self_type};
use crate::ir::Graph;
use crate::parse::over_scalar;
use crate::schedule::Plan;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// Everything that is emitted beside the user's function and the inherent functions.
pub(in crate::emit) fn bodies(context: &Context<'_>, graph: &Graph, bodies: &Bodies<Plan>) -> TokenStream {
    let (space, splitting) = (space(context, graph, bodies), splitting(context, bodies));
    let rotations = bodies.principal.then(|| rotations(context, &bodies.turns));
    quote!(#space #splitting #rotations)
}

/// The energy, where it is defined, and the rates.
fn space(context: &Context<'_>, graph: &Graph, bodies: &Bodies<Plan>) -> TokenStream {
    let (name, array, phase, parts) = (self_type(context), context.array(), context.phase(), context.parts());
    let coordinates = over_scalar(&context.energy.coordinates.ty, &context.energy.float, &format_ident!("R"));
    let value = context.values(&bodies.value, |mut values| values.remove(0));
    let rate = context.values(&bodies.rate, |values| halves(context, &values));
    let domain = domain(context, graph, &bodies.domain);
    quote! {
        impl<R: Real> PhaseSpace<R> for #name {
            type State = BodyState<#coordinates>;
            type Phase = #phase;
            type Action = ();

            #[inline]
            fn hamiltonian(&self, t: R, z: &#phase, _: &()) -> R {
                #parts
                #value
            }
            #[inline(always)]
            fn attitudes(z: &mut #phase) -> &mut [[R; 4]] {
                &mut z[0]
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
    let entries = Literal::usize_unsuffixed(entries(&bodies.turns));
    let drift = context.values(&bodies.drift, |values| quote!([#(#values),*]));
    let turns = bodies.turns.iter().enumerate().map(|(body, turn)| free_rotation(body, turn));
    let numbers = (0..bodies.turns.len()).map(Literal::usize_unsuffixed).collect::<Vec<_>>();
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
                PerCoordinate { z: [[#(turned[#numbers][0]),*], [#(turned[#numbers][1]),*]], s: () }
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

/// How many numbers are prepared for a drift.
fn entries(turns: &[Turn]) -> usize {
    let of = |turn: &Turn| turn.linear.iter().flatten().chain(&turn.constant).flatten().count();
    turns.iter().map(of).sum()
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

/// What a free rotation adds to the attitude and the momentum of a body.
fn free_rotation(body: usize, turn: &Turn) -> TokenStream {
    let body = Literal::usize_unsuffixed(body);
    let rows = turn.linear.iter().map(|row| {
        let terms = row.iter().enumerate().filter_map(|(j, place)| place.map(|place| (j, place)));
        let products = terms.map(|(j, place)| {
            let (j, entry) = (Literal::usize_unsuffixed(j), prepared(place));
            quote!(#entry * m[#j])
        });
        products.reduce(|sum, product| quote!(#sum + #product)).unwrap_or_else(|| quote!(R::from_f64(0.0)))
    });
    let constant = turn.constant.iter().map(|place| or_zero(*place));
    quote!(slope::free_rotation(|m: &[R; 3]| [#(#rows),*], &[#(#constant),*], &q[#body], &p[#body]))
}

/// `impl PrincipalAxes`.
fn rotations(context: &Context<'_>, turns: &[Turn]) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let entries = Literal::usize_unsuffixed(entries(turns));
    let rotations = turns.iter().enumerate().map(|(body, turn)| {
        let body = Literal::usize_unsuffixed(body);
        let inverse = (0..3).map(|i| or_zero(turn.linear[i][i]));
        quote!(slope::five_rotations(&[#(#inverse),*], &mut q[#body], &mut p[#body]);)
    });
    quote! {
        impl<R: Real> PrincipalAxes<R> for #name {
            type Proof = ();
            #[inline(always)]
            fn rotate(&self, drift: &[R; #entries], q: &mut #array, p: &mut #array) {
                #(#rotations)*
            }
        }
    }
}

//! Rigid bodies, with centres of mass or without: their phase space, kicks, and the exact drift.

use super::kick_drift::{SEPARABLE, moves, quadratic};
use super::{assign, flow, slots};
use crate::derive::{BodyKernels, Shift, Turn};
use crate::emit::implementation::Implementation;
use crate::emit::kernel::Context;
use crate::emit::structure::self_type;
use crate::emit::tokens::{Tokens, element};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// Kicks and drifts.
pub(in crate::emit) fn bodies(context: &Context<'_>, bodies: &BodyKernels) -> TokenStream {
    let splitting = splitting(context, bodies);
    let rotations = bodies.principal.then(|| rotations(context, bodies));
    quote!(#splitting #rotations)
}

/// The function of `PhaseSpace` that returns the attitudes among the coordinates.
pub(in crate::emit) fn attitudes(context: &Context<'_>, bodies: &BodyKernels) -> TokenStream {
    let phase = context.phase();
    let rows = if bodies.shifts.is_empty() { quote!(z[0]) } else { quote!(z[0][0]) };
    quote! {
        #[inline(always)]
        fn attitudes(z: &mut #phase) -> &mut [[R; 4]] {
            &mut #rows
        }
    }
}

/// `impl Separable`, `impl QuadraticKinetic`, `impl ForceGradient`.
fn splitting(context: &Context<'_>, bodies: &BodyKernels) -> TokenStream {
    let phase = context.phase();
    let kick = flow(context, &bodies.kick);
    let entries = Literal::usize_unsuffixed(bodies.drift.nodes().len());
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
    let (repeats, kick_type, drift_type) = (bodies.repeats, kick.prepared.clone(), quote!([R; #entries]));
    let types = [("Kick", kick_type.clone()), ("Drift", drift_type.clone())];
    let implementation = Implementation::new(context, &SEPARABLE, &types)
        .items(quote! {
            type Proof = ();
            const KICKS_REPEAT: bool = #repeats;
            const DRIFTS_SHIFT: bool = false;
            type Kick = #kick_type;
            type Drift = #drift_type;
        })
        .method("prepare_kick", kick.prepare.clone())
        .method("prepare_drift", context.returned(&bodies.drift));
    let array = context.array();
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
fn rotations(context: &Context<'_>, bodies: &BodyKernels) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let entries = Literal::usize_unsuffixed(bodies.drift.nodes().len());
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

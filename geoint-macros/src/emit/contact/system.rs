//! The energy of a contact system with its gradient, and what users call.

use super::super::domain;
use super::super::kernel::{Context, write};
use super::super::system::self_type;
use crate::analyze;
use crate::diff::Gradient;
use crate::ir::{Graph, Id};
use crate::parse::over_scalar;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

pub(super) fn contact(
    context: &Context<'_>,
    graph: &mut Graph,
    (energy, gradient): (Id, &Gradient),
    bounds: &TokenStream,
) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let coordinates = over_scalar(&context.energy.coordinates.ty, &context.energy.float, &format_ident!("R"));
    // Momenta that are not followed give no energy.
    let value = match context.energy.lift {
        Some(_) => quote!(R::from_f64(f64::NAN)),
        None => context.routine(graph, &[energy], |mut values| values.remove(0)),
    };
    let domain = domain::domain(context, graph, energy, None);
    let places = context.coordinates();
    let roots = [&gradient.q[..], &gradient.p, &[gradient.s]].concat();
    let slopes = context.routine(graph, &roots, |values| {
        let (q, rest) = values.split_at(places.len());
        let (p, s) = rest.split_at(places.len());
        let (q, p) = (write("dq", &places, q), write("dp", &places, p));
        quote!(#q #p *ds = #(#s)*;)
    });
    quote! {
        impl<R: #bounds> PhaseSpace<R> for #name {
            type Coordinates = #coordinates;
            type Array = #array;
            type Action = R;

            #[inline]
            fn hamiltonian(&self, t: R, q: &#array, p: &#array, s: &R) -> R {
                #value
            }
            #domain
        }
        impl<R: #bounds> ContactSystem<R> for #name {
            #[inline]
            fn gradient(
                &self, t: R, q: &#array, p: &#array, s: &R, dq: &mut #array, dp: &mut #array, ds: &mut R,
            ) {
                #slopes
            }
        }
    }
}

/// `impl Conformal`, if ∂H/∂s depends on time alone: (q, p) then moves without s.
pub(super) fn conformal(context: &Context<'_>, graph: &Graph, decay: Id, bounds: &TokenStream) -> Option<TokenStream> {
    let name = self_type(context);
    (!analyze::reads(graph, decay).state()).then(|| quote!(impl<R: #bounds> ConformalContact<R> for #name {}))
}

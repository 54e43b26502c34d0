//! The field of collocation, with its derivatives.

use super::prepared::Prepared;
use super::write_field;
use crate::derive::FieldKernels;
use crate::emit::kernel::{Context, write};
use crate::emit::structure::self_type;
use crate::emit::tokens::element;
use crate::ir::Symbol;
use crate::schedule::Plan;
use proc_macro2::TokenStream;
use quote::quote;

/// `impl Collocation`.
pub(super) fn collocation(context: &Context<'_>, field: &FieldKernels<Plan>) -> TokenStream {
    let (name, phase) = (self_type(context), context.phase());
    let FieldKernels { coordinates, collocation: plan, .. } = field;
    let unknown = context.unknown_type(coordinates.len());
    let places = context.unknown_places(coordinates.len());
    let Prepared { types, functions, prepared, .. } = Prepared::for_stages(context, plan, ["Constants", "constants"]);
    let evaluate = context.body(&plan.last[0], (coordinates, "y"), |values| {
        write_field(context, ["f", "jacobian"], &plan.last[0], &values)
    });
    let momenta = momenta(context.energy.degrees());
    let velocity = context.planned(&plan.last[1], (&momenta, "p"), |values| write("velocity", &places, &values));
    let y: Vec<_> = places.iter().map(|indices| element("y", indices)).collect();
    let [derivative, start, add, increments] = if field.second_order {
        let add =
            context.planned(&plan.last[2], (&momenta, "f"), |values| quote!(#(#y = w.multiply_add(#values, #y);)*));
        [quote!(2), quote!((z[0], z[1])), add, quote!([*change, *impulse])]
    } else {
        let f = places.iter().map(|indices| element("f", indices));
        let add = quote!(#(#y = w.multiply_add(#f, #y);)*);
        [quote!(1), quote!((*z, *z)), add, quote!(*change)]
    };
    let stages = if field.canonical.is_some() { quote!(ByCanonical) } else { quote!(ByField) };
    quote! {
        impl<R: Real> Collocated<R> for #name {
            type Proof = ();
            type Stages = #stages;
        }
        impl<R: Real> Collocation<R> for #name {
            type Proof = ();
            type Unknown = #unknown;
            #types
            const DERIVATIVE: usize = #derivative;

            #functions
            #[inline(always)]
            fn start(z: &#phase) -> (#unknown, #unknown) {
                #start
            }
            #[inline(always)]
            fn velocity(&self, prepared: &#prepared, p: &#unknown) -> #unknown {
                let mut velocity = <#unknown as Array>::zero();
                #velocity
                velocity
            }
            #[inline(always)]
            fn field(
                &self,
                prepared: &#prepared,
                t: R,
                y: &#unknown,
                f: &mut #unknown,
                jacobian: &mut Square<#unknown>,
            ) #evaluate
            #[inline(always)]
            fn add(&self, prepared: &#prepared, w: R, f: &#unknown, y: &mut #unknown) {
                #add
            }
            #[inline(always)]
            fn increments(change: &#unknown, impulse: &#unknown) -> #phase {
                #increments
            }
        }
    }
}

fn momenta(degrees: u32) -> Vec<Symbol> {
    (0..degrees).map(Symbol::Momentum).collect()
}

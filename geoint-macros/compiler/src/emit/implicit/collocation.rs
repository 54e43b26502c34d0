//! The field of collocation methods, with its derivatives.

use super::methods;
use super::prepared::Prepared;
use crate::derive::{Collocation, FieldKernels};
use crate::emit::context::{Context, array_type};
use crate::emit::implementation::proven;
use crate::emit::tokens::element;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns `impl Collocation`, and the stages of `Gauss`.
pub(super) fn collocation(context: &Context<'_>, field: &FieldKernels) -> TokenStream {
    let phase = context.phase_type();
    let FieldKernels { coordinates, collocation: Collocation { second_order, kernel }, .. } = field;
    let unknown = array_type(&coordinates.extents);
    let places: Vec<_> = coordinates.places().into_iter().map(|(_, place)| place).collect();
    let Prepared { types, functions, prepared, .. } = Prepared::for_stages(context, kernel, ["Constants", "constants"]);
    let evaluate = context.body(kernel.routine("field"));
    let velocity = context.assigned(kernel.routine("velocity"));
    let y: Vec<_> = places.iter().map(|indices| element("y", indices)).collect();
    let [equation_order, start, add, increments] = if *second_order {
        let add = context.outputs(kernel.routine("acceleration"), |outputs| {
            let values = outputs.iter().flat_map(|values| &values.all);
            quote!(#(#y = w.multiply_add(#values, #y);)*)
        });
        [quote!(EquationOrder::Second), quote!((z[0], z[1])), add, quote!([*change, *impulse])]
    } else {
        let f = places.iter().map(|indices| element("f", indices));
        let add = quote!(#(#y = w.multiply_add(#f, #y);)*);
        [quote!(EquationOrder::First), quote!((*z, *z)), add, quote!(*change)]
    };
    let stages = if field.canonical.is_some() { "CanonicalStages" } else { "FieldStages" };
    let collocated = methods::collocated(context, "GaussCollocation", stages);
    let items = quote! {
        type Unknown = #unknown;
        #types
        const EQUATION_ORDER: EquationOrder = #equation_order;

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
    };
    let collocation = proven(context, quote!(Collocation<R>), items);
    quote!(#collocated #collocation)
}

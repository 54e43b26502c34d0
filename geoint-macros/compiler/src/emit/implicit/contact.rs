//! Equations of the implicit steps and of the stages of contact systems.

use super::methods;
use super::prepared::Prepared;
use crate::derive::{StageKernel, StepKernel};
use crate::emit::context::{Context, array_type};
use crate::emit::implementation::proven;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns `impl ContactEquation` for a method.
pub(super) fn step(context: &Context<'_>, method: &str, step: &StepKernel) -> TokenStream {
    let StepKernel { unknowns, kernel } = step;
    let (method, unknown) = (format_ident!("{method}"), array_type(&unknowns.extents));
    let names = [["Constants", "constants"], ["Start", "begin"]];
    let Prepared { types, functions, prepared, started } =
        Prepared::for_steps(context, kernel, names, &quote!(), &quote!(t: R, x: &#unknown));
    let (image, end) = (context.body(kernel.routine("image")), context.returned(kernel.routine("end")));
    let items = quote! {
        type Unknown = #unknown;
        #types

        #functions
        #[inline(always)]
        fn image(
            &self,
            prepared: &#prepared,
            start: &#started,
            d: &#unknown,
            f: &mut #unknown,
            matrix: &mut Square<#unknown>,
        ) #image
        #[inline(always)]
        fn end(&self, prepared: &#prepared, start: &#started, d: &#unknown) -> #unknown {
            #end
        }
    };
    proven(context, quote!(ContactEquation<#method, R>), items)
}

/// Returns `impl ContactStages`, and the stages of `ContactGauss`.
pub(super) fn stages(context: &Context<'_>, stages: &StageKernel) -> TokenStream {
    let StageKernel { moved, kernel } = stages;
    let unknown = array_type(&moved.extents);
    let Prepared { types, functions, prepared, .. } =
        Prepared::for_stages(context, kernel, ["StageConstants", "stage_constants"]);
    let body = context.body(kernel.routine("stage"));
    let [decay, action] = ["decay", "action"].map(|name| context.returned(kernel.routine(name)));
    let (phase, parts) = (context.phase_type(), context.parts());
    let collocated = methods::collocated(context, "ContactGaussCollocation", "ContactFieldStages");
    let items = quote! {
        type Moved = #unknown;
        #types

        #functions
        #[inline(always)]
        fn stage(
            &self,
            prepared: &#prepared,
            t: R,
            x: &#unknown,
            (f, decay): (&mut #unknown, &mut R),
            (f_by, decay_by): (&mut Square<#unknown>, &mut #unknown),
        ) #body
        #[inline]
        fn decay(&self, prepared: &#prepared, t: R, x: &#unknown) -> R {
            #decay
        }
        #[inline(always)]
        fn action(&self, prepared: &#prepared, t: R, z: &#phase, s: &R) -> R {
            #parts
            #action
        }
    };
    let stages = proven(context, quote!(ContactStages<R>), items);
    quote!(#collocated #stages)
}

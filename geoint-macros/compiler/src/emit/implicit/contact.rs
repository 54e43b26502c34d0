//! The equations of implicit steps of contact systems.

use super::prepared::Prepared;
use super::{square, write_field};
use crate::derive::{StageKernel, StepKernel};
use crate::emit::kernel::{Context, write};
use crate::emit::structure::self_type;
use crate::ir::Symbol;
use crate::schedule::Plan;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// `impl ImplicitStep` for a method.
pub(super) fn step(context: &Context<'_>, method: &str, step: &StepKernel<Plan>) -> TokenStream {
    let StepKernel { unknowns, kernel: plan } = step;
    let (name, method) = (self_type(context), format_ident!("{method}"));
    let unknown = context.unknown_type(unknowns.len());
    let degrees = context.energy.degrees();
    let before: Vec<Symbol> =
        (0..degrees).map(Symbol::Position).chain((0..degrees).map(Symbol::Momentum)).chain([Symbol::Action]).collect();
    let names = [["Constants", "constants"], ["Start", "begin"]];
    let given = ((&before[..], "x"), &quote!(), &quote!(t: R, x: &#unknown));
    let Prepared { types, functions, prepared, started } = Prepared::for_steps(context, plan, names, given);
    let image = context
        .body(&plan.last[0], (unknowns, "d"), |values| write_field(context, ["f", "matrix"], &plan.last[0], &values));
    let end = context.planned(&plan.last[1], (unknowns, "d"), |values| quote!([#(#values),*]));
    quote! {
        impl<R: Real> ImplicitStep<#method, R> for #name {
            type Proof = ();
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
        }
    }
}

/// `impl ContactStages`, and which steps there are.
pub(super) fn stages(context: &Context<'_>, stages: &StageKernel<Plan>) -> TokenStream {
    let StageKernel { moved, kernel: plan } = stages;
    let (name, n) = (self_type(context), moved.len());
    let (unknown, places) = (context.unknown_type(n), context.unknown_places(n));
    let Prepared { types, functions, prepared, .. } =
        Prepared::for_stages(context, plan, ["StageConstants", "stage_constants"]);
    let body = context.body(&plan.last[0], (moved, "x"), |values| {
        let (values, derivatives) = values.split_at(n + 1);
        let (field, by) = derivatives.split_at(n * n);
        let (field, by) = (write("f_by", &square(&places), field), write("decay_by", &places, by));
        let (f, decay) = (write("f", &places, &values[..n]), &values[n]);
        quote!(#f *decay = #decay; #field #by)
    });
    let decay = context.planned(&plan.last[1], (moved, "x"), |mut values| values.remove(0));
    let action = context.planned(&plan.last[2], (&[], ""), |mut values| values.remove(0));
    let (phase, parts) = (context.phase(), context.parts());
    quote! {
        impl<R: Real> ContactCollocated<R> for #name {
            type Proof = ();
            type Stages = ByField;
            type Midpoint = ByField;
        }
        impl<R: Real> ContactStages<R> for #name {
            type Proof = ();
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
        }
    }
}

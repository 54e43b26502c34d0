//! A Lagrangian with an action by its derivatives, for steps with velocities as unknowns.

use super::prepared::Prepared;
use super::velocities::mass_form;
use crate::derive::{HerglotzKernels, Missing, StepKernel, VelocityStages};
use crate::emit::kernel::{Context, array_type};
use crate::emit::missing::unsatisfied;
use crate::emit::structure::self_type;
use crate::emit::system::cotangent;
use crate::schedule::Extent;
use proc_macro2::TokenStream;
use quote::quote;

/// `impl Contact`, `impl ContactVelocities` and `impl ContactPolarised`, and which steps they are for.
pub(super) fn herglotz(context: &Context<'_>, kernels: &HerglotzKernels) -> TokenStream {
    let (name, phase) = (self_type(context), context.phase());
    let (stages, cotangent) = (stages(context, &kernels.stages, &quote!(ByVelocities)), cotangent(context));
    let polarised = match &kernels.polarised {
        Ok(step) => self::polarised(context, step),
        Err(missing) => not_polarised(context, *missing),
    };
    quote! {
        #cotangent
        impl<R: Real> ContactSystem<R> for #name {
            type Proof = ();
            #[inline]
            fn gradient(&self, t: R, z: &#phase, s: &R, slopes: &mut #phase, ds: &mut R) {
                contact_gradient_of(self, t, z, s, slopes, ds);
            }
        }
        #stages
        #polarised
    }
}

/// `impl ContactVelocities`, for `ContactGauss`; and how `ContactMidpoint` is solved.
pub(super) fn stages(context: &Context<'_>, stages: &VelocityStages, midpoint: &TokenStream) -> TokenStream {
    let VelocityStages { varying, mixed, mass, stage } = stages;
    let (name, array) = (self_type(context), context.array());
    let mass = mass_form(context, mass);
    let moved = if *varying { array_type(&context.with_action()) } else { array.clone() };
    let Prepared { types, functions, prepared, .. } =
        Prepared::for_stages(context, stage, ["StageConstants", "stage_constants"]);
    let force = context.outputs(stage.routine("force"), |outputs| {
        let (numbers, arrays): (Vec<_>, Vec<_>) =
            outputs.iter().partition(|values| matches!(values.output.extent, Extent::Number));
        let arrays = arrays.into_iter().map(|values| values.assigned(context));
        let decay = numbers.into_iter().flat_map(|values| &values.all);
        quote!(#(#arrays)* (force, #(#decay)*))
    });
    let stage = context.outputs(stage.routine("stage"), |outputs| {
        let (numbers, arrays): (Vec<_>, Vec<_>) =
            outputs.iter().partition(|values| matches!(values.output.extent, Extent::Number));
        arrays.into_iter().chain(numbers).map(|values| values.assigned(context)).collect::<TokenStream>()
    });
    quote! {
        #mass
        impl<R: Real> ContactCollocated<R> for #name {
            type Proof = ();
            type Stages = ByVelocities;
            type Midpoint = #midpoint;
        }
        impl<R: Real> ContactVelocities<R> for #name {
            type Proof = ();
            type Moved = #moved;
            #types
            const MIXED: [bool; 3] = [#(#mixed),*];

            #functions
            #[inline(always)]
            fn stage(
                &self,
                prepared: &#prepared,
                t: R,
                q: &#array,
                v: &#array,
                s: &R,
                stage: &mut ContactStage<#array>,
            ) {
                let ContactStage {
                    lagrangian,
                    momentum,
                    force,
                    decay,
                    derivatives: [momentum_by_q, mass, force_by_q, force_by_v],
                    by_action: [momentum_by_s, force_by_s],
                    decay_by_action,
                } = stage;
                #stage
            }
            #[inline(always)]
            fn force(&self, prepared: &#prepared, t: R, q: &#array, v: &#array, s: &R) -> (#array, R) {
                let mut force = <#array as Array>::zero();
                #force
            }
        }
    }
}

/// `impl ContactPolarised`.
fn polarised(context: &Context<'_>, StepKernel { unknowns, kernel }: &StepKernel) -> TokenStream {
    let (name, array, phase) = (self_type(context), context.array(), context.phase());
    let unknown = array_type(&unknowns.extents);
    let names = [["Parameters", "parameters"], ["Start", "begin"]];
    let start = quote!(t: R, z: &#phase, s: &R, v: &#array);
    let Prepared { types, functions, prepared, started } =
        Prepared::for_steps(context, kernel, names, &context.parts(), &start);
    let equation = context.body(kernel.routine("equation"));
    quote! {
        impl<R: Real> ContactGraded<R> for #name {
            type Proof = ();
            type Gradient = ByPolarisation;
        }
        impl<R: Real> ContactPolarised<R> for #name {
            type Proof = ();
            type Unknown = #unknown;
            #types

            #functions
            #[inline(always)]
            fn equation(
                &self,
                prepared: &#prepared,
                start: &#started,
                d: &#unknown,
                [residual, increments]: [&mut #unknown; 2],
                [matrix, increments_by_d]: [&mut Square<#unknown>; 2],
            ) #equation
        }
    }
}

/// The same where L is not quadratic: for no scalar, with a message.
fn not_polarised(context: &Context<'_>, missing: Missing) -> TokenStream {
    let (name, array, phase) = (self_type(context), context.array(), context.phase());
    let (marker, tokens) = unsatisfied(context, missing);
    let never = quote!(::core::convert::Infallible);
    quote! {
        #tokens
        impl<R: Real + #marker> ContactGraded<R> for #name {
            type Proof = <R as #marker>::Proof;
            type Gradient = ByPolarisation;
        }
        impl<R: Real + #marker> ContactPolarised<R> for #name {
            type Proof = <R as #marker>::Proof;
            type Unknown = #array;
            type Parameters = #never;
            type Start = #never;

            fn parameters(&self, _: R) -> #never {
                ::core::unreachable!()
            }
            fn begin(&self, never: &#never, _: R, _: &#phase, _: &R, _: &#array) -> #never {
                match *never {}
            }
            fn equation(
                &self,
                never: &#never,
                _: &#never,
                _: &#array,
                _: [&mut #array; 2],
                _: [&mut Square<#array>; 2],
            ) {
                match *never {}
            }
        }
    }
}

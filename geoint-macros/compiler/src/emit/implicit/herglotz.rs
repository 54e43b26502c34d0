//! A Lagrangian with an action by its derivatives, for steps with velocities as unknowns.

use super::prepared::Prepared;
use super::velocities::{DERIVATIVES, DERIVED, mass_form};
use super::write_derivatives;
use crate::derive::{HerglotzKernels, Missing, StepKernel, VelocityStages};
use crate::emit::kernel::{Context, write};
use crate::emit::missing::unsatisfied;
use crate::emit::structure::self_type;
use crate::emit::system::cotangent;
use crate::ir::Graph;
use crate::schedule::Plan;
use proc_macro2::TokenStream;
use quote::quote;

/// `impl Contact`, `impl ContactVelocities` and `impl ContactPolarised`, and which steps they are for.
pub(super) fn herglotz(context: &Context<'_>, graph: &Graph, kernels: &HerglotzKernels<Plan>) -> TokenStream {
    let (name, phase) = (self_type(context), context.phase());
    let (stages, cotangent) = (stages(context, &kernels.stages, &quote!(ByVelocities)), cotangent(context));
    let polarised = match &kernels.polarised {
        Ok(step) => self::polarised(context, step),
        Err(missing) => not_polarised(context, graph, *missing),
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
pub(super) fn stages(context: &Context<'_>, stages: &VelocityStages<Plan>, midpoint: &TokenStream) -> TokenStream {
    let VelocityStages { varying, mixed, mass, stage } = stages;
    let (name, array, places) = (self_type(context), context.array(), context.coordinates());
    let n = places.len();
    let mass = mass_form(context, mass);
    let moved = if *varying { context.unknown_type(n + 1) } else { array.clone() };
    let Prepared { types, functions, prepared, .. } =
        Prepared::for_stages(context, stage, ["StageConstants", "stage_constants"]);
    let force = context.planned(&stage.last[1], (&[], ""), |values| {
        let (force, decay) = (write("force", &places, &values[..n]), &values[n]);
        quote! {
            #force
            (force, #decay)
        }
    });
    let stage = context.planned(&stage.last[0], (&[], ""), |values| {
        let (derivatives, action) = values.split_at(2 * n + 4 * n * n);
        let derivatives = write_derivatives(&places, (&DERIVED, &DERIVATIVES), derivatives);
        let (value, decay, by_action) = (&action[0], &action[1], &action[2..]);
        let (momentum_by_s, force_by_s) =
            (write("momentum_by_s", &places, &by_action[..n]), write("force_by_s", &places, &by_action[n..2 * n]));
        let decay_by_s = &by_action[2 * n];
        quote! {
            #derivatives #momentum_by_s #force_by_s
            *lagrangian = #value;
            *decay = #decay;
            *decay_by_action = #decay_by_s;
        }
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
fn polarised(context: &Context<'_>, StepKernel { unknowns, kernel: plan }: &StepKernel<Plan>) -> TokenStream {
    let (name, array, phase, parts) = (self_type(context), context.array(), context.phase(), context.parts());
    let n = unknowns.len();
    let (unknown, places) = (context.unknown_type(n), context.unknown_places(n));
    let names = [["Parameters", "parameters"], ["Start", "begin"]];
    let start = ((&[][..], ""), &parts, &quote!(t: R, z: &#phase, s: &R, v: &#array));
    let Prepared { types, functions, prepared, started } = Prepared::for_steps(context, plan, names, start);
    let equation = context.body(&plan.last[0], (unknowns, "d"), |values| {
        write_derivatives(&places, (&["residual", "increments"], &["matrix", "increments_by_d"]), &values)
    });
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
fn not_polarised(context: &Context<'_>, graph: &Graph, missing: Missing) -> TokenStream {
    let (name, array, phase) = (self_type(context), context.array(), context.phase());
    let (marker, tokens) = unsatisfied(context, graph, missing);
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

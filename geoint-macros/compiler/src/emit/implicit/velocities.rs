//! A Lagrangian by its derivatives, for steps with velocities as unknowns.

use super::prepared::Prepared;
use super::{write_derivatives, write_field};
use crate::derive::{MassKernels, Missing, VelocityKernels};
use crate::emit::kernel::{Context, write};
use crate::emit::missing::unsatisfied;
use crate::emit::structure::self_type;
use crate::emit::system::{cotangent, keeps_energy};
use crate::ir::{Graph, Symbol};
use crate::schedule::Plan;
use proc_macro2::TokenStream;
use quote::quote;

/// What a stage computes beside one another: ∂L/∂v, ∂L/∂q, and derivatives of both by q and v.
pub(super) const DERIVED: [&str; 2] = ["momentum", "force"];
pub(super) const DERIVATIVES: [&str; 4] = ["momentum_by_q", "mass", "force_by_q", "force_by_v"];

/// `impl VelocityForm` and `impl PolarisedForm`, and which steps they are for.
pub(super) fn velocities(context: &Context<'_>, graph: &Graph, kernels: &VelocityKernels<Plan>) -> TokenStream {
    let VelocityKernels { increments, mass, stage, polarised, keeps, .. } = kernels;
    let (name, array, places) = (self_type(context), context.array(), context.coordinates());
    let mass = mass_form(context, mass);
    let Prepared { types, functions, prepared, .. } = Prepared::for_stages(context, stage, ["Constants", "constants"]);
    let force = context.planned(&stage.last[1], (&[], ""), |values| write("force", &places, &values));
    let stage =
        context.body(&stage.last[0], (&[], ""), |values| write_derivatives(&places, (&DERIVED, &DERIVATIVES), &values));
    let polarised = match polarised {
        Ok(plan) => self::polarised(context, increments, (plan, *keeps)),
        Err(missing) => not_polarised(context, graph, *missing),
    };
    let cotangent = cotangent(context);
    let kept = keeps.then(|| keeps_energy(context, &quote!(VelocityEnergy), None));
    quote! {
        #cotangent
        #kept
        #mass
        impl<R: Real> Collocated<R> for #name {
            type Proof = ();
            type Stages = ByVelocities;
        }
        impl<R: Real> VelocityForm<R> for #name {
            type Proof = ();
            #types

            #functions
            #[inline(always)]
            fn stage(
                &self,
                prepared: &#prepared,
                t: R,
                q: &#array,
                v: &#array,
                [momentum, force]: [&mut #array; 2],
                [momentum_by_q, mass, force_by_q, force_by_v]: &mut [Square<#array>; 4],
            ) #stage
            #[inline(always)]
            fn force(&self, prepared: &#prepared, t: R, q: &#array, v: &#array) -> #array {
                let mut force = <#array as Array>::zero();
                #force
                force
            }
        }
        #polarised
    }
}

/// `impl MassForm`.
pub(super) fn mass_form(context: &Context<'_>, kernels: &MassKernels<Plan>) -> TokenStream {
    let MassKernels { mass, definite, quadratic } = kernels;
    let (name, array, action) = (self_type(context), context.array(), context.action());
    let mass = &mass.last[0];
    let mass = context.body(mass, (&[], ""), |values| write_field(context, ["momentum", "mass"], mass, &values));
    let definite = definite.as_ref().map(|(weights, values)| {
        let holds = context.values(values, |values| {
            let (weights, others) = values.split_at(*weights);
            quote!(true #(&& !#weights.any_below(0.0))* #(&& #others.all_positive())*)
        });
        quote! {
            fn is_definite(&self) -> bool {
                #holds
            }
        }
    });
    quote! {
        impl<R: Real> MassForm<R> for #name {
            type Proof = ();
            const QUADRATIC: bool = #quadratic;

            #definite
            #[inline(always)]
            fn mass(
                &self,
                t: R,
                q: &#array,
                v: &#array,
                s: &#action,
                (momentum, mass): (&mut #array, &mut Square<#array>),
            ) #mass
        }
    }
}

/// `impl PolarisedForm`.
fn polarised(context: &Context<'_>, increments: &[Symbol], (plan, keeps): (&Plan, bool)) -> TokenStream {
    let (name, array, places) = (self_type(context), context.array(), context.coordinates());
    let (phase, parts) = (context.phase(), context.parts());
    let names = [["Parameters", "parameters"], ["Start", "begin"]];
    let start = ((&[][..], ""), &parts, &quote!(t: R, z: &#phase, v: &#array));
    let Prepared { types, functions, prepared, started } = Prepared::for_steps(context, plan, names, start);
    let equation = context.body(&plan.last[0], (increments, "d"), |values| {
        write_derivatives(&places, (&["residual", "impulse"], &["matrix", "impulse_by_d"]), &values)
    });
    let kept = if keeps { quote!(VelocityEnergy) } else { quote!(()) };
    quote! {
        impl<R: Real> Graded<R> for #name {
            type Proof = ();
            type Gradient = ByPolarisation;
            type Kept = #kept;
        }
        impl<R: Real> PolarisedForm<R> for #name {
            type Proof = ();
            #types

            #functions
            #[inline(always)]
            fn equation(
                &self,
                prepared: &#prepared,
                start: &#started,
                d: &#array,
                [residual, impulse]: [&mut #array; 2],
                [matrix, impulse_by_d]: [&mut Square<#array>; 2],
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
        impl<R: Real + #marker> Graded<R> for #name {
            type Proof = <R as #marker>::Proof;
            type Gradient = ByPolarisation;
            type Kept = ();
        }
        impl<R: Real + #marker> PolarisedForm<R> for #name {
            type Proof = <R as #marker>::Proof;
            type Parameters = #never;
            type Start = #never;

            fn parameters(&self, _: R) -> #never {
                ::core::unreachable!()
            }
            fn begin(&self, never: &#never, _: R, _: &#phase, _: &#array) -> #never {
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

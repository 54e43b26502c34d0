//! A Lagrangian by its derivatives, for steps with velocities as unknowns.

use super::prepared::Prepared;
use crate::derive::{MassKernels, Missing, VelocityKernels};
use crate::emit::kernel::Context;
use crate::emit::missing::unsatisfied;
use crate::emit::structure::self_type;
use crate::emit::system::{cotangent, keeps_energy};
use crate::schedule::Kernel;
use proc_macro2::TokenStream;
use quote::quote;

/// `impl VelocityForm` and `impl PolarisedForm`, and which steps they are for.
pub(super) fn velocities(context: &Context<'_>, kernels: &VelocityKernels) -> TokenStream {
    let VelocityKernels { mass, stage, polarised, keeps, .. } = kernels;
    let (name, array) = (self_type(context), context.array());
    let mass = mass_form(context, mass);
    let Prepared { types, functions, prepared, .. } = Prepared::for_stages(context, stage, ["Constants", "constants"]);
    let (force, stage) = (context.assigned(stage.routine("force")), context.body(stage.routine("stage")));
    let polarised = match polarised {
        Ok(step) => self::polarised(context, &step.kernel, *keeps),
        Err(missing) => not_polarised(context, *missing),
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
pub(super) fn mass_form(context: &Context<'_>, kernels: &MassKernels) -> TokenStream {
    let MassKernels { mass, definite, quadratic } = kernels;
    let (name, array, action) = (self_type(context), context.array(), context.action());
    let mass = context.body(mass);
    let definite = definite.as_ref().map(|definite| {
        let holds = context.outputs(definite, |outputs| {
            let tests = outputs.iter().flat_map(|values| {
                let positive = values.output.name == "positive";
                values.all.iter().map(move |value| match positive {
                    true => quote!(&& #value.all_positive()),
                    false => quote!(&& !#value.any_below(0.0)),
                })
            });
            quote!(true #(#tests)*)
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
fn polarised(context: &Context<'_>, kernel: &Kernel, keeps: bool) -> TokenStream {
    let (name, array, phase) = (self_type(context), context.array(), context.phase());
    let names = [["Parameters", "parameters"], ["Start", "begin"]];
    let start = quote!(t: R, z: &#phase, v: &#array);
    let Prepared { types, functions, prepared, started } =
        Prepared::for_steps(context, kernel, names, &context.parts(), &start);
    let equation = context.body(kernel.routine("equation"));
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
fn not_polarised(context: &Context<'_>, missing: Missing) -> TokenStream {
    let (name, array, phase) = (self_type(context), context.array(), context.phase());
    let (marker, tokens) = unsatisfied(context, missing);
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

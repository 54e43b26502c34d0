//! A Lagrangian by its derivatives, for steps with velocities as unknowns.

use super::discrete::graded;
use super::prepared::{Prepared, numbers};
use crate::derive::{ActionStages, MassKernels, StepKernel, VelocityKernels, VelocityStages};
use crate::emit::implementation::{Absent, Implementation, Inline, Method, Trait, Ty, absent, methods, ty};
use crate::emit::kernel::{Context, Values, array_type};
use crate::emit::structure::self_type;
use crate::emit::system::{cotangent, keeps_energy};
use crate::schedule::Extent;
use proc_macro2::TokenStream;
use quote::quote;

const GRADED: Trait = graded!("ByPolarisation");

const POLARISED_FORM: Trait = Trait {
    name: "PolarisedForm",
    has_proof: true,
    associated: &[("Parameters", Absent::Never), ("Start", Absent::Never)],
    methods: methods! {
        Hint fn parameters("h": {R}) -> Parameters;
        Always fn begin("prepared": {&Parameters}, "t": {R}, "z": {&Phase}, "v": {&Array}) -> Start;
        Always fn equation(
            "prepared": {&Parameters}, "start": {&Start}, "d": {&Array},
            "[residual, impulse]": {[&mut Array] x 2}, "[matrix, impulse_by_d]": {[&mut Square<Array>] x 2}
        ) wide;
    },
    provided: &[],
};

const CONTACT_GRADED: Trait = Trait {
    name: "ContactGraded",
    has_proof: true,
    associated: &[("Gradient", Absent::Named("ByPolarisation"))],
    methods: &[],
    provided: &[],
};

const CONTACT_POLARISED: Trait = Trait {
    name: "ContactPolarised",
    has_proof: true,
    associated: &[("Unknown", Absent::Is(Ty::Array)), ("Parameters", Absent::Never), ("Start", Absent::Never)],
    methods: methods! {
        Hint fn parameters("h": {R}) -> Parameters;
        Always fn begin("prepared": {&Parameters}, "t": {R}, "z": {&Phase}, "s": {&R}, "v": {&Array}) -> Start;
        Always fn equation(
            "prepared": {&Parameters}, "start": {&Start}, "d": {&Unknown},
            "[residual, increments]": {[&mut Unknown] x 2}, "[matrix, increments_by_d]": {[&mut Square<Unknown>] x 2}
        ) wide;
    },
    provided: &[],
};

/// Stages of collocation, and steps along the polarised discrete gradient.
pub(super) fn velocities(context: &Context<'_>, kernels: &VelocityKernels) -> TokenStream {
    let VelocityKernels { stages, polarised, keeps, .. } = kernels;
    let (name, cotangent) = (self_type(context), cotangent(context));
    if stages.action.is_some() {
        let (phase, stages) = (context.phase(), self::stages(context, stages, &quote!(ByVelocities)));
        let polarised = match polarised {
            Ok(step) => contact_polarised(context, step),
            Err(missing) => absent(context, *missing, &[&CONTACT_GRADED, &CONTACT_POLARISED]),
        };
        return quote! {
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
        };
    }
    let kept = keeps.then(|| keeps_energy(context, &quote!(VelocityEnergy), None));
    let stages = self::stages(context, stages, &quote!());
    let polarised = match polarised {
        Ok(step) => self::polarised(context, step, *keeps),
        Err(missing) => absent(context, *missing, &[&GRADED, &POLARISED_FORM]),
    };
    quote!(#cotangent #kept #stages #polarised)
}

/// `impl MassForm`, and `impl VelocityForm` or `impl ContactVelocities` for collocation. `midpoint` states how `ContactMidpoint` is solved.
pub(super) fn stages(context: &Context<'_>, stages: &VelocityStages, midpoint: &TokenStream) -> TokenStream {
    let VelocityStages { action, mass, stage } = stages;
    let (name, array) = (self_type(context), context.array());
    let mass = mass_form(context, mass);
    let Some(ActionStages { varying, mixed }) = action else {
        let Prepared { types, functions, prepared, .. } =
            Prepared::for_stages(context, stage, ["Constants", "constants"]);
        let (force, stage) = (context.assigned(stage.routine("force")), context.body(stage.routine("stage")));
        return quote! {
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
        };
    };
    let moved = if *varying { array_type(&context.with_action()) } else { array.clone() };
    let Prepared { types, functions, prepared, .. } =
        Prepared::for_stages(context, stage, ["StageConstants", "stage_constants"]);
    let is_number = |values: &Values<'_>| matches!(values.output.extent, Extent::Number);
    let force = context.outputs(stage.routine("force"), |outputs| {
        let (numbers, arrays): (Vec<_>, Vec<_>) = outputs.into_iter().partition(is_number);
        let arrays = arrays.iter().map(|values| values.assigned(context));
        let decay = numbers.iter().flat_map(|values| &values.all);
        quote!(#(#arrays)* (force, #(#decay)*))
    });
    let stage = context.outputs(stage.routine("stage"), |outputs| {
        let (numbers, arrays): (Vec<_>, Vec<_>) = outputs.into_iter().partition(is_number);
        arrays.iter().chain(&numbers).map(|values| values.assigned(context)).collect::<TokenStream>()
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

/// `impl Graded` and `impl PolarisedForm`.
fn polarised(context: &Context<'_>, StepKernel { kernel, .. }: &StepKernel, keeps: bool) -> TokenStream {
    let kept = if keeps { quote!(VelocityEnergy) } else { quote!(()) };
    let graded = Implementation::new(context, &GRADED, &[])
        .items(quote!(type Proof = (); type Gradient = ByPolarisation; type Kept = #kept;))
        .finish();
    let ([parameters, start], parts) = ([0, 1].map(|level| numbers(kernel, level)), context.parts());
    let begin = context.stored(kernel, 1);
    let types = [("Parameters", parameters.clone()), ("Start", start.clone())];
    let form = Implementation::new(context, &POLARISED_FORM, &types)
        .items(quote!(type Proof = (); type Parameters = #parameters; type Start = #start;))
        .method("parameters", context.stored(kernel, 0))
        .method("begin", quote!(#parts #begin))
        .method("equation", context.assigned(kernel.routine("equation")))
        .finish();
    quote!(#graded #form)
}

/// `impl ContactGraded` and `impl ContactPolarised`.
fn contact_polarised(context: &Context<'_>, StepKernel { unknowns, kernel }: &StepKernel) -> TokenStream {
    let graded = Implementation::new(context, &CONTACT_GRADED, &[])
        .items(quote!(
            type Proof = ();
            type Gradient = ByPolarisation;
        ))
        .finish();
    let ([parameters, start], parts) = ([0, 1].map(|level| numbers(kernel, level)), context.parts());
    let (unknown, begin) = (array_type(&unknowns.extents), context.stored(kernel, 1));
    let types = [("Unknown", quote!(#unknown)), ("Parameters", parameters.clone()), ("Start", start.clone())];
    let form = Implementation::new(context, &CONTACT_POLARISED, &types)
        .items(quote! {
            type Proof = ();
            type Unknown = #unknown;
            type Parameters = #parameters;
            type Start = #start;
        })
        .method("parameters", context.stored(kernel, 0))
        .method("begin", quote!(#parts #begin))
        .method("equation", context.assigned(kernel.routine("equation")))
        .finish();
    quote!(#graded #form)
}

//! Derivatives of a Lagrangian, for steps with velocities as unknowns.

use super::prepared::{Prepared, numbers};
use super::{discrete, methods};
use crate::derive::{ActionStages, MassKernels, StepKernel, VelocityKernels, VelocityStages};
use crate::emit::context::{Context, Values, array_type};
use crate::emit::implementation::{Implementation, absent, flag, proven};
use crate::emit::signature::{Absent, Trait, Ty, methods};
use crate::emit::system::{cotangent, keeps_energy};
use crate::schedule::{Extent, Kernel};
use proc_macro2::TokenStream;
use quote::quote;

/// The equation of a step along the polarised discrete gradient.
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

/// The equation of a step of a contact system along the polarised discrete gradient.
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

/// Returns the implementations for stages of collocation, and for steps along the polarised discrete gradient.
pub(super) fn velocities(context: &Context<'_>, kernels: &VelocityKernels) -> TokenStream {
    let VelocityKernels { stages, polarised, keeps, .. } = kernels;
    let cotangent = cotangent(context);
    if stages.action.is_some() {
        let (phase, stages) = (context.phase_type(), self::stages(context, stages));
        let polarised = match polarised {
            Ok(step) => contact_polarised(context, step),
            Err(missing) => {
                let absent = absent(context, *missing, &[&CONTACT_POLARISED]);
                let unsolved = methods::unsolved(context, *missing, "ContactDiscreteGradient", "ContactPolarisedStep");
                quote!(#absent #unsolved)
            }
        };
        let midpoint = methods::solved_in_one_stage(context, "ContactMidpoint", "ContactVelocityStages");
        let gradient = quote! {
            #[inline]
            fn gradient(&self, t: R, z: &#phase, s: &R, slopes: &mut #phase, ds: &mut R) {
                contact_gradient_of(self, t, z, s, slopes, ds);
            }
        };
        let contact = proven(context, quote!(ContactSystem<R>), gradient);
        return quote!(#cotangent #contact #stages #midpoint #polarised);
    }
    let keeps_energy = keeps.then(|| keeps_energy(context, &quote!(VelocityEnergy), None));
    let kept = if *keeps { quote!(VelocityEnergy) } else { quote!(()) };
    let stages = self::stages(context, stages);
    let polarised = match polarised {
        Ok(step) => self::polarised(context, step, kept),
        Err(missing) => {
            let absent = absent(context, *missing, &[&discrete::KEEPING, &POLARISED_FORM]);
            let unsolved = methods::unsolved(context, *missing, "DiscreteGradient", "PolarisedStep");
            quote!(#absent #unsolved)
        }
    };
    quote!(#cotangent #keeps_energy #stages #polarised)
}

/// Returns `impl MassForm`, and `impl VelocityForm` or `impl ContactVelocities` for collocation.
pub(super) fn stages(context: &Context<'_>, stages: &VelocityStages) -> TokenStream {
    let mass = mass_form(context, &stages.mass);
    let stages = match &stages.action {
        None => velocity_form(context, &stages.stage),
        Some(action) => contact_velocities(context, action, &stages.stage),
    };
    quote!(#mass #stages)
}

/// Returns `impl VelocityForm`, and the stages of `Gauss`.
fn velocity_form(context: &Context<'_>, stage: &Kernel) -> TokenStream {
    let array = context.positions_type();
    let Prepared { types, functions, prepared, .. } = Prepared::for_stages(context, stage, ["Constants", "constants"]);
    let (force, stage) = (context.assigned(stage.routine("force")), context.body(stage.routine("stage")));
    let items = quote! {
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
    };
    let collocated = methods::collocated(context, "GaussCollocation", "VelocityStages");
    let form = proven(context, quote!(VelocityForm<R>), items);
    quote!(#collocated #form)
}

/// Returns `impl ContactVelocities`, and the stages of `ContactGauss`.
fn contact_velocities(
    context: &Context<'_>,
    ActionStages { varying, mixed }: &ActionStages,
    stage: &Kernel,
) -> TokenStream {
    let array = context.positions_type();
    let moved = if *varying { array_type(&context.extents_with_action()) } else { array.clone() };
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
    let collocated = methods::collocated(context, "ContactGaussCollocation", "ContactVelocityStages");
    let items = quote! {
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
    };
    let velocities = proven(context, quote!(ContactVelocities<R>), items);
    quote!(#collocated #velocities)
}

/// Returns `impl MassForm`.
fn mass_form(context: &Context<'_>, kernels: &MassKernels) -> TokenStream {
    let MassKernels { mass, definite, quadratic } = kernels;
    let (array, action, mass) = (context.positions_type(), context.action_type(), context.body(mass));
    let quadratic = flag("QUADRATIC", *quadratic);
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
    let items = quote! {
        #quadratic

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
    };
    proven(context, quote!(MassForm<R>), items)
}

/// Returns `impl Keeping` and `impl PolarisedForm`, and the step of `DiscreteGradient`.
fn polarised(context: &Context<'_>, StepKernel { kernel, .. }: &StepKernel, kept: TokenStream) -> TokenStream {
    let keeping = Implementation::new(context, &discrete::KEEPING, &[]).items(quote!(type Kept = #kept;)).finish();
    let solved = methods::solved(context, "DiscreteGradient", "PolarisedStep");
    let ([parameters, start], parts) = ([0, 1].map(|level| numbers(kernel, level)), context.parts());
    let begin = context.stored(kernel, 1);
    let types = [("Parameters", parameters), ("Start", start)];
    let form = Implementation::new(context, &POLARISED_FORM, &types)
        .types()
        .method("parameters", context.stored(kernel, 0))
        .method("begin", quote!(#parts #begin))
        .method("equation", context.assigned(kernel.routine("equation")))
        .finish();
    quote!(#keeping #form #solved)
}

/// Returns `impl ContactPolarised`, and the step of `ContactDiscreteGradient`.
fn contact_polarised(context: &Context<'_>, StepKernel { unknowns, kernel }: &StepKernel) -> TokenStream {
    let solved = methods::solved(context, "ContactDiscreteGradient", "ContactPolarisedStep");
    let ([parameters, start], parts) = ([0, 1].map(|level| numbers(kernel, level)), context.parts());
    let (unknown, begin) = (array_type(&unknowns.extents), context.stored(kernel, 1));
    let types = [("Unknown", quote!(#unknown)), ("Parameters", parameters), ("Start", start)];
    let form = Implementation::new(context, &CONTACT_POLARISED, &types)
        .types()
        .method("parameters", context.stored(kernel, 0))
        .method("begin", quote!(#parts #begin))
        .method("equation", context.assigned(kernel.routine("equation")))
        .finish();
    quote!(#form #solved)
}

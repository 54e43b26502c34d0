//! Derivatives of a Lagrangian, for steps with velocities as unknowns.

use super::methods;
use super::prepared::{Prepared, numbers};
use crate::derive::{MassKernels, MixedDerivatives, StepKernel, VelocityKernels, VelocityStages};
use crate::emit::context::{Context, Values, array_type};
use crate::emit::implementation::{Implementation, absent, flag, proven};
use crate::emit::signature::{Absent, Trait, Ty, methods};
use crate::emit::system::{cotangent, keeps_energy};
use crate::schedule::Extent;
use proc_macro2::TokenStream;
use quote::quote;

/// The equation of a step along the polarised discrete gradient.
const POLARISED_FORM: Trait = Trait {
    name: "PolarisedForm",
    has_proof: true,
    associated: &[
        ("Increments", Absent::Is(Ty::Array)),
        ("Kept", Absent::Unit),
        ("Parameters", Absent::Never),
        ("Start", Absent::Never),
    ],
    methods: methods! {
        Hint fn parameters("h": {R}) -> Parameters;
        Always fn begin("prepared": {&Parameters}, "t": {R}, "z": {&Phase}, "s": {&Action}, "v": {&Array}) -> Start;
        Always fn equation(
            "prepared": {&Parameters}, "start": {&Start}, "d": {&Increments},
            "[residual, increments]": {[&mut Increments] x 2}, "[matrix, increments_by_d]": {[&mut Square<Increments>] x 2}
        ) wide;
    },
    provided: &[],
};

/// The methods of the runtime that are solved for velocities.
struct Methods {
    gauss: &'static str,
    discrete_gradient: &'static str,
}

impl Methods {
    fn of(context: &Context<'_>) -> Self {
        match context.form.has_action() {
            true => Methods { gauss: "ContactGaussCollocation", discrete_gradient: "ContactDiscreteGradient" },
            false => Methods { gauss: "GaussCollocation", discrete_gradient: "DiscreteGradient" },
        }
    }
}

/// Returns the implementations for stages of collocation, and for steps along the polarised discrete gradient.
pub(super) fn velocities(context: &Context<'_>, kernels: &VelocityKernels) -> TokenStream {
    let VelocityKernels { stages, polarised, keeps, .. } = kernels;
    let (cotangent, phase) = (cotangent(context), context.phase_type());
    let contact = context.form.has_action().then(|| {
        let gradient = quote! {
            #[inline]
            fn gradient(&self, t: R, z: &#phase, s: &R, slopes: &mut #phase, ds: &mut R) {
                contact_gradient_of(self, t, z, s, slopes, ds);
            }
        };
        let midpoint = methods::solved_in_one_stage(context, "ContactMidpoint", "VelocityStages");
        let contact = proven(context, quote!(ContactSystem<R>), gradient);
        quote!(#contact #midpoint)
    });
    let keeps_energy = keeps.then(|| keeps_energy(context, &quote!(VelocityEnergy), None));
    let kept = if *keeps { quote!(VelocityEnergy) } else { quote!(()) };
    let stages = self::stages(context, stages);
    let discrete_gradient = Methods::of(context).discrete_gradient;
    let polarised = match polarised {
        Ok(step) => {
            let solved = methods::solved(context, discrete_gradient, "PolarisedStep");
            let form = self::polarised(context, step, kept);
            quote!(#form #solved)
        }
        Err(missing) => {
            let absent = absent(context, *missing, &[&POLARISED_FORM]);
            let unsolved = methods::unsolved(context, *missing, discrete_gradient, "PolarisedStep");
            quote!(#absent #unsolved)
        }
    };
    quote!(#cotangent #contact #keeps_energy #stages #polarised)
}

/// Returns `impl MassForm` and `impl VelocityForm`, and the stages of `Gauss` or `ContactGauss`.
pub(super) fn stages(context: &Context<'_>, stages: &VelocityStages) -> TokenStream {
    let VelocityStages { mass, stage, mixed, .. } = stages;
    let MixedDerivatives { momentum_by_q, momentum_by_s, force_by_v, force_by_s } = mixed;
    let (array, action, mass) = (context.positions_type(), context.action_type(), mass_form(context, mass));
    let unknown = if stages.has_action_unknown() { array_type(&context.extents_with_action()) } else { array.clone() };
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
    let of_action = context
        .form
        .has_action()
        .then(|| quote!(lagrangian, decay, by_action: [momentum_by_s, force_by_s], decay_by_action,));
    let collocated = methods::collocated(context, Methods::of(context).gauss, "VelocityStages");
    let items = quote! {
        type Unknown = #unknown;
        #types
        const MIXED: MixedDerivatives = MixedDerivatives {
            momentum_by_q: #momentum_by_q,
            momentum_by_s: #momentum_by_s,
            force_by_v: #force_by_v,
            force_by_s: #force_by_s,
        };

        #functions
        #[inline(always)]
        fn stage(
            &self,
            prepared: &#prepared,
            t: R,
            q: &#array,
            v: &#array,
            s: &#action,
            stage: &mut VelocityStage<#array>,
        ) {
            let VelocityStage {
                momentum, force, derivatives: [momentum_by_q, mass, force_by_q, force_by_v], #of_action ..
            } = stage;
            #stage
        }
        #[inline(always)]
        fn force(&self, prepared: &#prepared, t: R, q: &#array, v: &#array, s: &#action) -> (#array, R) {
            let mut force = <#array as Array>::zero();
            #force
        }
    };
    let velocities = proven(context, quote!(VelocityForm<R>), items);
    quote!(#mass #collocated #velocities)
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

/// Returns `impl PolarisedForm`.
fn polarised(context: &Context<'_>, StepKernel { unknowns, kernel }: &StepKernel, kept: TokenStream) -> TokenStream {
    let ([parameters, start], parts) = ([0, 1].map(|level| numbers(kernel, level)), context.parts());
    let (increments, begin) = (array_type(&unknowns.extents), context.stored(kernel, 1));
    let types = [("Increments", quote!(#increments)), ("Kept", kept), ("Parameters", parameters), ("Start", start)];
    Implementation::new(context, &POLARISED_FORM, &types)
        .types()
        .method("parameters", context.stored(kernel, 0))
        .method("begin", quote!(#parts #begin))
        .method("equation", context.assigned(kernel.routine("equation")))
        .finish()
}

//! The equations of `DiscreteGradient` and of `FourthOrder(DiscreteGradient)`. Divided differences replace the derivatives of conserved quantities, which the
//! steps therefore keep. The second method projects a mean velocity of order 4 onto the increments that keep them.
//!
//! The unknown is the increment `d` over a step that starts at `y`. In the tables of methods below, `Hint` and `Always` are attributes of inlining, and
//! `wide` is the layout of a signature.

use super::methods;
use super::prepared::{Prepared, numbers};
use crate::analyze::MeanValue;
use crate::derive::{Fact, FieldKernels, Missing, System};
use crate::emit::context::{Context, Values, array_type, write};
use crate::emit::implementation::{Implementation, absent, proven};
use crate::emit::signature::{Absent, Trait, methods};
use crate::emit::structure::self_type;
use crate::schedule::{Kernel, Routine};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The quantities that steps along the discrete gradient keep, as a type of the runtime. A constant states if they are nowhere steep.
pub(super) const KEEPING: Trait =
    Trait { name: "Keeping", has_proof: false, associated: &[("Kept", Absent::Unit)], methods: &[], provided: &[] };

/// The equation of a step along the discrete gradient. `slope` computes the field between `y` and `y + d`, and its derivative by `d`. If momenta alone are
/// unknown, for H = T(p) + V(q) with a quadratic T, `drift` computes the increments of positions from the sum of the momenta at both ends.
const DISCRETE_FIELD: Trait = Trait {
    name: "DiscreteField",
    has_proof: true,
    associated: &[("Parameters", Absent::Never), ("Start", Absent::Never), ("Inverse", Absent::Unit)],
    methods: methods! {
        Hint fn parameters("h": {R}) -> Parameters;
        Always fn begin("prepared": {&Parameters}, "Span { start, middle: t, end }": {Span}, "y": {&Unknown}) -> Start;
        Always fn slope("prepared": {&Parameters}, "start": {&Start}, "d": {&Unknown}, "f": {&mut Unknown}, "jacobian": {&mut Square<Unknown>}) wide;
        Always fn drift("prepared": {&Parameters}, "sum": {&Unknown}) -> Unknown;
    },
    provided: &[],
};

/// The equation of a step of order 4.
const FOURTH_ORDER_FIELD: Trait = Trait {
    name: "FourthOrderField",
    has_proof: true,
    associated: &[("FourthParameters", Absent::Never), ("FourthStart", Absent::Never)],
    methods: methods! {
        Hint fn fourth_parameters("h": {R}) -> FourthParameters;
        Always fn fourth_begin("prepared": {&FourthParameters}, "span": {Span}, "z": {&Unknown}) -> FourthStart;
        Always fn fourth_slope("prepared": {&FourthParameters}, "start": {&FourthStart}, "d": {&Unknown}, "image": {&mut Unknown}, "matrix": {&mut Square<Unknown>}) wide;
    },
    provided: &[],
};

/// Returns `impl Keeping` and `impl DiscreteField`, and the step of `DiscreteGradient`.
pub(super) fn discrete_field(
    context: &Context<'_>,
    field: &FieldKernels,
    kernel: &Kernel,
    kept: &TokenStream,
    nowhere_steep: Option<TokenStream>,
) -> TokenStream {
    let unknown = array_type(&field.increments.extents);
    let [parameters, start] = [0, 1].map(|level| numbers(kernel, level));
    let drift = context.assigned(kernel.routine("drift"));
    // The runtime builds the equation from `slope`. Where the macro has a shorter form, it overrides this; the constants of collocation are not needed then.
    let equation = kernel.find("equation").map(|equation| {
        let equation = context.body(equation);
        quote! {
            #[inline(always)]
            fn equation(
                &self,
                _: (&Self::Constants, R),
                prepared: &#parameters,
                start: &#start,
                d: &#unknown,
                image: &mut #unknown,
                matrix: &mut Square<#unknown>,
            ) #equation
        }
    });
    let inverse = if field.linear { quote!(Inverted<#unknown>) } else { quote!(()) };
    let mean = match field.mean_value {
        MeanValue::Gauss(points) => {
            let points = Literal::u32_unsuffixed(points);
            quote!(Gauss(#points))
        }
        MeanValue::Parts(parts) => {
            let parts = Literal::u32_unsuffixed(parts);
            quote!(Parts(#parts))
        }
        MeanValue::NotClosed(_) => quote!(NotClosed),
    };
    let keeping = Implementation::new(context, &KEEPING, &[]).items(quote!(type Kept = #kept; #nowhere_steep)).finish();
    let unknown_type = quote!(#unknown);
    let types = [("Parameters", parameters), ("Start", start), ("Inverse", inverse), ("Unknown", unknown_type)];
    let implementation = Implementation::new(context, &DISCRETE_FIELD, &types)
        .types()
        .items(quote!(const MEAN: Mean = Mean::#mean;))
        .method("parameters", context.stored(kernel, 0))
        .method("begin", context.stored(kernel, 1))
        .method("slope", context.assigned(kernel.routine("slope")))
        .items(equation)
        .method("drift", quote!(let mut drift = <#unknown as Array>::zero(); #drift drift))
        .finish();
    // Beside an entropy, the laws of a step hold forward in time only.
    let solved = match field.forward {
        Some(_) => methods::solved_forward(context, "DiscreteGradient", "TreeStep"),
        None => methods::solved(context, "DiscreteGradient", "TreeStep"),
    };
    quote!(#keeping #implementation #solved)
}

/// Returns the implementations for a field without conserved quantities. No scalar satisfies them, so their use is an error that states the reason.
pub(super) fn nothing_kept(context: &Context<'_>, missing: Missing) -> TokenStream {
    let absent = absent(context, missing, &[&KEEPING, &DISCRETE_FIELD]);
    let unsolved = methods::unsolved(context, missing, "DiscreteGradient", "TreeStep");
    quote!(#absent #unsolved)
}

/// Returns the implementation of `FourthOrderField` for a system with an entropy, which no scalar satisfies: order 4 needs steps back in time, and these
/// lower the entropy.
pub(super) fn no_fourth_order(context: &Context<'_>, missing: Missing) -> TokenStream {
    absent(context, missing, &[&FOURTH_ORDER_FIELD])
}

/// Returns `impl FourthOrderField` for a canonical system without damping. It needs no kernel of its own: the runtime
/// builds it from the routines of collocation and of discrete gradients.
pub(super) fn canonical_fourth_order(context: &Context<'_>, momenta: &Routine, system: &System) -> TokenStream {
    let autonomous = system.has(Fact::Autonomous);
    let (name, phase, array, parts) =
        (self_type(context), context.phase_type(), context.positions_type(), context.parts());
    // A conserved momentum has a gradient with an entry for each position and each momentum.
    let count = momenta.nodes().len() / (2 * context.energy.degrees() as usize);
    let columns = Literal::usize_unsuffixed(1 + count);
    let slopes = context.outputs(momenta, |outputs| {
        let written = |values: &Values<'_>| {
            let mut places = values.output.places();
            // The runtime writes the gradient of the energy to the first entry.
            places.iter_mut().for_each(|indices| indices[0] += 1);
            write("slopes", &places, &values.all)
        };
        outputs.iter().map(written).collect::<TokenStream>()
    });
    // Gradients of momenta may nearly depend on each other. The runtime then solves again without the dependent ones.
    let loosen = (count > 0).then(|| {
        quote! {
            #[inline]
            fn fourth_loosen(start: &mut Self::FourthStart) -> bool {
                fourth_order::loosen(start)
            }
        }
    });
    let items = quote! {
        type FourthParameters = fourth_order::ParametersOf<Self, R>;
        type FourthStart = fourth_order::Begun<#array>;

        #[inline]
        fn fourth_parameters(&self, h: R) -> Self::FourthParameters {
            fourth_order::parameters(self, h)
        }
        #[inline(always)]
        fn fourth_begin(&self, parameters: &Self::FourthParameters, span: Span<R>, z: &#phase) -> Self::FourthStart {
            fourth_order::begin(self, parameters, span, z)
        }
        #[inline(always)]
        fn fourth_slope(
            &self,
            parameters: &Self::FourthParameters,
            start: &Self::FourthStart,
            d: &#phase,
            image: &mut #phase,
            matrix: &mut Square<#phase>,
        ) {
            let momenta = |z: &#phase| self.momenta(z);
            fourth_order::slope::<#autonomous, #columns, _, _>(self, parameters, start, momenta, d, (image, matrix));
        }
        #loosen
    };
    let fourth = proven(context, quote!(FourthOrderField<R>), items);
    quote! {
        impl<R: Real> KeptMomenta<R> for #name {
            type Values = [R; #columns];

            #[inline(always)]
            fn momenta(&self, z: &#phase) -> [#phase; #columns] {
                let mut slopes = [<#phase as Array>::zero(); #columns];
                #parts
                #slopes
                slopes
            }
        }
        #fourth
    }
}

/// Returns `impl FourthOrderField` for a system that is not canonical, with the equation that was derived for it.
pub(super) fn fourth_order(context: &Context<'_>, field: &FieldKernels, kernel: &Kernel) -> TokenStream {
    let unknown = array_type(&field.increments.extents);
    let names = [["FourthParameters", "fourth_parameters"], ["FourthStart", "fourth_begin"]];
    let start = quote!(Span { start, middle: t, end }: Span<R>, y: &#unknown);
    let Prepared { types, functions, prepared, started } =
        Prepared::for_steps(context, kernel, names, &quote!(), &start);
    let image = context.body(kernel.routine("equation"));
    let items = quote! {
        #types

        #functions
        #[inline(always)]
        fn fourth_slope(
            &self,
            prepared: &#prepared,
            start: &#started,
            d: &#unknown,
            image: &mut #unknown,
            matrix: &mut Square<#unknown>,
        ) #image
    };
    proven(context, quote!(FourthOrderField<R>), items)
}

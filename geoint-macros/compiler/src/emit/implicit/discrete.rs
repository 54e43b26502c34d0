//! The equations of `DiscreteGradient` and of `FourthOrder(DiscreteGradient)`. Divided differences replace the derivatives of conserved quantities, which the
//! steps therefore keep. The second method projects a mean velocity of order 4 onto the increments that keep them.
//!
//! A step starts at `y` and adds the increment `d`. The unknown is `d`. In a system of second order (H = T(p) + V(q) with a quadratic T, neither damping nor
//! forces) y = q, the unknown is the impulse u of the momenta, and d = h ∂T/∂p(p + u/2).
//!
//! In the tables of methods, `Hint` is `#[inline]`, `Always` is `#[inline(always)]`, and `wide` writes a comma after the last argument.

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

/// The set of quantities that steps along the discrete gradient keep: the type `Kept`. A run removes the drift that rounding causes in them.
///
/// The constant `STEEP` is `true` by default. If a step makes a coordinate much smaller, the rounding error of its earlier size remains. An integral is steep
/// if this error times its derivative may exceed the rounding of the integral. For integrals that are nowhere steep the constant is `false`, and the runtime
/// omits a check. The runtime's trait has no type `Proof`.
pub(super) const KEEPING: Trait =
    Trait { name: "Keeping", has_proof: false, associated: &[("Kept", Absent::Unit)], methods: &[], provided: &[] };

/// The equation of a step along the discrete gradient. `slope` computes f̄, the field with a discrete gradient between `y` and `y + d`, into `f`, and ∂f̄/∂d
/// into `jacobian`. In a system of second order, `drift` returns h ∂T/∂p((p₀ + p₁)/2) from `sum` = p₀ + p₁. In other systems it returns zero and is not called.
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

/// The equation of a step of order 4. `fourth_slope` computes h·f̄ into `image`, for the projected mean velocity f̄, and 1 − ∂(h·f̄)/∂d into `matrix`.
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

/// Returns `impl Keeping` and `impl DiscreteField`, and names `TreeStep` of the runtime as the step of `DiscreteGradient`.
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
    // By default the runtime builds the equation from `slope`, h and the constants of collocation. The kernel of a small system overrides this function. It
    // ignores the first argument, because h and the masses are in its prepared numbers.
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
    // With an entropy, a step of negative length may lower the entropy. The proof of this implementation excludes compositions with such steps.
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

/// Returns the implementation of `FourthOrderField` for a system with an entropy. No scalar satisfies it, because a step of order 4 may lower the entropy. Its
/// use is a compile error that states this reason.
pub(super) fn no_fourth_order(context: &Context<'_>, missing: Missing) -> TokenStream {
    absent(context, missing, &[&FOURTH_ORDER_FIELD])
}

/// Returns `impl FourthOrderField` for a canonical system without damping and forces. It needs no kernel of its own: the runtime's module `fourth_order` builds
/// the equation from the kernels of collocation and of discrete gradients, and from the gradients of `momenta`. The module is not the function of this file.
pub(super) fn canonical_fourth_order(context: &Context<'_>, momenta: &Routine, system: &System) -> TokenStream {
    let autonomous = system.has(Fact::Autonomous);
    let (name, phase, array, parts) =
        (self_type(context), context.phase_type(), context.positions_type(), context.parts());
    // The gradient of one conserved momentum has 2n entries with n degrees of freedom: one for each position and each momentum.
    let count = momenta.nodes().len() / (2 * context.energy.degrees() as usize);
    let columns = Literal::usize_unsuffixed(1 + count);
    let slopes = context.outputs(momenta, |outputs| {
        let written = |values: &Values<'_>| {
            let mut places = values.output.places();
            // The first entry is the place of the gradient of the energy. The runtime writes it, so momenta start at the second entry.
            places.iter_mut().for_each(|indices| indices[0] += 1);
            write("slopes", &places, &values.all)
        };
        outputs.iter().map(written).collect::<TokenStream>()
    });
    // The gradient of a momentum may nearly depend on those before it, so that the projection is nearly singular. `loosen` excludes such momenta, and the
    // runtime solves again. Without momenta, the default returns `false`: there is nothing to exclude.
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

/// Returns `impl FourthOrderField` for a field x' = f(x, t) with integrals and without an entropy. The kernel has the equation of the whole step.
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

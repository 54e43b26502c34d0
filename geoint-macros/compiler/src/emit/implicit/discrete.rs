//! The field of discrete gradients, with divided differences.

use super::prepared::{Prepared, numbers};
use crate::analyze::MeanValue;
use crate::derive::{FieldKernels, Missing};
use crate::emit::implementation::{Absent, Implementation, Inline, Method, Trait, Ty, absent, methods, ty};
use crate::emit::kernel::{Context, Values, array_type, write};
use crate::emit::structure::self_type;
use crate::schedule::{Kernel, Routine};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The trait that states how steps along a discrete gradient are solved.
macro_rules! graded {
    ($by:literal) => {
        Trait {
            name: "Graded",
            has_proof: true,
            associated: &[("Gradient", Absent::Named($by)), ("Kept", Absent::Unit)],
            methods: &[],
            provided: &[],
        }
    };
}
pub(super) use graded;

const GRADED: Trait = graded!("ByTree");

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

/// `impl Graded` and `impl DiscreteField`.
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
    let graded = Implementation::new(context, &GRADED, &[])
        .items(quote!(type Proof = (); type Gradient = ByTree; type Kept = #kept; #nowhere_steep))
        .finish();
    let types = [("Parameters", parameters.clone()), ("Start", start.clone()), ("Unknown", quote!(#unknown))];
    let field = Implementation::new(context, &DISCRETE_FIELD, &types)
        .items(quote! {
            type Proof = ();
            type Parameters = #parameters;
            type Start = #start;
            type Inverse = #inverse;
            const MEAN: Mean = Mean::#mean;
        })
        .method("parameters", context.stored(kernel, 0))
        .method("begin", context.stored(kernel, 1))
        .method("slope", context.assigned(kernel.routine("slope")))
        .items(equation)
        .method("drift", quote!(let mut drift = <#unknown as Array>::zero(); #drift drift))
        .finish();
    quote!(#graded #field)
}

/// The implementations of a field that keeps nothing, for no scalar.
pub(super) fn nothing_kept(context: &Context<'_>, missing: Missing) -> TokenStream {
    absent(context, missing, &[&GRADED, &DISCRETE_FIELD])
}

/// `impl FourthOrderField` of a canonical system that is not damped: by the kernels of collocation and of discrete gradients.
pub(super) fn canonical_fourth_order(context: &Context<'_>, momenta: &Routine, autonomous: bool) -> TokenStream {
    let (name, phase, array) = (self_type(context), context.phase(), context.array());
    let parts = context.parts();
    let count = momenta.nodes().len() / (2 * context.energy.degrees() as usize);
    let columns = Literal::usize_unsuffixed(1 + count);
    // The first gradient is that of the energy.
    let after_energy = |mut place: Vec<usize>| {
        place[0] += 1;
        place
    };
    let slopes = context.outputs(momenta, |outputs| {
        let written = |values: &Values<'_>| {
            let places: Vec<_> = values.output.places().into_iter().map(after_energy).collect();
            write("slopes", &places, &values.all)
        };
        outputs.iter().map(written).collect::<TokenStream>()
    });
    let loosen = (count > 0).then(|| {
        quote! {
            #[inline]
            fn fourth_loosen(start: &mut Self::FourthStart) -> bool {
                fourth_order::loosen(start)
            }
        }
    });
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
        impl<R: Real> FourthOrderField<R> for #name {
            type Proof = ();
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
            fn fourth_slope<const NEARLY: bool>(
                &self,
                parameters: &Self::FourthParameters,
                start: &Self::FourthStart,
                d: &#phase,
                image: &mut #phase,
                matrix: &mut Square<#phase>,
            ) {
                let momenta = |z: &#phase| self.momenta(z);
                fourth_order::slope::<{ NEARLY }, #autonomous, #columns, _, _>(self, parameters, start, momenta, d, (image, matrix));
            }
            #loosen
        }
    }
}

/// `impl FourthOrderField`.
pub(super) fn fourth_order(context: &Context<'_>, field: &FieldKernels, kernel: &Kernel) -> TokenStream {
    let (name, unknown) = (self_type(context), array_type(&field.increments.extents));
    let names = [["FourthParameters", "fourth_parameters"], ["FourthStart", "fourth_begin"]];
    let start = quote!(Span { start, middle: t, end }: Span<R>, y: &#unknown);
    let Prepared { types, functions, prepared, started } =
        Prepared::for_steps(context, kernel, names, &quote!(), &start);
    let image = context.body(kernel.routine("equation"));
    quote! {
        impl<R: Real> FourthOrderField<R> for #name {
            type Proof = ();
            #types

            #functions
            #[inline(always)]
            fn fourth_slope<const NEARLY: bool>(
                &self,
                prepared: &#prepared,
                start: &#started,
                d: &#unknown,
                image: &mut #unknown,
                matrix: &mut Square<#unknown>,
            ) #image
        }
    }
}

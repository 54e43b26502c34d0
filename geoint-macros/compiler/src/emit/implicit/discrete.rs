//! The field of discrete gradients, with divided differences.

use super::prepared::Prepared;
use crate::analyze::MeanValue;
use crate::derive::{FieldKernels, Missing};
use crate::emit::kernel::{Context, Values, array_type, write};
use crate::emit::missing::unsatisfied;
use crate::emit::structure::self_type;
use crate::schedule::{Kernel, Routine};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// `impl DiscreteField`.
pub(super) fn discrete_field(
    context: &Context<'_>,
    field: &FieldKernels,
    kernel: &Kernel,
    kept: &TokenStream,
    nowhere_steep: Option<TokenStream>,
) -> TokenStream {
    let (name, unknown) = (self_type(context), array_type(&field.increments.extents));
    let names = [["Parameters", "parameters"], ["Start", "begin"]];
    let start = quote!(Span { start, middle: t, end }: Span<R>, y: &#unknown);
    let Prepared { types, functions, prepared, started } =
        Prepared::for_steps(context, kernel, names, &quote!(), &start);
    let slope = context.body(kernel.routine("slope"));
    let equation = kernel.find("equation").map(|equation| {
        let equation = context.body(equation);
        quote! {
            #[inline(always)]
            fn equation(
                &self,
                _: (&Self::Constants, R),
                prepared: &#prepared,
                start: &#started,
                d: &#unknown,
                image: &mut #unknown,
                matrix: &mut Square<#unknown>,
            ) #equation
        }
    });
    let drift = context.assigned(kernel.routine("drift"));
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
    quote! {
        impl<R: Real> Graded<R> for #name {
            type Proof = ();
            type Gradient = ByTree;
            type Kept = #kept;
            #nowhere_steep
        }
        impl<R: Real> DiscreteField<R> for #name {
            type Proof = ();
            #types
            type Inverse = #inverse;
            const MEAN: Mean = Mean::#mean;

            #functions
            #[inline(always)]
            fn slope(
                &self,
                prepared: &#prepared,
                start: &#started,
                d: &#unknown,
                f: &mut #unknown,
                jacobian: &mut Square<#unknown>,
            ) #slope
            #equation
            #[inline(always)]
            fn drift(&self, prepared: &#prepared, sum: &#unknown) -> #unknown {
                let mut drift = <#unknown as Array>::zero();
                #drift
                drift
            }
        }
    }
}

/// `impl DiscreteField`, and what it is of, that no scalar satisfies, of a field that keeps nothing.
pub(super) fn nothing_kept(context: &Context<'_>, missing: Missing) -> TokenStream {
    let (marker, tokens) = unsatisfied(context, missing);
    let (name, phase) = (self_type(context), context.phase());
    let never = quote!(::core::convert::Infallible);
    quote! {
        #tokens
        impl<R: Real + #marker> Graded<R> for #name {
            type Proof = <R as #marker>::Proof;
            type Gradient = ByTree;
            type Kept = ();
        }
        impl<R: Real + #marker> DiscreteField<R> for #name {
            type Proof = <R as #marker>::Proof;
            type Parameters = #never;
            type Start = #never;
            type Inverse = ();
            fn parameters(&self, _: R) -> #never {
                ::core::unreachable!()
            }
            fn begin(&self, never: &#never, _: Span<R>, _: &#phase) -> #never {
                match *never {}
            }
            fn slope(&self, never: &#never, _: &#never, _: &#phase, _: &mut #phase, _: &mut Square<#phase>) {
                match *never {}
            }
            fn drift(&self, never: &#never, _: &#phase) -> #phase {
                match *never {}
            }
        }
    }
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

//! The field of implicit methods: with derivatives for collocation, with divided differences for discrete gradients.

use super::kernel::{Context, element, write};
use super::system::self_type;
use crate::analyze::MeanValue;
use crate::derive::FieldKernels;
use crate::ir::Symbol;
use crate::schedule::Plan;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The places of a square matrix, row by row.
pub(super) fn square(places: &[Vec<usize>]) -> Vec<Vec<usize>> {
    places.iter().flat_map(|row| places.iter().map(move |column| [&row[..], &column[..]].concat())).collect()
}

/// The statements that write f and its derivative.
pub(super) fn write_field(names: [&str; 2], places: &[Vec<usize>], values: &[TokenStream]) -> TokenStream {
    let (f, jacobian) = values.split_at(places.len());
    let f = write(names[0], places, f);
    let jacobian = write(names[1], &square(places), jacobian);
    quote!(#f #jacobian)
}

fn momenta(degrees: u32) -> Vec<Symbol> {
    (0..degrees).map(Symbol::P).collect()
}

/// `impl DiscreteField`.
pub(super) fn discrete_field(context: &Context<'_>, field: &FieldKernels<Plan>, plan: &Plan) -> TokenStream {
    let name = self_type(context);
    let FieldKernels { increments, .. } = field;
    let unknown = context.unknown_type(increments.len());
    let places = context.unknown_places(increments.len());
    let parameters = context.stored(plan, 0);
    let begin = context.planned(&plan.stores[1], (&field.coordinates, "y"), |values| quote!([#(#values),*]));
    let [prepared, started] = [plan.slots[0], plan.slots[1]].map(Literal::usize_unsuffixed);
    let (given, names) = ((&increments[..], "d"), [["f", "jacobian"], ["image", "matrix"]]);
    let slope = context.planned(&plan.last[0], given, |values| write_field(names[0], &places, &values));
    let equation = field.folded.then(|| {
        let equation = context.planned(&plan.last[1], given, |values| write_field(names[1], &places, &values));
        quote! {
            #[inline(always)]
            fn equation(
                &self,
                _: (&Self::Constants, R),
                prepared: &[R; #prepared],
                start: &[R; #started],
                d: &#unknown,
                image: &mut #unknown,
                matrix: &mut Square<#unknown>,
            ) {
                #equation
            }
        }
    });
    let mean: Vec<Symbol> = (0..plan.last[2].results.len() as u32).map(Symbol::Dp).collect();
    let drift = context.planned(&plan.last[2], (&mean, "p"), |values| write("drift", &places, &values));
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
        }
        impl<R: Real> DiscreteField<R> for #name {
            type Proof = ();
            type Parameters = [R; #prepared];
            type Start = [R; #started];
            type Inverse = #inverse;
            const MEAN: Mean = Mean::#mean;

            #[inline]
            fn parameters(&self, h: R) -> [R; #prepared] {
                #parameters
            }
            #[inline(always)]
            fn begin(&self, prepared: &[R; #prepared], t: R, y: &#unknown) -> [R; #started] {
                #begin
            }
            #[inline(always)]
            fn slope(
                &self,
                prepared: &[R; #prepared],
                start: &[R; #started],
                d: &#unknown,
                f: &mut #unknown,
                jacobian: &mut Square<#unknown>,
            ) {
                #slope
            }
            #equation
            #[inline(always)]
            fn drift(&self, prepared: &[R; #prepared], p: &#unknown) -> #unknown {
                let mut drift = <#unknown as Array>::zero();
                #drift
                drift
            }
        }
    }
}

/// `impl FourthOrderField` of a canonical system that is not damped: by the kernels of collocation and of discrete gradients.
pub(super) fn canonical_fourth_order(context: &Context<'_>, autonomous: bool) -> TokenStream {
    let (name, phase, array) = (self_type(context), context.phase(), context.array());
    quote! {
        impl<R: Real> FourthOrderField<R> for #name {
            type Proof = ();
            type FourthParameters = fourth_order::ParametersOf<Self, R>;
            type FourthStart = fourth_order::Begun<#array>;

            #[inline]
            fn fourth_parameters(&self, h: R) -> Self::FourthParameters {
                fourth_order::parameters(self, h)
            }
            #[inline(always)]
            fn fourth_begin(&self, parameters: &Self::FourthParameters, t: R, z: &#phase) -> Self::FourthStart {
                fourth_order::begin(self, parameters, t, z)
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
                fourth_order::slope::<#autonomous, _, _>(self, parameters, start, d, image, matrix);
            }
        }
    }
}

/// `impl FourthOrderField`.
pub(super) fn fourth_order(context: &Context<'_>, field: &FieldKernels<Plan>, plan: &Plan) -> TokenStream {
    let (name, unknown) = (self_type(context), context.unknown_type(field.increments.len()));
    let places = context.unknown_places(field.increments.len());
    let parameters = context.stored(plan, 0);
    let begin = context.planned(&plan.stores[1], (&field.coordinates, "y"), |values| quote!([#(#values),*]));
    let [prepared, started] = [plan.slots[0], plan.slots[1]].map(Literal::usize_unsuffixed);
    let image = context
        .planned(&plan.last[0], (&field.increments, "d"), |values| write_field(["image", "matrix"], &places, &values));
    quote! {
        impl<R: Real> FourthOrderField<R> for #name {
            type Proof = ();
            type FourthParameters = [R; #prepared];
            type FourthStart = [R; #started];

            #[inline]
            fn fourth_parameters(&self, h: R) -> [R; #prepared] {
                #parameters
            }
            #[inline(always)]
            fn fourth_begin(&self, prepared: &[R; #prepared], t: R, y: &#unknown) -> [R; #started] {
                #begin
            }
            #[inline(always)]
            fn fourth_slope(
                &self,
                prepared: &[R; #prepared],
                start: &[R; #started],
                d: &#unknown,
                image: &mut #unknown,
                matrix: &mut Square<#unknown>,
            ) {
                #image
            }
        }
    }
}

/// `impl Collocation`.
pub(super) fn collocation(context: &Context<'_>, field: &FieldKernels<Plan>) -> TokenStream {
    let (name, phase) = (self_type(context), context.phase());
    let FieldKernels { coordinates, collocation: plan, .. } = field;
    let unknown = context.unknown_type(coordinates.len());
    let places = context.unknown_places(coordinates.len());
    let constants = context.stored(plan, 0);
    let evaluate =
        context.planned(&plan.last[0], (coordinates, "y"), |values| write_field(["f", "jacobian"], &places, &values));
    let momenta = momenta(context.energy.degrees());
    let velocity = context.planned(&plan.last[1], (&momenta, "p"), |values| write("velocity", &places, &values));
    let y: Vec<_> = places.iter().map(|indices| element(quote!(y), indices)).collect();
    let [derivative, start, add, increments] = if field.second_order {
        let add =
            context.planned(&plan.last[2], (&momenta, "f"), |values| quote!(#(#y = w.multiply_add(#values, #y);)*));
        [quote!(2), quote!((z[0], z[1])), add, quote!([*change, *impulse])]
    } else {
        let f = places.iter().map(|indices| element(quote!(f), indices));
        let add = quote!(#(#y = w.multiply_add(#f, #y);)*);
        [quote!(1), quote!((*z, *z)), add, quote!(*change)]
    };
    let prepared = Literal::usize_unsuffixed(plan.slots[0]);
    quote! {
        impl<R: Real> Collocated<R> for #name {
            type Proof = ();
            type Stages = ByField;
        }
        impl<R: Real> Collocation<R> for #name {
            type Proof = ();
            type Unknown = #unknown;
            type Constants = [R; #prepared];
            const DERIVATIVE: usize = #derivative;

            #[inline]
            fn constants(&self) -> [R; #prepared] {
                #constants
            }
            #[inline(always)]
            fn start(z: &#phase) -> (#unknown, #unknown) {
                #start
            }
            #[inline(always)]
            fn velocity(&self, prepared: &[R; #prepared], p: &#unknown) -> #unknown {
                let mut velocity = <#unknown as Array>::zero();
                #velocity
                velocity
            }
            #[inline(always)]
            fn field(
                &self,
                prepared: &[R; #prepared],
                t: R,
                y: &#unknown,
                f: &mut #unknown,
                jacobian: &mut Square<#unknown>,
            ) {
                #evaluate
            }
            #[inline(always)]
            fn add(&self, prepared: &[R; #prepared], w: R, f: &#unknown, y: &mut #unknown) {
                #add
            }
            #[inline(always)]
            fn increments(change: &#unknown, impulse: &#unknown) -> #phase {
                #increments
            }
        }
    }
}

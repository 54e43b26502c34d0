//! The field of implicit methods: with derivatives for collocation, with divided differences for discrete gradients.

use super::kernel::{Context, place, write};
use super::system::self_type;
use crate::analyze::{MeanValue, Structure};
use crate::diff::{Field, SecondOrder};
use crate::ir::{Graph, Id, Symbol};
use crate::schedule::{self, Operations};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The places of a square matrix, row by row.
fn square(places: &[Vec<usize>]) -> Vec<Vec<usize>> {
    places.iter().flat_map(|row| places.iter().map(move |column| [&row[..], &column[..]].concat())).collect()
}

/// The levels of a kernel that is evaluated again and again: parameters and h, the start of a step, iterates.
pub(super) fn level(symbol: Symbol) -> usize {
    match symbol {
        Symbol::Parameter(_) | Symbol::H | Symbol::G => 0,
        Symbol::Q(_) | Symbol::P(_) | Symbol::S | Symbol::T => 1,
        Symbol::Dq(_) | Symbol::Dp(_) | Symbol::Ds => 2,
    }
}

/// The statements that write f and its derivative.
pub(super) fn write_field(field: &Field, places: &[Vec<usize>], values: &[TokenStream]) -> TokenStream {
    let (f, jacobian) = values.split_at(field.f.len());
    let f = write("f", places, f);
    let jacobian = write("jacobian", &square(places), jacobian);
    quote!(#f #jacobian)
}

pub(super) fn roots(field: &Field) -> Vec<Id> {
    field.f.iter().chain(field.jacobian.iter().flatten()).copied().collect()
}

/// `impl DiscreteField`, and what an evaluation costs.
pub(super) fn discrete_field(
    context: &Context<'_>,
    graph: &mut Graph,
    (field, start): (&Field, &[Symbol]),
    structure: &Structure,
    bounds: &TokenStream,
) -> (TokenStream, Operations) {
    let name = self_type(context);
    let unknown = context.unknown_type(field.unknowns.len());
    let places = context.unknown_places(field.unknowns.len());
    let plan = schedule::plan(graph, level, &[&[], &[]], &[&roots(field)]);
    let parameters = context.planned(&plan.stores[0], (&[], ""), |values| quote!([#(#values),*]));
    let begin = context.planned(&plan.stores[1], (start, "y"), |values| quote!([#(#values),*]));
    let slope = context.planned(&plan.last[0], (&field.unknowns, "d"), |values| write_field(field, &places, &values));
    let linear = structure.linear();
    let mean = match structure.mean_value {
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
    let [prepared, started] = [plan.slots[0], plan.slots[1]].map(Literal::usize_unsuffixed);
    let tokens = quote! {
        impl<R: #bounds> DiscreteField<R> for #name {
            type Parameters = [R; #prepared];
            type Start = [R; #started];
            const LINEAR: bool = #linear;
            const MEAN: Mean = Mean::#mean;

            #[inline]
            fn parameters(&self) -> [R; #prepared] {
                #parameters
            }
            #[inline(always)]
            fn begin(prepared: &[R; #prepared], t: R, y: &#unknown) -> [R; #started] {
                #begin
            }
            #[inline(always)]
            fn slope(
                prepared: &[R; #prepared],
                start: &[R; #started],
                d: &#unknown,
                f: &mut #unknown,
                jacobian: &mut Square<#unknown>,
            ) {
                #slope
            }
        }
    };
    (tokens, plan.last[0].operations())
}

/// `impl Collocation`, and what one evaluation of the field with its derivative costs.
pub(super) fn collocation(
    context: &Context<'_>,
    graph: &mut Graph,
    field: &Field,
    second_order: Option<&SecondOrder>,
    bounds: &TokenStream,
) -> (TokenStream, Operations) {
    let (name, array) = (self_type(context), context.array());
    let unknown = context.unknown_type(field.unknowns.len());
    let places = context.unknown_places(field.unknowns.len());
    let (velocity, acceleration): (&[Id], &[Id]) =
        second_order.map_or((&[], &[]), |second_order| (&second_order.velocity, &second_order.acceleration));
    // Iterates are the only thing that is not prepared.
    let level = |symbol| level(symbol).min(1);
    let plan = schedule::plan(graph, level, &[&[]], &[&roots(field), velocity, acceleration]);

    let constants = context.planned(&plan.stores[0], (&[], ""), |values| quote!([#(#values),*]));
    let evaluate =
        context.planned(&plan.last[0], (&field.unknowns, "y"), |values| write_field(field, &places, &values));
    let momenta: Vec<Symbol> = (0..context.energy.degrees()).map(Symbol::P).collect();
    let velocity = context.planned(&plan.last[1], (&momenta, "p"), |values| write("velocity", &places, &values));
    let y: Vec<_> = places.iter().map(|indices| place(quote!(y), indices)).collect();
    let [derivative, start, add, increments] = if second_order.is_some() {
        let add =
            context.planned(&plan.last[2], (&momenta, "f"), |values| quote!(#(#y = w.multiply_add(#values, #y);)*));
        [quote!(2), quote!((*q, *p)), add, quote!([*change, *impulse])]
    } else {
        let f = places.iter().map(|indices| place(quote!(f), indices));
        let add = quote!(#(#y = w.multiply_add(#f, #y);)*);
        [quote!(1), quote!(([*q, *p], [*q, *p])), add, quote!(*change)]
    };
    let prepared = Literal::usize_unsuffixed(plan.slots[0]);
    let tokens = quote! {
        impl<R: #bounds> Collocation<R> for #name {
            type Unknown = #unknown;
            type Constants = [R; #prepared];
            const DERIVATIVE: usize = #derivative;

            #[inline]
            fn constants(&self) -> [R; #prepared] {
                #constants
            }
            #[inline(always)]
            fn start(q: &#array, p: &#array) -> (#unknown, #unknown) {
                #start
            }
            #[inline(always)]
            fn velocity(prepared: &[R; #prepared], p: &#unknown) -> #unknown {
                let mut velocity = <#unknown as Array>::zero();
                #velocity
                velocity
            }
            #[inline(always)]
            fn field(
                prepared: &[R; #prepared],
                t: R,
                y: &#unknown,
                f: &mut #unknown,
                jacobian: &mut Square<#unknown>,
            ) {
                #evaluate
            }
            #[inline(always)]
            fn add(prepared: &[R; #prepared], w: R, f: &#unknown, y: &mut #unknown) {
                #add
            }
            #[inline(always)]
            fn increments(change: &#unknown, impulse: &#unknown) -> [#array; 2] {
                #increments
            }
        }
    };
    (tokens, plan.last[0].operations())
}

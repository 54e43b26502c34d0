//! Implicit steps: the equation of the discrete gradient, and the field that collocation follows.

use super::flows::unsatisfied;
use super::kernel::{Context, place, write};
use super::system::self_type;
use crate::diff::MissingSlope;
use crate::diff::equation::{Equation, Field};
use crate::ir::{Graph, Id, Symbol};
use crate::schedule::{self, Operations};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// The places of a square matrix, row by row.
fn square(places: &[Vec<usize>]) -> Vec<Vec<usize>> {
    places.iter().flat_map(|row| places.iter().map(move |column| [&row[..], &column[..]].concat())).collect()
}

/// `impl DiscreteGradientStep`, and what an iteration costs.
pub(super) fn discrete_gradient(
    context: &Context<'_>,
    graph: &mut Graph,
    equation: &Equation,
    bounds: &TokenStream,
) -> (TokenStream, Operations) {
    let (name, array) = (self_type(context), context.array());
    let unknowns = &equation.unknowns;
    let increment = context.unknown_type(unknowns.len());
    let places = context.unknown_places(unknowns.len());
    let entries = square(&places);

    let iteration: Vec<Id> = equation.residual.iter().chain(equation.jacobian.iter().flatten()).copied().collect();
    let drift = equation.drift.as_deref().unwrap_or_default();
    let level = |symbol| match symbol {
        Symbol::Parameter(_) | Symbol::H => 0,
        Symbol::Q(_) | Symbol::P(_) | Symbol::T => 1,
        Symbol::Dq(_) | Symbol::Dp(_) => 2,
    };
    let plan = schedule::plan(graph, level, &[&[], &equation.guess], &[&iteration, drift]);

    let outside = (&unknowns[..], "increment");
    let prepare = context.planned(&plan.stores[0], outside, |values| quote!([#(#values),*]));
    let start = context.planned(&plan.stores[1], outside, |values| {
        let (guess, slots) = values.split_at(unknowns.len());
        let guess = write("guess", &places, guess);
        quote!(let mut guess = <#increment as Array>::zero(); #guess ([#(#slots),*], guess))
    });
    // Increments of positions, if those of momenta are the unknowns.
    let drift = context.planned(&plan.last[1], outside, |values| {
        let names = (0..values.len()).map(|i| format_ident!("dq{i}"));
        quote!(#(let #names = #values;)*)
    });
    let residual = context.planned(&plan.last[0], outside, |values| {
        let (residual, jacobian) = values.split_at(unknowns.len());
        let residual = write("residual", &places, residual);
        let jacobian = write("jacobian", &entries, jacobian);
        quote!(#residual #jacobian)
    });
    let finish = (0..context.energy.degrees()).map(|i| {
        let [q, p] = [quote!(q), quote!(p)].map(|base| place(base, &context.coordinate(i)));
        let [dq, dp] = [Symbol::Dq(i), Symbol::Dp(i)].map(|s| context.input_or_unknown(unknowns, "increment", s));
        quote!(#q += #dq; #p += #dp;)
    });
    let origin = if unknowns.len() == context.coordinates().len() { quote!(*p) } else { quote!([*q, *p]) };
    let [prepared, started] = [plan.slots[0], plan.slots[1]].map(Literal::usize_unsuffixed);
    let tokens = quote! {
        impl<R: #bounds> DiscreteGradientStep<R> for #name {
            type Increment = #increment;
            type Prepared = [R; #prepared];
            type Start = [R; #started];

            #[inline]
            fn prepare(&self, h: R) -> [R; #prepared] {
                #prepare
            }
            #[inline(always)]
            fn start(prepared: &[R; #prepared], t: R, q: &#array, p: &#array) -> ([R; #started], #increment) {
                #start
            }
            #[inline(always)]
            fn origin(q: &#array, p: &#array) -> #increment {
                #origin
            }
            #[inline(always)]
            fn residual(
                prepared: &[R; #prepared],
                start: &[R; #started],
                increment: &#increment,
                residual: &mut #increment,
                jacobian: &mut Square<#increment>,
            ) {
                #drift
                #residual
            }
            #[inline(always)]
            fn finish(
                prepared: &[R; #prepared],
                start: &[R; #started],
                increment: &#increment,
                q: &mut #array,
                p: &mut #array,
            ) {
                #drift
                #(#finish)*
            }
        }
    };
    (tokens, plan.last[1].operations() + plan.last[0].operations())
}

/// An implementation that no scalar satisfies, whose message names the term that has no slope.
pub(super) fn missing_discrete_gradient(
    context: &Context<'_>,
    graph: &Graph,
    missing: MissingSlope,
    bounds: &TokenStream,
) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let (marker, tokens) = unsatisfied(context, graph, "DividedDifferencesOf", missing.0, NO_SLOPE);
    let never = quote!(::core::convert::Infallible);
    quote! {
        #tokens
        impl<R: #bounds + #marker> DiscreteGradientStep<R> for #name {
            type Increment = #array;
            type Prepared = #never;
            type Start = #never;
            fn prepare(&self, _: R) -> #never {
                ::core::unreachable!()
            }
            fn start(never: &#never, _: R, _: &#array, _: &#array) -> (#never, #array) {
                match *never {}
            }
            fn origin(q: &#array, _: &#array) -> #array {
                *q
            }
            fn residual(never: &#never, _: &#never, _: &#array, _: &mut #array, _: &mut Square<#array>) {
                match *never {}
            }
            fn finish(never: &#never, _: &#never, _: &#array, _: &mut #array, _: &mut #array) {
                match *never {}
            }
        }
    }
}

pub(super) const NO_SLOPE: &str = "this term has no divided difference yet, so the discrete gradient does not exist; use \
                                   `ImplicitMidpoint` or `Gauss`";

/// `impl Collocation`, and what one evaluation of the field with its derivative costs.
pub(super) fn collocation(
    context: &Context<'_>,
    graph: &mut Graph,
    field: &Field,
    bounds: &TokenStream,
) -> (TokenStream, Operations) {
    let (name, array) = (self_type(context), context.array());
    let unknowns = &field.unknowns;
    let unknown = context.unknown_type(unknowns.len());
    let places = context.unknown_places(unknowns.len());
    let entries = square(&places);

    let values: Vec<Id> = field.f.iter().chain(field.jacobian.iter().flatten()).copied().collect();
    let level = |symbol| usize::from(!matches!(symbol, Symbol::Parameter(_)));
    let (velocity, acceleration): (&[Id], &[Id]) = match &field.second_order {
        Some(second_order) => (&second_order.velocity, &second_order.acceleration),
        None => (&[], &[]),
    };
    let plan = schedule::plan(graph, level, &[&[]], &[&values, velocity, acceleration]);

    let prepare = context.planned(&plan.stores[0], (&[], ""), |values| quote!([#(#values),*]));
    let evaluate = context.planned(&plan.last[0], (unknowns, "y"), |values| {
        let (f, jacobian) = values.split_at(unknowns.len());
        let f = write("f", &places, f);
        let jacobian = write("jacobian", &entries, jacobian);
        quote!(#f #jacobian)
    });
    let [derivative, start, add, finish] = if field.second_order.is_some() {
        let velocity = context.planned(&plan.last[1], (&[], ""), |values| write("velocity", &places, &values));
        let momenta: Vec<Symbol> = (0..context.energy.degrees()).map(Symbol::P).collect();
        let add = context.planned(&plan.last[2], (&momenta, "f"), |values| {
            let y: Vec<_> = places.iter().map(|indices| place(quote!(y), indices)).collect();
            quote!(#(#y = w.multiply_add(#values, #y);)*)
        });
        let momenta: Vec<_> = places.iter().map(|indices| place(quote!(p), indices)).collect();
        let impulse = places.iter().map(|indices| place(quote!(impulse), indices));
        [
            quote!(2),
            quote!(let mut velocity = <#array as Array>::zero(); #velocity (*q, velocity, *p)),
            add,
            quote!(*q = *y; #(#momenta += #impulse;)*),
        ]
    } else {
        let y: Vec<_> = places.iter().map(|indices| place(quote!(y), indices)).collect();
        let f = places.iter().map(|indices| place(quote!(f), indices));
        [
            quote!(1),
            quote!(([*q, *p], <#unknown as Array>::zero(), [*q, *p])),
            quote!(#(#y = w.multiply_add(#f, #y);)*),
            quote!([*q, *p] = *y;),
        ]
    };
    let prepared = Literal::usize_unsuffixed(plan.slots[0]);
    let tokens = quote! {
        impl<R: #bounds> Collocation<R> for #name {
            type Unknown = #unknown;
            type Prepared = [R; #prepared];
            const DERIVATIVE: usize = #derivative;

            #[inline]
            fn prepare(&self) -> [R; #prepared] {
                #prepare
            }
            #[inline(always)]
            fn start(prepared: &[R; #prepared], q: &#array, p: &#array) -> (#unknown, #unknown, #unknown) {
                #start
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
            fn finish(y: &#unknown, impulse: &#unknown, q: &mut #array, p: &mut #array) {
                #finish
            }
        }
    };
    (tokens, plan.last[0].operations())
}

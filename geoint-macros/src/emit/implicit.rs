//! Implicit steps: the equation of a mean gradient, and the field that collocation solves.

use super::flows::unsatisfied;
use super::kernel::{Context, place};
use super::system::self_type;
use crate::diff::MissingSlope;
use crate::diff::equation::{Equation, Field};
use crate::ir::{Graph, Id, Symbol};
use crate::schedule::{self, Operations};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// Statements that write rows of values to `base[row][column]`, or values to `base[row]`.
fn write(base: &TokenStream, places: &[Vec<usize>], values: &[TokenStream]) -> TokenStream {
    let places = places.iter().map(|indices| place(base.clone(), indices));
    quote!(#(#places = #values;)*)
}

fn square(places: &[Vec<usize>]) -> Vec<Vec<usize>> {
    places.iter().flat_map(|row| places.iter().map(move |column| [&row[..], &column[..]].concat())).collect()
}

/// `impl MeanGradient<rule>`, and what an iteration costs.
pub(super) fn mean_gradient(
    context: &Context<'_>,
    graph: &mut Graph,
    equation: &Equation,
    rule: &str,
    bounds: &TokenStream,
) -> (TokenStream, Operations) {
    let (name, array, rule) = (self_type(context), context.array(), format_ident!("{rule}"));
    let unknowns = &equation.unknowns;
    let increment = context.unknown_type(unknowns.len());
    let places = context.unknown_places(unknowns.len());
    let entries = square(&places);

    let iteration: Vec<Id> = equation.residual.iter().chain(equation.jacobian.iter().flatten()).copied().collect();
    let increments: Vec<Id> = [&equation.dq[..], &equation.dp[..]].concat();
    let level = |symbol| match symbol {
        Symbol::Parameter(_) | Symbol::H => 0,
        Symbol::Q(_) | Symbol::P(_) | Symbol::T => 1,
        Symbol::Dq(_) | Symbol::Dp(_) => 2,
    };
    let plan = schedule::plan(graph, level, &[&[], &equation.guess], &[&iteration, &increments]);

    let outside = (&unknowns[..], "increment");
    let prepare = context.planned(&plan.stores[0], outside, |values| quote!([#(#values),*]));
    let start = context.planned(&plan.stores[1], outside, |values| {
        let (guess, slots) = values.split_at(unknowns.len());
        let guess = write(&quote!(guess), &places, guess);
        quote!(let mut guess = <#increment as Array>::zero(); #guess ([#(#slots),*], guess))
    });
    let residual = context.planned(&plan.last[0], outside, |values| {
        let (residual, jacobian) = values.split_at(unknowns.len());
        let residual = write(&quote!(residual), &places, residual);
        let jacobian = write(&quote!(jacobian), &entries, jacobian);
        quote!(#residual #jacobian)
    });
    let finish = context.planned(&plan.last[1], outside, |values| {
        let coordinates = context.coordinates();
        let (dq, dp) = values.split_at(coordinates.len());
        let add = |base: TokenStream, values: &[TokenStream]| -> TokenStream {
            let places = coordinates.iter().map(|indices| place(base.clone(), indices));
            quote!(#(#places += #values;)*)
        };
        let (q, p) = (add(quote!(q), dq), add(quote!(p), dp));
        quote!(#q #p)
    });
    let origin = if unknowns.len() == context.coordinates().len() { quote!(*p) } else { quote!([*q, *p]) };
    let [prepared, started] = [plan.slots[0], plan.slots[1]].map(Literal::usize_unsuffixed);
    let tokens = quote! {
        impl<R: #bounds> MeanGradient<#rule, R> for #name {
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
                #finish
            }
        }
    };
    (tokens, plan.last[0].operations())
}

/// An implementation that no scalar satisfies, whose message names the term that has no slope.
pub(super) fn missing_tree(context: &Context<'_>, graph: &Graph, missing: MissingSlope, bounds: &TokenStream) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let (marker, tokens) = unsatisfied(context, graph, "DividedDifferencesOf", missing.0, NO_SLOPE);
    let never = quote!(::core::convert::Infallible);
    quote! {
        #tokens
        impl<R: #bounds + #marker> MeanGradient<Tree, R> for #name {
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

/// `impl Collocation`.
pub(super) fn collocation(context: &Context<'_>, graph: &mut Graph, field: &Field, bounds: &TokenStream) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let unknowns = &field.unknowns;
    let unknown = context.unknown_type(unknowns.len());
    let places = context.unknown_places(unknowns.len());
    let entries = square(&places);
    let derivative = Literal::usize_unsuffixed(field.derivative as usize);
    let second_order = field.derivative == 2;

    let values: Vec<Id> = field.f.iter().chain(field.jacobian.iter().flatten()).copied().collect();
    let level = |symbol| usize::from(!matches!(symbol, Symbol::Parameter(_)));
    let (velocity, force): (&[Id], &[Id]) = if second_order { (&field.velocity, &field.force) } else { (&[], &[]) };
    let plan = schedule::plan(graph, level, &[&[]], &[&values, velocity, force]);

    let prepare = context.planned(&plan.stores[0], (&[], ""), |values| quote!([#(#values),*]));
    let evaluate = context.planned(&plan.last[0], (unknowns, "y"), |values| {
        let (f, jacobian) = values.split_at(unknowns.len());
        let f = write(&quote!(f), &places, f);
        let jacobian = write(&quote!(jacobian), &entries, jacobian);
        quote!(#f #jacobian)
    });
    let (start, impulse, advance) = if second_order {
        let velocity = context.planned(&plan.last[1], (&[], ""), |values| {
            let velocity = write(&quote!(velocity), &places, &values);
            quote!(let mut velocity = <#array as Array>::zero(); #velocity (*q, velocity))
        });
        let impulse = context.planned(&plan.last[2], (unknowns, "y"), |values| {
            let places = places.iter().map(|indices| place(quote!(p), indices)).collect::<Vec<_>>();
            quote!(#(#places = w.multiply_add(#values, #places);)*)
        });
        let advance = places.iter().map(|indices| {
            let (q, increment) = (place(quote!(q), indices), place(quote!(increment), indices));
            quote!(#q += #increment;)
        });
        (velocity, impulse, quote!(#(#advance)*))
    } else {
        let advance = context.coordinates().into_iter().map(|indices| {
            let (q, p) = (place(quote!(q), &indices), place(quote!(p), &indices));
            let (dq, dp) = (place(quote!(increment[0]), &indices), place(quote!(increment[1]), &indices));
            quote!(#q += #dq; #p += #dp;)
        });
        (quote!(([*q, *p], <#unknown as Array>::zero())), quote!(), quote!(#(#advance)*))
    };
    let prepared = Literal::usize_unsuffixed(plan.slots[0]);
    quote! {
        impl<R: #bounds> Collocation<R> for #name {
            type Unknown = #unknown;
            type Prepared = [R; #prepared];
            const DERIVATIVE: usize = #derivative;

            #[inline]
            fn prepare(&self) -> [R; #prepared] {
                #prepare
            }
            #[inline(always)]
            fn unknown(prepared: &[R; #prepared], q: &#array, p: &#array) -> (#unknown, #unknown) {
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
            fn impulse(prepared: &[R; #prepared], t: R, w: R, y: &#unknown, p: &mut #array) {
                #impulse
            }
            #[inline(always)]
            fn advance(increment: &#unknown, q: &mut #array, p: &mut #array) {
                #advance
            }
        }
    }
}

//! Where the energy is defined: what is tested at a point.

use super::damping;
use super::kernel::Context;
use super::poles;
use super::tokens::Tokens;
use crate::derive::{Angles, Check, Domain, Sign};
use crate::ir::{Graph, print::Printer};
use crate::schedule::Plan;
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::ext::IdentExt;

/// The items of `PhaseSpace` that speak of the domain.
pub(super) fn domain(context: &Context<'_>, graph: &Graph, domain: &Domain<Plan>) -> TokenStream {
    let (phase, parts, action) = (context.phase(), context.parts(), context.action());
    let damped = |entries: &[Tokens]| damping::matrix_test(context, entries);
    let outside = first_of(context, graph, (&domain.checks, &domain.arguments), damped);
    let names: Vec<&Ident> = context.energy.parameters().map(|parameter| &parameter.name).collect();
    let parameters = (!names.is_empty()).then(|| {
        let shown = names.iter().map(|name| name.unraw().to_string());
        // NaN is the one value that differs from itself.
        quote! {
            fn invalid_parameter(&self) -> ::core::option::Option<&'static str> {
                #(if self.#names != self.#names {
                    return ::core::option::Option::Some(#shown);
                })*
                ::core::option::Option::None
            }
        }
    });
    let edge = (!domain.edges.checks.is_empty()).then(|| {
        let edge = first_of(context, graph, (&domain.edges.checks, &domain.edges.arguments), |_| TokenStream::new());
        quote! {
            fn edge(&self, t: R, z: &#phase, s: &#action) -> ::core::option::Option<&'static str> {
                #parts
                #edge
            }
        }
    });
    let powers = (!domain.powers.checks.is_empty()).then(|| {
        let powers = powers(context, graph, (&domain.powers.checks, &domain.powers.arguments));
        quote! {
            const POWERS: bool = true;
            fn powers(&self, t: R, z: &#phase, s: &#action, mut visit: impl ::core::ops::FnMut(&'static str, R)) {
                #parts
                #powers
            }
        }
    });
    let poles = domain.poles.as_ref().map(|poles| poles::poles(context, graph, poles));
    let jumps = domain.jumps.as_ref().map(|jumps| poles::jumps(context, graph, jumps));
    let angles = domain.angles.as_ref().map(|found| {
        let shown = angles(context, graph, found);
        quote! {
            const ANGLES: bool = true;
            fn angles(&self, t: R, z: &#phase, s: &#action, mut visit: impl ::core::ops::FnMut(&'static str, [R; 2])) {
                #parts
                #shown
            }
        }
    });
    let examined = domain.examined.then(|| {
        quote!(
            const EXAMINED: bool = true;
        )
    });
    quote! {
        fn outside_domain(
            &self, t: R, z: &#phase, s: &#action,
        ) -> ::core::option::Option<&'static str> {
            #parts
            #outside
        }
        #parameters
        #edge
        #powers
        #examined
        #poles
        #jumps
        #angles
    }
}

/// Shows every angle with its sides y and x.
fn angles(context: &Context<'_>, graph: &Graph, angles: &Angles<Plan>) -> TokenStream {
    let printer = Printer::new(graph, context);
    context.values(&angles.sides, |values| {
        let shown = angles.all.iter().zip(values.chunks_exact(2)).map(|(angle, sides)| {
            let (what, y, x) = (printer.excerpt(*angle), &sides[0], &sides[1]);
            quote!(visit(#what, [#y, #x]);)
        });
        quote!(#(#shown)*)
    })
}

/// Shows every power with what it is a power of.
fn powers(context: &Context<'_>, graph: &Graph, (checks, arguments): (&[Check], &Plan)) -> TokenStream {
    let printer = Printer::new(graph, context);
    context.values(arguments, |values| {
        let shown = checks.iter().zip(values).map(|(check, value)| {
            let message = format!("{}: {}", check.what, printer.excerpt(check.term));
            quote!(visit(#message, #value);)
        });
        quote!(#(#shown)*)
    })
}

/// The first condition that does not hold; `rest` tests the values that belong to none.
fn first_of(
    context: &Context<'_>,
    graph: &Graph,
    (checks, arguments): (&[Check], &Plan),
    rest: impl Fn(&[Tokens]) -> TokenStream,
) -> TokenStream {
    let printer = Printer::new(graph, context);
    context.values(arguments, |mut values| {
        let mut others = values.split_off(checks.len()).into_iter();
        let tests = checks.iter().zip(values).map(|(check, value)| {
            let test = match check.if_it_is {
                Sign::Negative => quote!(.any_below(0.0)),
                Sign::NotPositive => quote!(.any_not_positive()),
                Sign::Zero => quote!(.abs().any_not_positive()),
            };
            let enough = check.enough.and_then(|_| others.next()).map(|enough| quote!(#enough.any_not_positive() &&));
            let message = format!("{}: {}", check.what, printer.excerpt(check.term));
            quote!(if #enough #value #test { return ::core::option::Option::Some(#message); })
        });
        let tests: Vec<TokenStream> = tests.collect();
        let rest = rest(others.as_slice());
        quote!(#(#tests)* #rest ::core::option::Option::None)
    })
}

//! Tests of a point: domain of definition, boundary, parameters, powers and angles.

use super::context::{Context, Values};
use super::implementation::flag;
use super::poles;
use crate::derive::{Angles, Check, Domain, Edges, Sign};
use crate::schedule::Routine;
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::ext::IdentExt;

/// Returns the items of `PhaseSpace` about the domain of the energy.
pub(super) fn domain(context: &Context<'_>, domain: &Domain) -> TokenStream {
    let (phase, parts, action) = (context.phase_type(), context.parts(), context.action_type());
    let outside = first_of(context, &domain.checks, &domain.arguments);
    let names: Vec<&Ident> = context.energy.parameters().map(|parameter| &parameter.name).collect();
    let parameters = (!names.is_empty()).then(|| {
        let shown = names.iter().map(|name| name.unraw().to_string());
        // NaN is the only value that differs from itself.
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
        let edge = first_of(context, &domain.edges.checks, &domain.edges.arguments);
        quote! {
            fn edge(&self, t: R, z: &#phase, s: &#action) -> ::core::option::Option<&'static str> {
                #parts
                #edge
            }
        }
    });
    let powers = (!domain.powers.checks.is_empty()).then(|| {
        let powers = powers(context, &domain.powers);
        quote! {
            const POWERS: bool = true;
            fn powers(&self, t: R, z: &#phase, s: &#action, mut visit: impl ::core::ops::FnMut(&'static str, R)) {
                #parts
                #powers
            }
        }
    });
    let poles = domain.poles.as_ref().map(|poles| poles::poles(context, poles));
    let jumps = domain.jumps.as_ref().map(|jumps| poles::jumps(context, jumps));
    let angles = domain.angles.as_ref().map(|found| {
        let shown = angles(context, found);
        quote! {
            const ANGLES: bool = true;
            fn angles(&self, t: R, z: &#phase, s: &#action, mut visit: impl ::core::ops::FnMut(&'static str, [R; 2])) {
                #parts
                #shown
            }
        }
    });
    let examined = domain.examined.then(|| flag("EXAMINED", true));
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

/// Returns the calls that visit every angle with its sides y and x.
fn angles(context: &Context<'_>, angles: &Angles) -> TokenStream {
    let printer = context.printer();
    context.outputs(&angles.sides, |outputs| {
        let sides = outputs.iter().flat_map(Values::rows_of_array);
        let shown = angles.all.iter().zip(sides).map(|(angle, sides)| {
            let what = printer.excerpt(*angle);
            quote!(visit(#what, #sides);)
        });
        quote!(#(#shown)*)
    })
}

/// Returns the calls that visit every power with the value of its base.
fn powers(context: &Context<'_>, Edges { checks, arguments }: &Edges) -> TokenStream {
    let printer = context.printer();
    context.outputs(arguments, |outputs| {
        let values = outputs.iter().flat_map(|values| &values.all);
        let shown = checks.iter().zip(values).map(|(check, value)| {
            let message = format!("{}: {}", check.message, printer.excerpt(check.term));
            quote!(visit(#message, #value);)
        });
        quote!(#(#shown)*)
    })
}

/// Returns the statements that return the message of the first check that applies. They read outputs of a routine: `arguments`, the matrix `damping` or
/// `friction`, and `enough`, one square of a sum of squares, which decides most tests alone.
fn first_of(context: &Context<'_>, checks: &[Check], arguments: &Routine) -> TokenStream {
    let printer = context.printer();
    context.outputs(arguments, |outputs| {
        let named = |name: &str| outputs.iter().find(|values| values.output.name == name);
        let values = |name: &str| named(name).map_or(&[][..], |values| &values.all);
        let mut enough = values("enough").iter();
        let tests = checks.iter().zip(values("arguments")).map(|(check, value)| {
            let test = match check.forbidden {
                Sign::Negative => quote!(.any_below(0.0)),
                Sign::NotPositive => quote!(.any_not_positive()),
                Sign::Zero => quote!(.abs().any_not_positive()),
            };
            let enough = check.enough.and_then(|_| enough.next()).map(|enough| quote!(#enough.any_not_positive() &&));
            let message = format!("{}: {}", check.message, printer.excerpt(check.term));
            quote!(if #enough #value #test { return ::core::option::Option::Some(#message); })
        });
        let tests: Vec<TokenStream> = tests.collect();
        let damping = named("damping").or(named("friction")).map(matrix_test);
        quote!(#(#tests)* #damping ::core::option::Option::None)
    })
}

/// Returns the statement that tests whether a matrix of damping or friction is positive semidefinite, unless the compiler has proven it.
fn matrix_test(matrix: &Values<'_>) -> TokenStream {
    if matrix.all.is_empty() {
        return TokenStream::new();
    }
    let (message, matrix) = (format!("{} that is not positive semidefinite", matrix.output.name), matrix.listed());
    quote!(if !is_positive_semidefinite(#matrix) { return ::core::option::Option::Some(#message); })
}

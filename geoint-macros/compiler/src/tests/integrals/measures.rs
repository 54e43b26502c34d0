//! Densities ρ with div(ρf) = 0.

use super::messages::{messages, messages_of};
use crate::parse::Form;
use crate::tests::expansion;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the messages for a planar field with a density.
fn refused(density: TokenStream, field: TokenStream) -> String {
    messages(quote!(measure = #density), quote! { fn f(x: [f64; 2], t: f64, k: f64) -> [f64; 2] { #field } })
}

#[test]
fn densities_of_many_kinds_are_proven() {
    for (density, field) in [
        // A density of both signs, and one with poles.
        (quote!(x[0]), quote!([x[0] * x[1], -x[1] * x[1]])),
        (quote!(1.0 / (x[0] * x[1])), quote!([x[0] * (k - x[1]), x[1] * (x[0] - 1.0)])),
        // The field reads time, the density does not.
        (quote!((x[0] + x[1] * x[1]).exp()), quote!([-2.0 * x[1] * t.sin(), t.sin()])),
        (quote!(3.0), quote!([x[1].sin() + t, x[0].exp()])),
        // The flux ρf is 2 on both sides of the surface on which both factors jump.
        (quote!(if x[0] > 0.0 { 1.0 } else { 2.0 }), quote!([if x[0] > 0.0 { 2.0 } else { 1.0 }, 0.0])),
        // The field jumps along its surface, and a switch of time moves nothing.
        (quote!(1.0), quote!([0.0, if x[0] > 0.0 { 2.0 } else { 1.0 }])),
        (quote!(1.0), quote!([if t > k { x[0] } else { -x[0] }, if t > k { -x[1] } else { x[1] }])),
        // A force with a kink.
        (quote!(1.0), quote!([x[1], -x[0].signum()])),
    ] {
        assert_eq!(refused(density.clone(), field), "", "{density}");
    }
}

#[test]
fn other_densities_are_refused() {
    for (density, field, message) in [
        (quote!(x[1]), quote!([x[0] * x[1], -x[1] * x[1]]), "div(ρf)/ρ is -2·x[1]"),
        (quote!(x[0]), quote!([x[0] * k, 1.0]), "with div f = k, ρ needs"),
        // Both factors jump, and so does their product.
        (
            quote!(if x[0] > 0.0 { 2.0 } else { 1.0 }),
            quote!([if x[0] > 0.0 { 2.0 } else { 1.0 }, 0.0]),
            "but ρf may jump there",
        ),
        // The density changes where the field leads across a moving surface.
        (quote!(1.0), quote!([if x[0] > t { 2.0 } else { 1.0 }, 0.0]), "but ρf may jump there"),
        (quote!((k * x[1].atan2(x[0])).exp()), quote!([-x[1] - k * x[0] / 2.0, x[0] - k * x[1] / 2.0]), "comes round"),
        (quote!(x[0] - x[0] + (k - k)), quote!([x[1], -x[0]]), "zero everywhere"),
        (quote!((-2.0 * k * t).exp()), quote!([k * x[0], k * x[1]]), "reads time"),
    ] {
        let found = refused(density.clone(), field);
        assert!(found.contains(message), "{density}: {found}");
    }
}

/// The action moves with the positions: with s' = −q₀ the volume of (q, s) stays, but q alone has no volume that its flow keeps.
#[test]
fn a_field_that_reads_the_action_has_no_density_of_positions() {
    let found = messages_of(
        Form::Contact,
        quote!(lift, measure = 1.0),
        quote! { fn f(q: [f64; 2], p: [f64; 2], s: f64) -> f64 { p[0] * s + p[1] * q[0] + q[0] } },
    );
    assert!(found.contains("make the action a coordinate"), "{found}");
}

#[test]
fn reports_name_the_invariant_measure() {
    let report = |form, args: TokenStream, item: TokenStream| {
        assert_eq!(messages_of(form, args.clone(), item.clone()), "");
        expansion(form, args, item)
    };
    let lift = report(
        Form::Contact,
        quote!(lift, measure = 1.0 / (q[0] * q[1])),
        quote! { fn f(q: [f64; 2], p: [f64; 2], _s: f64, a: f64, b: f64) -> f64 {
            p[0] * q[0] * (a - q[1]) + p[1] * q[1] * (q[0] - b)
        } },
    );
    assert!(lift.contains("the density ρ is kept by the flow where ρ > 0; steps keep it to their order"), "{lift}");
    assert!(!lift.contains("invariant measure where H"), "{lift}");
    let of_energy = |item| report(Form::Contact, quote!(), item);
    let steady = of_energy(quote! { fn f(q: [f64; 2], p: [f64; 2], s: f64) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0 + q[0] * q[1] + s * s
    } });
    assert!(steady.contains("|H|^−3 is the density of an invariant measure where H ≠ 0"), "{steady}");
    let driven = of_energy(quote! { fn f(q: f64, p: f64, s: f64, t: f64) -> f64 { p * p / 2.0 + q * t + s } });
    assert!(!driven.contains("invariant measure"), "{driven}");
}

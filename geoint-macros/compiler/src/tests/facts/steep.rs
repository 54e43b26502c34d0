//! Steep energies: the rounding of a coordinate at the larger end of a step changes them noticeably at the smaller end.

use super::super::lowered;
use crate::ir::Symbol;
use crate::{analyze, diff};
use proc_macro2::TokenStream;
use quote::quote;

/// Returns whether an energy with two degrees of freedom is steep.
fn is_steep(energy: TokenStream) -> bool {
    let item = quote! { fn f(q: [f64; 2], p: [f64; 2], a: f64) -> f64 { #energy } };
    let (energy, mut lowered) = lowered(item);
    let gradient = diff::gradient(&mut lowered.graph, lowered.terms.energy, energy.degrees());
    let coordinates = [Symbol::Position(0), Symbol::Position(1), Symbol::Momentum(0), Symbol::Momentum(1)];
    analyze::is_steep(&lowered.graph, &[gradient.q, gradient.p].concat(), &coordinates)
}

#[test]
fn sums_of_powers_are_nowhere_steep() {
    assert!(!is_steep(quote!(p[0] * p[0] / (2.0 * a) + 0.5 * (q[0] * q[0] - q[1] * q[1]) + p[1])));
    assert!(!is_steep(quote!(a * q[0].powi(4) + (a.sin() - 2.0) * q[1].powi(3) + 7.0)));
    assert!(!is_steep(quote!(a)));
}

#[test]
fn other_energies_may_be_steep() {
    // Two coordinates in one term, two terms of one coordinate that may cancel, and functions that are not powers of a coordinate.
    for steep in [
        quote!(q[0] * q[1]),
        quote!(q[0] * q[0] * p[1]),
        quote!(q[0] * q[0] - q[0]),
        quote!((q[0] + q[1]).powi(2)),
        quote!((q[0] - a).powi(2)),
        quote!(q[0].ln()),
        quote!(1.0 / q[0]),
        quote!(q[0].abs().sqrt()),
        quote!(p[0].exp()),
        quote!(q[0].abs()),
        quote!(q[0].powf(a)),
        quote!(if q[0] > 0.0 { q[0] * q[0] } else { 0.0 }),
    ] {
        assert!(is_steep(steep.clone()), "{steep}");
    }
}

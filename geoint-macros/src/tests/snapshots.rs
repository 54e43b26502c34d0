//! Input and pretty-printed expansion side by side. `UPDATE_EXPECT=1 cargo test -p geoint-macros` refreshes them; read the
//! difference before committing it.

use crate::attribute;
use crate::parse::Form;
use expect_test::{ExpectFile, expect_file};
use proc_macro2::TokenStream;
use quote::quote;

fn check(args: TokenStream, item: TokenStream, expected: &ExpectFile) {
    let file = syn::parse2(attribute::expand(Form::Hamiltonian, args, item)).expect("what is emitted is Rust");
    expected.assert_eq(&prettyplease::unparse(&file));
}

/// One degree of freedom, separable, quadratic T: everything is reduced to scalars.
#[test]
fn pendulum() {
    let item = quote! {
        /// Planar pendulum.
        pub fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
            p * p / (2.0 * m * l * l) - m * g * l * q.cos()
        }
    };
    check(quote!(), item, &expect_file!["snapshots/pendulum.rs"]);
}

/// A branch, explicit time, no parameters: `if` stays a branch, and T is not quadratic.
#[test]
fn branch() {
    let item = quote! {
        fn half_spring(q: f64, p: f64, t: f64) -> f64 {
            (1.0 + p * p).sqrt() + if q > 0.0 { q.powi(4) * t.cos() } else { 0.0 }
        }
    };
    check(quote!(name = Spring), item, &expect_file!["snapshots/branch.rs"]);
}

/// Coupled coordinates: kick and drift exist for no scalar, and their absence is explained.
#[test]
fn coupled() {
    let item = quote! {
        fn coupled(q: [f64; 2], p: [f64; 2]) -> f64 {
            (1.0 + q[0] * q[0]) * p[0] * p[0] + p[1] * q[1]
        }
    };
    check(quote!(), item, &expect_file!["snapshots/coupled.rs"]);
}

/// A field with an integral: both mean velocities with their derivatives.
#[test]
fn field() {
    let item = quote! {
        fn turning(x: [f64; 2], w: f64) -> [f64; 2] {
            [-w * x[1], w * x[0]]
        }
    };
    let args = quote!(keeps(radius = x[0] * x[0] + x[1] * x[1]));
    let file = syn::parse2(attribute::expand(Form::Field, args, item)).expect("what is emitted is Rust");
    expect_file!["snapshots/field.rs"].assert_eq(&prettyplease::unparse(&file));
}

//! Two expansions as reading material. The corpus compares the expansions of all functions.
//!
//! `UPDATE_EXPECT=1 cargo test -p geoint-compiler` refreshes them. Read the difference before you commit it.

use crate::attribute;
use crate::parse::Form;
use expect_test::{ExpectFile, expect_file};
use proc_macro2::TokenStream;
use quote::quote;
use syn::{Expr, Item};

/// Compares the formatted expansion with a file. The file shows the implementations of the traits `shown`, and lists the others.
fn check(form: Form, item: TokenStream, shown: &[&str], expected: &ExpectFile) {
    let mut file: syn::File = syn::parse2(attribute::expand(form, TokenStream::new(), item)).expect("Rust");
    let mut left_out = vec![];
    for item in &mut file.items {
        let Item::Const(scope) = item else { continue };
        let Expr::Block(block) = &mut *scope.expr else { continue };
        block.block.stmts.retain(|statement| match implemented(statement) {
            Some(name) if !shown.contains(&name.as_str()) => {
                left_out.push(name);
                false
            }
            _ => true,
        });
    }
    left_out.dedup();
    let left_out: String = left_out.iter().map(|name| format!("//! - {name}\n")).collect();
    let header = "//! An expansion without its implementations of these traits:\n//!\n";
    expected.assert_eq(&format!("{header}{left_out}\n{}", prettyplease::unparse(&file)));
}

/// Returns the name of the trait that a statement implements.
fn implemented(statement: &syn::Stmt) -> Option<String> {
    let syn::Stmt::Item(Item::Impl(implementation)) = statement else { return None };
    let (path, _) = implementation.trait_.as_ref()?;
    path.segments.last().map(|segment| segment.ident.to_string())
}

/// One degree of freedom, separable, and quadratic in the momentum: everything is reduced to scalars.
#[test]
fn pendulum() {
    let item = quote! {
        /// Planar pendulum.
        pub fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
            p * p / (2.0 * m * l * l) - m * g * l * q.cos()
        }
    };
    let shown = ["PhaseSpace", "Hamiltonian", "Separable", "DiscreteField"];
    check(Form::Hamiltonian, item, &shown, &expect_file!["snapshots/pendulum.rs"]);
}

/// An energy with an action, and its pieces.
#[test]
fn damped() {
    let item = quote! {
        /// A pendulum with friction.
        fn damped(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
            p * p / 2.0 - q.cos() + gamma * s
        }
    };
    let shown = ["PhaseSpace", "ContactSystem", "FlowPieces"];
    check(Form::Contact, item, &shown, &expect_file!["snapshots/damped.rs"]);
}

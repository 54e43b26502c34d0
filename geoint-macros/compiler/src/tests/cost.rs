//! The number of operations in emitted code, and the run time of the compiler.

use super::{expansion, lowered};
use crate::parse::Form;
use crate::{analyze, attribute, diff, schedule};
use proc_macro2::TokenStream;
use quote::quote;
use std::time::Instant;

fn pendulum() -> TokenStream {
    quote! {
        fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
            p * p / (2.0 * m * l * l) - m * g * l * q.cos()
        }
    }
}

fn double_pendulum() -> TokenStream {
    quote! {
        fn double_pendulum(q: [f64; 2], p: [f64; 2], m1: f64, m2: f64, l1: f64, l2: f64, g: f64) -> f64 {
            let (s, c) = (q[0] - q[1]).sin_cos();
            let numerator = m2 * l2 * l2 * p[0] * p[0] + (m1 + m2) * l1 * l1 * p[1] * p[1]
                - 2.0 * m2 * l1 * l2 * p[0] * p[1] * c;
            let denominator = 2.0 * m2 * l1 * l1 * l2 * l2 * (m1 + m2 * s * s);
            numerator / denominator - (m1 + m2) * g * l1 * q[0].cos() - m2 * g * l2 * q[1].cos()
        }
    }
}

fn outer_solar_system() -> TokenStream {
    quote! {
        fn outer_solar_system(q: [Vector3<f64>; 6], p: [Vector3<f64>; 6], m: [f64; 6], g: f64) -> f64 {
            let mut energy = 0.0;
            for i in 0..6 {
                energy += p[i].norm_squared() / (2.0 * m[i]);
                for j in 0..i {
                    energy -= g * m[i] * m[j] / (q[i] - q[j]).norm();
                }
            }
            energy
        }
    }
}

/// Returns the robot arm of `tests/lagrangian`.
fn arm_in_space() -> TokenStream {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/lagrangian/space.rs");
    let file = syn::parse_file(&std::fs::read_to_string(path).expect("the file")).expect("items");
    let arm = file.items.into_iter().find_map(|item| match item {
        syn::Item::Fn(mut item) if item.sig.ident == "arm_in_space" => {
            item.attrs.clear();
            Some(quote!(#item))
        }
        _ => None,
    });
    arm.expect("the arm")
}

#[test]
fn the_gradient_of_the_double_pendulum_is_short() {
    let (energy, mut lowered) = lowered(double_pendulum());
    let structure = analyze::structure(&mut lowered.graph, lowered.terms.energy, &energy.coordinates.shape);
    let gradient = diff::gradient(&mut lowered.graph, structure.energy, 2);
    let roots = [gradient.q, gradient.p].concat();
    let operations = schedule::statements(&mut lowered.graph, &roots).operations();
    // The best tools reach 58 to 79.
    assert!(operations.total() <= 65, "{operations:?}");
}

/// Zero entries of large matrices are emitted as one assignment of the whole matrix.
#[test]
fn sparse_matrices_are_short() {
    let item = quote! {
        fn lattice(x: [f64; 20]) -> f64 {
            x.iter().map(|x| x - x.ln() / 3.0).sum()
        }
    };
    let structure = quote!(structure = |i, j| if j == i + 1 { x[i] * x[j] } else { 0.0 });
    let text = expansion(Form::Hamiltonian, structure, item);
    let entries = text.matches("jacobian [").count();
    // Three diagonals, twice: for collocation and for discrete gradients.
    assert_eq!(entries, 2 * (20 + 2 * 19));
}

/// Each `let` opens a scope inside the previous scope, down to the end of its block. Thousands of nested scopes overflow the stack of rustc when it
/// writes debug information.
#[test]
fn scopes_are_not_nested_by_statements() {
    struct Deepest(usize);
    impl<'ast> syn::visit::Visit<'ast> for Deepest {
        fn visit_block(&mut self, block: &'ast syn::Block) {
            let scopes = block.stmts.iter().filter(|statement| matches!(statement, syn::Stmt::Local(_))).count();
            self.0 = self.0.max(scopes);
            syn::visit::visit_block(self, block);
        }
    }
    let tokens = attribute::expand(Form::Hamiltonian, quote!(), outer_solar_system());
    let file = syn::parse2(tokens).expect("items");
    let mut deepest = Deepest(0);
    syn::visit::Visit::visit_file(&mut deepest, &file);
    assert!(deepest.0 <= 8, "{} scopes in one block", deepest.0);
}

/// The iterated map has 2²⁸ paths through its graph. Each node is visited once.
#[test]
fn shared_sums_are_visited_once() {
    let item = quote! {
        fn iterated(q: f64, p: f64, a: f64) -> f64 {
            let mut x = q;
            for _ in 0..28 {
                x = a * x * (1.0 - x) + x;
            }
            p * p / 2.0 + x
        }
    };
    assert!(!expansion(Form::Hamiltonian, quote!(), item).contains("compile_error"));
}

/// Prints the time from tokens to tokens. Proc macros are built without optimisation, so this is the time that users wait.
#[test]
#[ignore = "prints times, asserts nothing about them: run it by hand"]
fn time_from_tokens_to_tokens() {
    let energies = [
        (Form::Hamiltonian, "pendulum", pendulum(), 3.6),
        (Form::Hamiltonian, "double pendulum", double_pendulum(), 11.0),
        (Form::Hamiltonian, "outer solar system", outer_solar_system(), 60.0),
        (Form::Lagrangian, "arm in space", arm_in_space(), 113.0),
    ];
    for (form, name, item, bar) in energies {
        let mut best = f64::INFINITY;
        for _ in 0..5 {
            let item = item.clone();
            let start = Instant::now();
            let tokens = attribute::expand(form, quote!(), item);
            best = best.min(start.elapsed().as_secs_f64() * 1e3);
            assert!(!tokens.to_string().contains("compile_error"));
        }
        println!("{name:20} {best:8.2} ms (aim: {bar} ms)");
    }
}

//! The length of a routine with many alike parts.

use crate::attribute;
use crate::parse::Form;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// Returns the kick of a chain of masses.
fn kick(masses: usize) -> String {
    let n = Literal::usize_unsuffixed(masses);
    let item = quote! {
        fn chain(q: [f64; N], p: [f64; N], alpha: f64) -> f64 {
            let mut energy = q[0] * q[0] / 2.0;
            for i in 0..N {
                energy += p[i] * p[i] / 2.0;
            }
            for i in 1..N {
                let d = q[i] - q[i - 1];
                energy += d * d / 2.0 + alpha * d * d * d / 3.0;
            }
            energy
        }
    };
    let args: TokenStream = quote!(const N = #n);
    let all = attribute::expand(Form::Hamiltonian, args, item).to_string();
    let begin = all.find("fn kick").expect("a kick");
    let end = all[begin..].find("fn drift").expect("a drift");
    all[begin..begin + end].to_string()
}

#[test]
fn long_chains_take_no_more_statements() {
    let (forty, eighty) = (kick(40), kick(80));
    assert!(forty.contains("from_fn") && forty.contains("for i in 0 .."), "{forty}");
    assert_eq!(forty.len(), eighty.len(), "{forty}\n{eighty}");
    // A spring takes a difference and a polynomial. Each mass is between two springs.
    assert_eq!(forty.matches(" - ").count(), 3, "{forty}");
}

#[test]
fn short_chains_have_no_loops() {
    let (eight, ten) = (kick(8), kick(10));
    assert!(!eight.contains("from_fn") && eight.len() < ten.len());
}

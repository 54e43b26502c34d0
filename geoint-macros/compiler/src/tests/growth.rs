//! Lowering must not take exponential time. A failing test does not end.

use super::expansion;
use crate::parse::Form;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns the expansion of an energy with one degree of freedom.
fn expanded(body: TokenStream) -> String {
    let item = quote! { fn h(q: f64, p: f64) -> f64 { p * p / 2.0 + { #body } } };
    expansion(Form::Hamiltonian, quote!(), item)
}

const TOO_LONG: &str = "this unrolls to more than 5000 operations";

/// Returns a chain of functions that each call the previous one: `let f1 = |x: f64| …;`, or `fn f1(x: f64) -> f64 { … }`.
fn chain(count: usize, closures: bool, call: impl Fn(TokenStream) -> TokenStream) -> TokenStream {
    let names: Vec<_> = (0..=count).map(|i| format_ident!("f{i}")).collect();
    let functions = names.iter().enumerate().map(|(i, name)| {
        let body = match i.checked_sub(1) {
            Some(before) => {
                let before = &names[before];
                call(quote!(#before))
            }
            None => quote!(x.sin()),
        };
        if closures { quote!(let #name = |x: f64| #body;) } else { quote!(fn #name(x: f64) -> f64 { #body }) }
    });
    let last = &names[count];
    quote!(#(#functions)* #last(q))
}

#[test]
fn equal_calls_are_inlined_once() {
    for closures in [true, false] {
        let found = expanded(chain(50, closures, |f| quote!(0.5 * #f(x) + 0.25 * #f(x))));
        assert!(!found.contains("compile_error"), "{closures}");
        let found = expanded(chain(20, closures, |f| quote!((2.0 + #f(x)).sqrt() + 1.0 / #f(x))));
        assert!(!found.contains("compile_error"), "{closures}");
    }
}

#[test]
fn calls_with_other_arguments_have_a_limit() {
    for closures in [true, false] {
        let found = expanded(chain(50, closures, |f| quote!(#f(x) + #f(x * 3.0) + #f(x * x))));
        assert_eq!(found.matches(TOO_LONG).count(), 1, "{closures}: {found}");
        let found = expanded(chain(50, closures, |f| quote!(#f(0.5 * #f(x)))));
        assert_eq!(found.matches(TOO_LONG).count(), 1, "{closures}: {found}");
    }
}

/// Calls with different captured variables are different calls.
#[test]
fn closures_of_other_variables_are_other_calls() {
    let found = expanded(quote!(
        let mut sum = 0.0;
        for i in 1..4 {
            let scale = i as f64;
            let f = |x: f64| scale * x;
            sum += f(q) * f(q);
        }
        sum
    ));
    assert!(found.contains("H = p²/2 + 14·q²"), "{found}");
    let mistakes = expanded(quote!(
        let f = |x: f64| x.foo();
        f(q) + f(q)
    ));
    assert!(mistakes.contains("compile_error"), "{mistakes}");
}

/// The search for common factors of a sum does not take cubic time.
#[test]
fn long_sums_are_scheduled() {
    let terms = (1..=300).map(|k| {
        let k = f64::from(k);
        quote!((#k * q).sin())
    });
    assert!(!expanded(quote!(#(#terms)+*)).contains("compile_error"));
}

/// Returns a function with `count` pieces.
fn table(count: u32) -> TokenStream {
    let pieces = (0..count).map(|k| {
        let [bound, slope] = [f64::from(k), f64::from(k) + 0.5];
        quote!(if q < #bound { #slope * q * q + #bound } else)
    });
    quote!(#(#pieces)* { 3.0 * q })
}

/// Each bound has one pair of neighbours, and one bridge serves all pieces.
#[test]
fn code_grows_with_the_number_of_pieces() {
    let [few, many] = [15, 30].map(|count| expanded(table(count)).len() as f64);
    assert!(many < 2.2 * few, "{few} {many}");
}

//! Nested input must not overflow the stack of a rustc thread, 8 MB.

use super::{holds, tokens};
use crate::parse::Form;
use crate::{lower, parse};
use proc_macro2::{Delimiter, Group, TokenTree};
use quote::quote;

/// Returns the messages for a body. Empty if the macro accepts it.
fn said(body: String) -> String {
    let run = move || {
        let item = tokens(&format!("fn energy(q: f64, p: f64) -> f64 {{ {body} }}")).expect("tokens");
        holds(Form::Hamiltonian, quote!(), item.clone());
        let energy = parse::energy(Form::Hamiltonian, quote!(), syn::parse2(item).expect("a function"));
        let energy = energy.unwrap_or_else(|errors| panic!("{:?}", errors.messages()));
        lower::body(&energy).err().map_or_else(String::new, |errors| errors.messages().join("; "))
    };
    std::thread::Builder::new().stack_size(8 << 20).spawn(run).expect("a thread").join().expect("no panic")
}

#[test]
fn long_expressions_are_accepted() {
    assert_eq!(said(vec!["q * p"; 500].join(" + ")), "");
    assert_eq!(said(format!("{}{{ p }}", "if q < 1.0 { q } else ".repeat(50))), "");
    assert_eq!(said(format!("{}q{}", "(".repeat(100), ")".repeat(100))), "");
    assert_eq!(said(format!("let x = q; {} x", "let x = x.sin() * p + (x.sin() + 1.0) * q;".repeat(45))), "");
}

#[test]
fn deep_expressions_are_refused() {
    let deep = [
        format!("{}q{}", "(".repeat(300), ")".repeat(300)),
        format!("{}q", "- ".repeat(1000)),
        format!("{}q{}", "f64::sin(".repeat(300), ")".repeat(300)),
        format!("q{}", ".cos()".repeat(300)),
        format!("{}q{}", "{ let x = ".repeat(300), "; x }".repeat(300)),
        format!("{}{{ p }}", "if q < 1.0 { q } else ".repeat(300)),
        format!("let f = |x: f64| x; {} f(q)", "let f = |x: f64| f(x) + 1.0;".repeat(300)),
        format!("let x = q; {} x", "let x = x.sin() * p + (x.sin() + 1.0) * q;".repeat(70)),
    ];
    for body in deep {
        assert!(said(body).contains("nested too deeply"));
    }
}

#[test]
fn groups_without_delimiters() {
    // `macro_rules!` passes `$x:expr` as such a group.
    let inner = TokenTree::Group(Group::new(Delimiter::None, quote!(q + 1.0)));
    holds(Form::Hamiltonian, quote!(), quote!(fn energy(q: f64, p: f64) -> f64 { p * p * #inner }));
}

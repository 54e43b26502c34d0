//! What damping stands for, and what is known of it while compiling.

use crate::analyze::{self, Damping, Flaw};
use crate::compilation::Compilation;
use crate::ir::Reads;
use crate::parse::Form;
use crate::{attribute, parse};
use proc_macro2::TokenStream;
use quote::quote;

/// Damping of an energy with two coordinates as rows of formulas with what is known of it; or messages.
fn damping(expr: TokenStream) -> Result<(Vec<String>, Option<Damping>), Vec<String>> {
    damping_of(
        expr,
        quote! { fn f(q: [f64; 2], p: [f64; 2], t: f64, a: f64, b: [f64; 2]) -> f64 { q[0] * p[1] + t + a } },
    )
}

fn damping_of(expr: TokenStream, item: TokenStream) -> Result<(Vec<String>, Option<Damping>), Vec<String>> {
    let energy =
        parse::energy(parse::Form::Hamiltonian, quote!(damping = #expr), syn::parse2(item).expect("a function"));
    let energy = energy.map_err(|e| e.messages())?;
    let (mut compilation, terms) = Compilation::lowered(&energy).map_err(|e| e.messages())?;
    let graph = &mut compilation.graph;
    let structure = analyze::structure(graph, terms.energy, &energy.coordinates.shape);
    let damping = structure.damped(graph, terms.damping).damping;
    let printer = compilation.printer();
    let row = |row: &Vec<_>| row.iter().map(|id| printer.formula(*id)).collect::<Vec<_>>().join(", ");
    let rows = damping.iter().flat_map(|damping| damping.matrix.iter().map(row)).collect();
    Ok((rows, damping))
}

fn rows(expr: TokenStream) -> Vec<String> {
    damping(expr.clone()).unwrap_or_else(|messages| panic!("{expr}: {messages:?}")).0
}

#[test]
fn shapes() {
    assert_eq!(rows(quote!(a)), ["a, 0", "0, a"]);
    assert_eq!(rows(quote!(b)), ["b[0], 0", "0, b[1]"]);
    assert_eq!(rows(quote!([1.0, q[0] * q[0]])), ["1, 0", "0, q[0]²"]);
    assert_eq!(rows(quote!(b.map(|c| c * t))), ["t·b[0], 0", "0, t·b[1]"]);
    assert_eq!(rows(quote!([[2.0, a], [a, b[1]]])), ["2, a", "a, b[1]"]);
    assert_eq!(
        rows(quote!({
            let w = 2.0 * a;
            [[w, -a], [-a, a + a]]
        })),
        ["2·a, -a", "-a, 2·a"]
    );
    assert_eq!(rows(quote!(GAMMA)), ["GAMMA, 0", "0, GAMMA"]);
    assert!(rows(quote!([0.0, a - a])).is_empty(), "nothing is damped");
    let nested = quote! { fn f(q: [[f64; 2]; 1], p: [[f64; 2]; 1], a: f64) -> f64 { q[0][0] * p[0][1] + a } };
    for same in [quote!([[a, 2.0]]), quote!([a, 2.0]), quote!([[a, 0.0], [0.0, 2.0]])] {
        assert_eq!(damping_of(same, nested.clone()).unwrap().0, ["a, 0", "0, 2"]);
    }
}

#[test]
fn other_shapes_are_refused() {
    let refused = [
        (quote!([a]), "found an array of 1"),
        (quote!([a, a, a]), "found an array of 3"),
        (quote!([[a, a]]), "found an array of 1×2"),
        (quote!([[a], [a, a]]), "found rows of different lengths"),
        (quote!([a, [a, a]]), "found rows of different lengths"),
        (quote!([]), "found an array of 0"),
        (quote!(1), "found an integer"),
        (quote!((a, a)), "found a tuple"),
        (quote!(q[0] > 0.0), "found a condition"),
        (quote!([a, true]), "found a condition"),
        (quote!(c), "`c` is not known here"),
        (quote!(a / 0.0), "not a finite number"),
        (quote!(1.0f32), "all numbers of an energy have one type"),
    ];
    for (expr, expected) in refused {
        let messages = damping(expr.clone()).err().unwrap_or_default();
        assert!(matches!(&messages[..], [one] if one.contains(expected)), "{expr}: {messages:?}");
    }
}

#[test]
fn flaws() {
    let flaw = |expr| damping(expr).unwrap().1.unwrap().flaw;
    assert_eq!(flaw(quote!([a, -a])), None, "known only when it runs");
    assert_eq!(flaw(quote!(-a * a)), None);
    assert_eq!(flaw(quote!([a, -1e-9])), Some(Flaw::Negative(1)));
    assert_eq!(flaw(quote!(0.1 - 0.2)), Some(Flaw::Negative(0)));
    assert_eq!(flaw(quote!([[1.0, a], [a + 1.0, 1.0]])), Some(Flaw::NotSymmetric(0, 1)));
    assert_eq!(flaw(quote!([[1.0, a * t], [t * a, 1.0]])), None);
    assert_eq!(flaw(quote!([[1.0, 2.0], [2.0, 4.0]])), None);
    assert_eq!(flaw(quote!([[1.0, 0.1], [0.1, 0.01]])), None, "singular but for rounding");
    assert_eq!(flaw(quote!([[1.0, 2.0], [2.0, 3.999]])), Some(Flaw::Indefinite));
    assert_eq!(flaw(quote!([[0.0, 0.001], [0.001, 1.0]])), Some(Flaw::Indefinite));
    assert_eq!(flaw(quote!([[0.09, 0.21], [0.7 * 0.3, 0.7 * 0.7]])), None, "products of numbers are exact");
    assert_eq!(
        flaw(quote!([[1.0, 1.0], [1.0, 0.99999999999999994]])),
        Some(Flaw::Indefinite),
        "by less than an f64 shows"
    );
    assert!(damping(quote!([[1.0, 0.0], [0.0, 2.0 * a]])).unwrap().1.is_some_and(|damping| !damping.open), "diagonal");
    assert!(damping(quote!([[1.0, 0.1], [0.1, a]])).unwrap().1.is_some_and(|damping| damping.open));
    let three = quote! { fn f(q: [f64; 3], p: [f64; 3]) -> f64 { q[0] * p[0] } };
    let matrix = quote!({
        let c = -0.6;
        [[1.0, c, c], [c, 1.0, c], [c, c, 1.0]]
    });
    assert_eq!(damping_of(matrix, three).unwrap().1.unwrap().flaw, Some(Flaw::Indefinite), "blocks of two are fine");
}

#[test]
fn what_is_read() {
    let reads = |expr| damping(expr).unwrap().1.unwrap().reads;
    assert_eq!(reads(quote!(a)), Reads::default());
    assert_eq!(reads(quote!([a, p[0] * p[0]])), Reads { p: true, ..Reads::default() });
    assert_eq!(reads(quote!([[a, t], [t, q[1]]])), Reads { q: true, t: true, ..Reads::default() });
}

/// Variables and assignments of the body are its own.
#[test]
fn the_body_is_not_seen() {
    let item = quote! { fn f(q: f64, p: f64, mut a: f64) -> f64 { a += 1.0; let b = a; q * p + b } };
    assert_eq!(damping_of(quote!(a), item.clone()).unwrap().0, ["a"]);
    assert!(damping_of(quote!(b), item).is_err());
}

/// Groups within groups would overflow the stack of a parser.
#[test]
fn nesting() {
    let deep = (0..5000).fold(quote!(1.0), |inner, _| quote!((#inner)));
    let item = quote! { fn f(q: f64, p: f64) -> f64 { q * p } };
    let expanded = attribute::expand(Form::Hamiltonian, quote!(damping = #deep), item).to_string();
    assert!(expanded.contains("nested too deeply"));
}

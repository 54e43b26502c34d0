//! Damping matrices: their shapes, and the facts known at compile time.

use crate::analyze::{self, Damping, Flaw};
use crate::compilation::Compilation;
use crate::ir::Reads;
use crate::parse;
use crate::parse::Form;
use crate::tests::expansion;
use proc_macro2::TokenStream;
use quote::quote;

/// The damping matrix as rows of formulas, and its facts. There are none if nothing is damped.
struct Found {
    rows: Vec<String>,
    damping: Option<Damping>,
}

/// Returns the damping of an energy with two coordinates. Errors: messages.
fn damping(expr: TokenStream) -> Result<Found, Vec<String>> {
    damping_of(
        expr,
        quote! { fn f(q: [f64; 2], p: [f64; 2], t: f64, a: f64, b: [f64; 2]) -> f64 { q[0] * p[1] + t + a } },
    )
}

/// Returns the damping of an energy. Errors: messages.
fn damping_of(expr: TokenStream, item: TokenStream) -> Result<Found, Vec<String>> {
    let energy = parse::energy(Form::Hamiltonian, quote!(damping = #expr), syn::parse2(item).expect("a function"));
    let energy = energy.map_err(|e| e.messages())?;
    let (mut compilation, terms) = Compilation::lowered(&energy).map_err(|e| e.messages())?;
    let graph = &mut compilation.graph;
    let structure = analyze::structure(graph, terms.energy, &energy.coordinates.shape);
    let damping = structure.damped(graph, terms.damping).damping;
    let printer = compilation.printer();
    let row = |row: &Vec<_>| row.iter().map(|id| printer.formula(*id)).collect::<Vec<_>>().join(", ");
    let rows = damping.iter().flat_map(|damping| damping.matrix.iter().map(row)).collect();
    Ok(Found { rows, damping })
}

fn rows(expr: TokenStream) -> Vec<String> {
    damping(expr.clone()).unwrap_or_else(|messages| panic!("{expr}: {messages:?}")).rows
}

#[test]
fn shapes_of_damping_matrices() {
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
        assert_eq!(damping_of(same, nested.clone()).unwrap().rows, ["a, 0", "0, 2"]);
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
fn flaws_of_damping_matrices() {
    let flaw = |expr| damping(expr).unwrap().damping.unwrap().flaw;
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
    assert!(
        damping(quote!([[1.0, 0.0], [0.0, 2.0 * a]])).unwrap().damping.is_some_and(|damping| !damping.open),
        "diagonal"
    );
    assert!(damping(quote!([[1.0, 0.1], [0.1, a]])).unwrap().damping.is_some_and(|damping| damping.open));
    let three = quote! { fn f(q: [f64; 3], p: [f64; 3]) -> f64 { q[0] * p[0] } };
    let matrix = quote!({
        let c = -0.6;
        [[1.0, c, c], [c, 1.0, c], [c, c, 1.0]]
    });
    assert_eq!(
        damping_of(matrix, three).unwrap().damping.unwrap().flaw,
        Some(Flaw::Indefinite),
        "blocks of two are fine"
    );
}

#[test]
fn symbols_that_a_damping_reads() {
    let reads = |expr| damping(expr).unwrap().damping.unwrap().reads;
    assert_eq!(reads(quote!(a)), Reads::default());
    assert_eq!(reads(quote!([a, p[0] * p[0]])), Reads { p: true, ..Reads::default() });
    assert_eq!(reads(quote!([[a, t], [t, q[1]]])), Reads { q: true, t: true, ..Reads::default() });
}

/// The damping reads the arguments of the function, not the variables and assignments of its body.
#[test]
fn variables_of_the_body_are_not_in_scope() {
    let item = quote! { fn f(q: f64, p: f64, mut a: f64) -> f64 { a += 1.0; let b = a; q * p + b } };
    assert_eq!(damping_of(quote!(a), item.clone()).unwrap().rows, ["a"]);
    assert!(damping_of(quote!(b), item).is_err());
}

/// Deeply nested groups would overflow the stack of a parser.
#[test]
fn deep_nesting_is_refused() {
    let deep = (0..5000).fold(quote!(1.0), |inner, _| quote!((#inner)));
    let item = quote! { fn f(q: f64, p: f64) -> f64 { q * p } };
    let expanded = expansion(Form::Hamiltonian, quote!(damping = #deep), item);
    assert!(expanded.contains("nested too deeply"));
}

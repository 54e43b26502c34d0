//! Structural facts about energies, and the term that contradicts a fact.

use super::super::lowered;
use crate::analyze::{self, Split, Structure};
use crate::ir::Symbol;
use crate::ir::print::Printer;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the structure, and the term that contradicts separability or a quadratic kinetic energy.
fn structure(item: TokenStream) -> (Structure, Option<String>) {
    let (energy, mut lowered) = lowered(item);
    let structure = analyze::structure(&mut lowered.graph, lowered.terms.energy, &energy.coordinates.shape);
    let witness = match &structure.split {
        Split::Coupled(term) => Some(*term),
        Split::Separable(parts) => parts.not_quadratic,
    };
    let name = |symbol| match symbol {
        Symbol::Position(i) => format!("q{i}"),
        Symbol::Momentum(i) => format!("p{i}"),
        Symbol::Action => "s".into(),
        Symbol::Time => "t".into(),
        _ => "c".into(),
    };
    let printer = Printer::new(&lowered.graph, &name);
    let witness = witness.map(|term| printer.formula(term));
    (structure, witness)
}

#[test]
fn separable_with_quadratic_t() {
    let energies = [
        quote! { fn f(q: f64, p: f64, k: f64) -> f64 { k * (p * p + q.sin()) } },
        quote! { fn f(q: f64, p: f64, k: f64) -> f64 { (p - k).powi(2) / k - q.exp() * 2.0 } },
        quote! { fn f(q: [f64; 2], p: [f64; 2], t: f64) -> f64 { p[0] * p[1] + 3.0 * p[0] + q[0] * q[1] * t } },
        quote! { fn f(q: [f64; 2], p: [f64; 2]) -> f64 { ((p[0] * p[0] + p[1] * p[1]).sqrt().powi(2) + 1.0) / 2.0 - (q[0] - q[1]) } },
    ];
    for item in energies {
        let (structure, witness) = structure(item.clone());
        assert!(structure.quadratic_parts().is_some(), "{item}: {witness:?}");
    }
}

#[test]
fn separable_but_not_quadratic() {
    let energies = [
        (quote! { fn f(q: f64, p: f64) -> f64 { p * p / 2.0 + p.powi(4) + q } }, "p0⁴"),
        (quote! { fn f(q: f64, p: f64) -> f64 { (1.0 + p * p).sqrt() + q } }, "√(p0² + 1)"),
        (quote! { fn f(q: f64, p: f64, t: f64) -> f64 { p * p * t + q } }, "p0²·t"),
        (
            quote! { fn f(q: f64, p: f64) -> f64 { q + if p > 0.0 { p * p } else { p } } },
            "if 0 < p0 { p0² } else { p0 }",
        ),
    ];
    for (item, term) in energies {
        let (structure, witness) = structure(item);
        assert!(structure.parts().is_some());
        assert_eq!(witness.as_deref(), Some(term));
    }
}

#[test]
fn coupled_terms_are_named() {
    let energies = [
        (quote! { fn f(q: f64, p: f64) -> f64 { p * p / 2.0 + q * p + q } }, "q0·p0"),
        (quote! { fn f(q: f64, p: f64, k: f64) -> f64 { k * (p * p + (q - p).cos()) } }, "c·cos(q0 - p0)"),
        (quote! { fn f(q: f64, p: f64) -> f64 { p * p * (1.0 + q) } }, "p0²·(q0 + 1)"),
    ];
    for (item, term) in energies {
        let (structure, witness) = structure(item);
        assert!(structure.parts().is_none());
        assert_eq!(witness.as_deref(), Some(term));
    }
}

#[test]
fn coordinates_that_are_not_read_and_time() {
    let (structure, _) = structure(quote! {
        fn f(q: [f64; 3], p: [f64; 3], t: f64) -> f64 { p[0] * p[0] + p[2] * p[2] / (1.0 + q[0] * q[0]) + t * 0.0 }
    });
    assert_eq!(structure.cyclic, [1, 2]);
    assert_eq!(structure.resting, [1]);
    assert!(structure.autonomous, "a vanishing term reads nothing");
}

#[test]
fn degrees() {
    let degree = |item| structure(item).0.degree;
    assert_eq!(degree(quote! { fn f(q: f64, p: f64, k: f64) -> f64 { p * p + k.sin() * q * q * p } }), Some(3));
    assert_eq!(degree(quote! { fn f(q: f64, p: f64) -> f64 { p * p / q } }), None);
    assert_eq!(degree(quote! { fn f(q: f64, p: f64) -> f64 { (p * p + q * q).sqrt().powi(4) } }), Some(4));
}

/// The graph identifies equal expressions of different spelling. It does not expand products.
#[test]
fn simplification() {
    let formula = |item| {
        let (_, lowered) = lowered(item);
        let name = |symbol| match symbol {
            Symbol::Position(_) => "q".to_owned(),
            Symbol::Momentum(_) => "p".into(),
            _ => "c".into(),
        };
        Printer::new(&lowered.graph, &name).formula(lowered.terms.energy)
    };
    assert_eq!(formula(quote! { fn f(q: f64, p: f64) -> f64 { (q + p) - (p + q) } }), "0");
    assert_eq!(formula(quote! { fn f(q: f64, p: f64) -> f64 { q * p / (p * q) } }), "1");
    assert_eq!(formula(quote! { fn f(q: f64, p: f64) -> f64 { q.sqrt() * q.sqrt() * p / q } }), "p");
    assert_eq!(formula(quote! { fn f(q: f64, p: f64) -> f64 { (q * q).sqrt() + p * 0.0 } }), "√(q²)");
    assert_eq!(formula(quote! { fn f(q: f64, p: f64) -> f64 { (q - p).powi(2) - (p - q).powi(2) } }), "0");
    assert_eq!(formula(quote! { fn f(q: f64, p: f64) -> f64 { (q - p).cos() - (p - q).cos() } }), "0");
    assert_eq!(formula(quote! { fn f(q: f64, p: f64) -> f64 { (q - p).sin() + (p - q).sin() } }), "0");
    assert_eq!(formula(quote! { fn f(q: f64, p: f64) -> f64 { 3.0 * (q + p) / 2.0 } }), "3·(q + p)/2");
    assert_eq!(formula(quote! { fn f(q: f64, p: f64) -> f64 { 0.1 + 0.2 - 0.3 + q - p } }), "q - p");
}

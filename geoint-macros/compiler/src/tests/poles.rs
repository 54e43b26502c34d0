//! The poles of energies, and the expressions that vanish there.

use super::{expansion, lowered};
use crate::analyze::{Pole, Quick, poles};
use crate::ir::print::Printer;
use crate::ir::{Graph, Id, Symbol};
use crate::parse::Form;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the expressions that vanish at the poles of a potential. The notation is `±x` for a test of the sign, `{x, y}` for forms that vanish
/// together, `∠x` for an angle, and `?x` for interval arithmetic. Parentheses mark expressions that divided differences do not notice.
fn found(potential: TokenStream) -> Vec<String> {
    let (_, mut lowered) = lowered(quote! {
        fn f(q: [f64; 2], p: [f64; 2], t: f64, m: f64, k: f64) -> f64 {
            let ([x, y], r2) = (q, q[0] * q[0] + q[1] * q[1]);
            (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + #potential
        }
    });
    let poles = poles(&mut lowered.graph, &[lowered.terms.energy], &lowered.terms.partial);
    poles.iter().map(|pole| described(&lowered.graph, pole)).collect()
}

/// Describes a pole in the notation of `found`.
fn described(graph: &Graph, pole: &Pole) -> String {
    let name = |symbol| match symbol {
        Symbol::Position(i) => ["x", "y"][i as usize].into(),
        Symbol::Time => "t".into(),
        Symbol::Parameter(i) => ["m", "k"][i as usize].into(),
        _ => "p".to_string(),
    };
    let printer = Printer::new(graph, &name);
    let all = |ids: &[Id]| ids.iter().map(|id| printer.formula(*id)).collect::<Vec<_>>().join(", ");
    let text = match &pole.quick {
        Some(Quick::Forms(forms, signs)) => {
            let signs = [&signs.positive[..], &signs.not_negative[..]].concat();
            let assumed = if signs.is_empty() { String::new() } else { format!(" if {}", all(&signs)) };
            if forms.len() == 1 { format!("±{}{assumed}", all(forms)) } else { format!("{{{}}}{assumed}", all(forms)) }
        }
        Some(Quick::Angle { argument, .. }) => format!("∠{}", printer.formula(*argument)),
        Some(Quick::SineOf { .. }) => panic!("not built"),
        None => format!("?{}", printer.formula(pole.vanishes)),
    };
    if pole.noticed { text } else { format!("({text})") }
}

#[test]
fn poles_follow_from_the_structure() {
    let table: &[(TokenStream, &[&str])] = &[
        (quote!(k / x), &["±x"]),
        (quote!(k / (x * x)), &["±x"]),
        (quote!(k / (x - y)), &["±x - y"]),
        // Divided differences read the time at the middle only.
        (quote!(k / (t - x)), &["(±t - x)"]),
        (quote!(k / x.abs()), &["(±x)"]),
        (quote!(k / (x * x).sqrt()), &["(±x)"]),
        (quote!((x * x).ln() + (y - k).abs().ln()), &["(±x)", "(±y - k)"]),
        (quote!((x * x).powf(-0.3)), &["(±x)"]),
        (quote!(x.tan()), &["∠x"]),
        (quote!(x.cos().ln()), &["∠x"]),
        (quote!(r2.powf(k)), &["({x, y})"]),
        (quote!(k / x.sin().powi(2)), &["∠x"]),
        (quote!(k / (1.0 - x.cos())), &["(∠x/2)"]),
        (quote!(k / (1.0 - x.cos().powi(2))), &["(∠x)"]),
        (quote!(k / (x.cosh() - 1.0)), &["(±x)"]),
        (quote!(k / (1.0 - (-x * x).exp())), &["(±x)"]),
        (quote!(k / r2.sqrt()), &["({x, y})"]),
        (quote!(k / x.hypot(y - 1.0)), &["({x, y - 1})"]),
        (quote!(k / (r2 + m)), &["({x, y} if m)"]),
        (quote!(k / (x * x + m * y * y)), &["({x, y} if m)"]),
        (quote!(k / (x * (x - y))), &["(±x)", "(±x - y)"]),
    ];
    for (potential, expected) in table {
        let (mut found, mut expected) = (found(potential.clone()), expected.to_vec());
        found.sort();
        expected.sort();
        assert_eq!(found, expected, "{potential}");
    }
}

#[test]
fn other_poles_are_tested_by_intervals() {
    let energies = [
        quote!(k / (1.0 - x * x)),
        quote!(k / (x * x - 2.0 * x + 1.0)),
        quote!(k / (m + x * y)),
        quote!(k / (x.sin() + y)),
        quote!(1.0 / (m + k * x.sin().powi(2))),
        quote!(if x < 1.0 { 1.0 / (x * x - y * y * y) } else { 0.0 }),
    ];
    for potential in energies {
        let found = found(potential.clone());
        assert!(found.len() == 1 && (found[0].contains('?') || found[0].contains(" if ")), "{potential}: {found:?}");
    }
}

/// The denominator does not vanish, does not move, or vanishes at the end of a domain only.
#[test]
fn energies_without_poles() {
    let energies = [
        quote!(x * x / (m - k)),
        quote!(1.0 / (2.0 + x.cos()) + y / x.exp() + 1.0 / y.cosh() + 1.0 / (1.0 + x * x).sqrt()),
        quote!(x.ln() + y.sqrt().recip() + (x * x).powf(0.3)),
        quote!(x.abs() + x.cbrt() + x.atan2(y)),
    ];
    for potential in energies {
        assert_eq!(found(potential.clone()), Vec::<String>::new(), "{potential}");
    }
}

/// The straight line between two points of a domain may leave the domain, unless the bounded expression is concave.
#[test]
fn ends_of_domains() {
    let table: &[(TokenStream, &[&str])] = &[
        (quote!((x * x - 1.0).sqrt()), &["(?x² - 1)"]),
        (quote!((x * x - k).sqrt() * (x * x - k).sqrt()), &["(?x² - k)"]),
        (quote!((x * y).powf(1.5)), &["(?x·y)"]),
        (quote!((x * x - 2.0).asin()), &["(?(x² - 2) + 1)"]),
        (quote!((x * x - 2.0).acos()), &["(?(x² - 2) + 1)"]),
        (quote!(r2.acosh()), &["(?x² + y² - 1)"]),
        (quote!((1.0 - x * x - y * y).sqrt() + (2.0 - x.cosh() - y.abs()).sqrt()), &[]),
        (quote!((1.0 - r2 / (k * k)).ln() + (x - 3.0).acosh() + y.asin()), &[]),
        (quote!((x * x - 1.0).sqrt().recip()), &["(?x² - 1)"]),
    ];
    for (potential, expected) in table {
        assert_eq!(found(potential.clone()), *expected, "{potential}");
    }
}

/// If kicks outside of the domain give momenta that are not finite, the end of a step needs no test.
#[test]
fn kicks_show_vanishing_denominators() {
    let shows = |potential: TokenStream| {
        let item = quote! {
            fn f(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
                let [x, y] = q;
                (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + #potential
            }
        };
        expansion(Form::Hamiltonian, TokenStream::new(), item).contains("showing_domain")
    };
    assert!(shows(quote!(k * x * x)));
    assert!(shows(quote!(k / (x * x + y * y).sqrt())));
    assert!(shows(quote!(k / (x * x + y * y).powi(6) - m / (x * x + y * y).powi(3))));
    assert!(shows(quote!(k / (x + y).sqrt())));
    // ∞·0.
    assert!(shows(quote!((-k / (x * x)).exp())));
    // The kick is k/x, for negative x too.
    assert!(!shows(quote!(k * x.ln())));
    assert!(!shows(quote!((x * y).sqrt() * (x * y).sqrt())));
    // The kick divides on one side only.
    assert!(!shows(quote!(if y > 1.0 { k / x } else { 0.0 })));
}

//! Where energies are infinite, and what changes its sign there.

use super::lowered;
use crate::analyze::poles;
use crate::ir::Symbol;
use crate::ir::print::Printer;
use proc_macro2::TokenStream;
use quote::quote;

/// What vanishes at the poles of a potential, in parentheses where divided differences do not notice.
fn found(potential: TokenStream) -> Vec<String> {
    let (_, mut lowered) = lowered(quote! {
        fn f(q: [f64; 2], p: [f64; 2], t: f64, m: f64, k: f64) -> f64 {
            let ([x, y], r2) = (q, q[0] * q[0] + q[1] * q[1]);
            (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + #potential
        }
    });
    let nodes = lowered.graph.reachable(&[lowered.energy]);
    let poles = poles(&mut lowered.graph, &nodes);
    let name = |symbol| match symbol {
        Symbol::Q(i) => ["x", "y"][i as usize].into(),
        Symbol::T => "t".into(),
        Symbol::Parameter(i) => ["m", "k"][i as usize].into(),
        _ => "p".to_string(),
    };
    let printer = Printer::new(&lowered.graph, name);
    let text = |formula: String, hidden| if hidden { format!("({formula})") } else { formula };
    poles.iter().map(|pole| text(printer.formula(pole.vanishes), pole.hidden)).collect()
}

#[test]
fn poles_have_two_sides() {
    let table: &[(TokenStream, &[&str])] = &[
        (quote!(k / x), &["x"]),
        (quote!(k / (x * x)), &["x"]),
        (quote!(k / (x - y)), &["x - y"]),
        (quote!(k / (1.0 - x * x)), &["-x² + 1"]),
        (quote!(k / (t - x)), &["t - x"]),
        (quote!(k / x.abs()), &["(x)"]),
        (quote!(k / (x * x).sqrt()), &["(x)"]),
        (quote!((x * x).ln() + (y - k).abs().ln()), &["(x)", "(y - k)"]),
        (quote!((x * x).powf(-0.3)), &["(x)"]),
        (quote!(x.tan()), &["cos(x)"]),
    ];
    for (potential, expected) in table {
        assert_eq!(found(potential.clone()), *expected, "{potential}");
    }
}

/// No sides, nothing that moves, or an edge of the domain.
#[test]
fn no_poles() {
    let energies = [
        quote!(k / r2.sqrt()),
        quote!(k / (m + r2)),
        quote!(x * x / (m - k)),
        quote!(1.0 / (m + k * x.sin().powi(2)) + y / x.exp() + 1.0 / y.cosh()),
        quote!(x.ln() + y.sqrt().recip() + (x * x).powf(0.3)),
        quote!(x.abs() + x.cbrt() + x.atan2(y)),
    ];
    for potential in energies {
        assert_eq!(found(potential.clone()), Vec::<String>::new(), "{potential}");
    }
}

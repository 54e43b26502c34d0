//! Equal expressions are recognised in all spellings, and different expressions are not taken for equal.

use super::super::super::lowered;
use crate::analyze::{Remainder, identity};
use crate::ir::print::Printer;
use crate::ir::{Graph, Id, Symbol};
use proc_macro2::TokenStream;
use quote::quote;

/// A body as a graph, with its root. Arguments are q, p, and parameters a, b, c, m; k is a constant from outside.
fn body(body: &TokenStream) -> (Graph, Id) {
    let (_, lowered) = lowered(quote! {
        fn energy(q: [f64; 2], p: [f64; 2], a: f64, b: f64, c: f64, m: f64) -> f64 { let (x, y) = (q[0], q[1]); #body }
    });
    (lowered.graph, lowered.terms.energy)
}

fn name(symbol: Symbol) -> String {
    match symbol {
        Symbol::Position(i) => ["x", "y"][i as usize].into(),
        Symbol::Momentum(i) => format!("p{i}"),
        Symbol::Parameter(i) => ["a", "b", "c", "m", "k"][i as usize].into(),
        other => format!("{other:?}"),
    }
}

/// "0", or the remainder and its case.
fn difference(one: &TokenStream, other: &TokenStream) -> String {
    let (mut graph, root) = body(&quote!((#one) - (#other)));
    let verdict = identity(&mut graph, root);
    match verdict.rest() {
        _ if verdict.is_zero() => "0".into(),
        Some(Remainder { rest, case, certain }) => {
            let printer = Printer::new(&graph, &name);
            let case: Vec<String> = case
                .iter()
                .map(|(id, holds)| format!(" {} {}", if *holds { "if" } else { "unless" }, printer.excerpt(*id)))
                .collect();
            format!("{}{}{}", printer.excerpt(*rest), case.concat(), if *certain { "" } else { " (?)" })
        }
        None => "too long".into(),
    }
}

macro_rules! pairs {
    ($($one:expr, $other:expr;)*) => { [$((quote!($one), quote!($other))),*] };
}

#[test]
fn equal_expressions_are_seen_however_they_are_written() {
    let pairs = pairs! {
        (a + b) * (a + b), a * a + 2.0 * a * b + b * b;
        (x - y).powi(4), (x * x - 2.0 * x * y + y * y).powi(2);
        x / (2.0 * m), 0.5 * x / m;
        x / (2.0 * m), x * (1.0 / (m + m));
        (x * x - y * y) / (x - y), x + y;
        1.0 / (x - y) - 1.0 / (x + y), 2.0 * y / (x * x - y * y);
        1.0 / (1.0 + 1.0 / x), x / (x + 1.0);
        1.0 / (2.0 * a + 2.0 * b), 0.5 / (b + a);
        a / (x / y), a * y / x;
        (a * x + b * x) / (a + b) / x, 1.0;
        0.1 * x + 0.2 * x, 0.3 * x;
        6.674e-11 * (a + b) * x, 6.674e-11 * a * x + x * 6.674e-11 * b;
        1.380649e-23 * (2.0 * x + 3.0 * y), 3.0 * 1.380649e-23 * y + 2.0 * x * 1.380649e-23;
        p[0] * p[0] / (2.0 * 9.109e-31), 0.5 / 9.109e-31 * p[0].powi(2);
        6.62607015e-34 * x * (a - b), 6.62607015e-34 * a * x - 6.62607015e-34 * b * x;
        std::f64::consts::PI * (3.0 * x + y), std::f64::consts::PI * y + 3.0 * std::f64::consts::PI * x;
        std::f64::consts::PI * (std::f64::consts::PI * x), std::f64::consts::PI.powi(2) * x;
        -m * a * b * (x.cos() - 1.0), m * a * b * (1.0 - x.cos());
        (x - y).sin(), -(y - x).sin();
        (2.0 * (x - y)).cos(), (2.0 * y - 2.0 * x).cos();
        (a * (x + y)).sin(), (x * a + y * a).sin();
        x.sin().powi(2), 1.0 - x.cos() * x.cos();
        x.tan().powi(2) + 1.0, 1.0 / (x.cos() * x.cos());
        x.sin().powi(4) - x.cos().powi(4), x.sin().powi(2) - x.cos().powi(2);
        (x + y).exp(), x.exp() * y.exp();
        (x / 2.0).exp().powi(2), x.exp();
        (-x).exp() * (x + 1.5 * y).exp(), (3.0 * y).exp().sqrt();
        x.exp_m1(), x.exp() - 1.0;
        2.0 * x.cosh() * x.sinh(), (2.0 * x).sinh();
        x.tanh(), (x.exp() - (-x).exp()) / (x.exp() + (-x).exp());
        (1.0 - (-x).exp()).powi(2), 1.0 - 2.0 * (-x).exp() + (-2.0 * x).exp();
        (x * x + y * y).sqrt(), x.hypot(y);
        1.0 / (x * x + y * y).sqrt(), (x * x + y * y).sqrt() / (x * x + y * y);
        (4.0 * x * x + 4.0 * y * y).sqrt(), 2.0 * x.hypot(y);
        (x * x + 2.0 * x * y + y * y).sqrt(), (x + y).abs();
        x * x.abs() * x.abs(), x.powi(3);
        (x * x).sqrt(), x.abs();
        (x.sqrt() + a).powi(2), x + 2.0 * a * x.sqrt() + a * a;
        x.powf(1.5), x * x.sqrt();
        x.powf(0.3) * x.powf(0.7), x;
        x.cbrt().powi(3), x;
        x.cbrt().powi(4) / x, x.cbrt();
        x.min(y) + x.max(y), x + y;
        x.max(y) - x.min(y), (x - y).abs();
        x.ln_1p(), (1.0 + x).ln();
        (x - 5.0).ln() * a, a * (-5.0 + x).ln();
        if x < 0.0 { a * x } else { b * x }, x * if x < 0.0 { a } else { b };
        if x < 0.0 { a } else { b }, if 0.0 <= x { b } else { a };
        if x < 0.0 { a } else { b }, if 2.0 * x < 0.0 { a } else { b };
        if x < 0.0 { a } else { 0.0 } + if x >= 0.0 { b } else { 0.0 }, if x < 0.0 { a } else { b };
        if x < 0.0 { a } else if x > 1.0 { b } else { c }, if x > 1.0 { b } else if x < 0.0 { a } else { c };
        if x < y { if y < 1.0 { a } else { b } } else { b }, if x < y && y < 1.0 { a } else { b };
        if !(x < 0.0) || y < 0.0 { a } else { b }, if x < 0.0 && y >= 0.0 { b } else { a };
        (if x < 0.0 { a } else { b }).powi(2), if x < 0.0 { a * a } else { b * b };
        (2.0 * x).sin(), 2.0 * x.sin() * x.cos();
        (x - y).cos(), x.cos() * y.cos() + x.sin() * y.sin();
        1.0 / (if x < 0.0 { a } else { x }) , if x < 0.0 { 1.0 / a } else { 1.0 / x };
    };
    for (one, other) in pairs {
        assert_eq!(difference(&one, &other), "0", "{one} against {other}");
    }
}

#[test]
fn what_is_left_is_named() {
    let cases = [
        (quote!(x * y - 6.674e-11 * a * x.cos()), quote!(x * y), "-6.674e-11·a·cos(x)"),
        (quote!(x + (x - 5.0).ln()), quote!(x), "ln(x - 5)"),
        (quote!(x + if x < 0.0 { 100.0 * x * x } else { 0.0 }), quote!(x), "100·x² if x < 0"),
        (quote!(x + if x < 0.0 && y < a { y } else { 0.0 }), quote!(x), "y if x < 0 if y < a"),
        (quote!(x + a * y), quote!(x + 2.0 * a * y), "-y·a"),
        (quote!(0.5 * x * x + 1e-20 * x * x), quote!(0.5 * x * x), "1e-20·x²"),
        (quote!((x + y).powi(2)), quote!(x * x + y * y), "2·x·y"),
        (quote!((1e-300 * x).sin()), quote!(0.0), "sin(1e-300·x)"),
        (quote!(x + TINY), quote!(x), "k"),
        (quote!((a * x).sin()), quote!((b * x).sin()), "sin(x·a) - sin(x·b) (?)"),
        // These hold for one sign only.
        (quote!((x * x).sqrt()), quote!(x), "√(x²) - x (?)"),
        (quote!(x.sqrt() * y.sqrt()), quote!((x * y).sqrt()), "√x·√y - √(x·y) (?)"),
        // A zero denominator in one branch is no proof for the other one.
        (quote!(if x < 0.0 { a / (x.abs() - x) } else { x.abs() + x + b }), quote!(a / (x.abs() - x)), ""),
        (quote!(x.exp() - 1.0), quote!(x), "exp(x) - x - 1 (?)"),
        // These need unknown relations.
        (quote!((2.0 * x * x + 2.0).atan()), quote!(2.0 * (x * x + 1.0).atan()), "atan(2·x² + 2) - 2·atan(x² + 1) (?)"),
        (quote!((a + b + c + m + x + y).powi(40)), quote!(x), "(x + y + a + b + c + m)⁴⁰ - x (?)"),
        (quote!((a + b + c + m).powi(7) * (a + x + y + c).powi(7) * (x + y + m).powi(9)), quote!(x), "too long"),
    ];
    for (one, other, left) in cases {
        let found = difference(&one, &other);
        assert_ne!(found, "0", "{one} against {other}");
        if !left.is_empty() {
            assert_eq!(found, left, "{one} against {other}");
        }
    }
}

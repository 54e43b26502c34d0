//! Which pieces are found of contact energies, by which rules.

use crate::ir::print::Printer;
use crate::{emit, lower, parse, split};
use proc_macro2::TokenStream;
use quote::quote;

/// The pieces as "rule: energy", sorted; or the term that is in none.
fn pieces(item: TokenStream) -> Result<Vec<String>, String> {
    let item = syn::parse2(item).expect("a function");
    let energy = parse::energy(parse::Form::Contact, quote!(), item).unwrap_or_else(|e| panic!("{:?}", e.messages()));
    let mut lowered = lower::body(&energy).unwrap_or_else(|e| panic!("{:?}", e.messages()));
    let found = split::pieces(&mut lowered.graph, lowered.energy, energy.degrees(), None);
    let context = emit::Context::new(&energy, &lowered.constants, &lowered.partial);
    let printer = Printer::new(&lowered.graph, |symbol| context.user_name(symbol));
    let mut found: Vec<String> = found
        .map_err(|term| printer.formula(term))?
        .iter()
        .map(|piece| format!("{} ({:?}): {}", piece.rule.name, piece.clock, printer.formula(piece.energy)))
        .collect();
    found.sort();
    Ok(found)
}

#[test]
fn show_flows() {
    for item in [
        quote! { fn f(q: f64, p: f64, s: f64) -> f64 { p * p * s / 2.0 } },
        quote! { fn f(q: f64, p: f64, s: f64) -> f64 { p * p * (2.0 + s) / 2.0 } },
        quote! { fn f(q: f64, p: f64, s: f64) -> f64 { q * q * p * p / 2.0 } },
        quote! { fn f(q: f64, p: f64, s: f64) -> f64 { p * p / 1.4 * (0.8 * s).cosh() } },
        quote! { fn f(q: f64, p: f64, s: f64) -> f64 { p * p / 1.4 * (0.8 * s).exp() } },
        quote! { fn f(q: f64, p: f64, s: f64) -> f64 { p * p + q * q + s } },
        quote! { fn f(q: f64, p: f64, s: f64) -> f64 { q.cos() * s } },
    ] {
        let item = syn::parse2(item).expect("a function");
        let energy = parse::energy(parse::Form::Contact, quote!(), item).unwrap_or_else(|e| panic!("{:?}", e.messages()));
        let mut lowered = lower::body(&energy).unwrap_or_else(|e| panic!("{:?}", e.messages()));
        let found = split::pieces(&mut lowered.graph, lowered.energy, energy.degrees(), None).unwrap();
        let context = emit::Context::new(&energy, &lowered.constants, &lowered.partial);
        let changed: Vec<_> = found.iter().map(|piece| piece.flow.changed(&mut lowered.graph)).collect();
        let printer = Printer::new(&lowered.graph, |symbol| if symbol == crate::ir::Symbol::H { "h".into() } else { context.user_name(symbol) });
        for (piece, changed) in found.iter().zip(changed) {
            println!("{} {}", piece.rule.name, printer.formula(piece.energy));
            for (symbol, end) in changed {
                println!("   {} = {}", printer.formula(lowered.graph.clone().symbol(symbol)), printer.formula(end));
            }
        }
    }
    panic!();
}

#[test]
fn show() {
    for item in [
        quote! { fn f(q: f64, p: f64, s: f64) -> f64 { q * (0.6 * s).exp() + q * q } },
        quote! { fn f(q: f64, p: f64, s: f64) -> f64 { p * p / 1.4 * (0.8 * s).cosh() } },
        quote! { fn f(q: f64, p: f64, s: f64, g: f64) -> f64 { p * p / 2.0 - q.cos() + g * s } },
        quote! { fn f(q: [f64; 2], p: [f64; 2], s: f64, t: f64, a: f64, w: f64) -> f64 {
            (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt() + a * (w * t).sin() * s } },
        quote! { fn f(q: f64, p: f64, s: f64, t: f64) -> f64 { p * p / 2.0 + 2.0 / t * s + q.powi(6) / 6.0 } },
        quote! { fn f(q: f64, p: f64, s: f64, e: f64) -> f64 { p * s - e * (1.0 - q * q) * s + q } },
        quote! { fn f(q: f64, p: f64, s: f64, r: f64) -> f64 { (p * p + q * q + s * s) / 2.0 - r } },
        quote! { fn f(q: f64, p: f64, s: f64, a: f64) -> f64 { p * p / 2.0 + q * q / 2.0 + a * s * s / 2.0 } },
        quote! { fn f(q: f64, p: f64, s: f64) -> f64 { (p * p / 2.0 - q.cos()) * (0.6 * s).exp() } },
        quote! { fn f(q: f64, p: f64, s: f64, t: f64, a: f64, l: f64, w: f64, e: f64, m: f64, c: [f64; 7]) -> f64 {
            let size = 1.0 + l * (w * t).cos();
            let mut v = 0.0;
            for i in 0..7 { v += c[i] * (2.0 * q - (i as f64 + 1.0) * t).cos(); }
            p * p / 2.0 + (-a - l * w * (w * t).sin() / size) * s - e / (2.0 * size) * v - m * q } },
        quote! { fn f(q: f64, p: f64, s: f64, c: f64) -> f64 { p * p / 2.0 + q * q / 2.0 + c * s } },
        quote! { fn f(q: [f64; 2], p: [f64; 2], s: f64) -> f64 { p[0] * (q[0] * q[1] - q[0]) + p[1] * (q[1] - q[0] * q[1]) } },
        quote! { fn f(q: [f64; 3], p: [f64; 3], s: f64) -> f64 {
            p[0] * 10.0 * (q[1] - q[0]) + p[1] * (q[0] * (28.0 - q[2]) - q[1]) + p[2] * (q[0] * q[1] - 2.7 * q[2]) } },
        quote! { fn f(q: f64, p: f64, s: f64) -> f64 { p * p / 2.0 + (q * p * s).sin() + q } },
    ] {
        println!("{:#?}", pieces(item));
    }
    panic!();
}

//! The pieces found in contact energies, and the rules that find them.

use super::{expansion, lowered_by};
use crate::compilation::Names;
use crate::ir::print::Printer;
use crate::parse::Form;
use crate::split;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the pieces as "rule: energy", sorted. Errors: the term that no rule knows.
fn pieces(item: TokenStream) -> Result<Vec<String>, String> {
    let (energy, mut lowered) = lowered_by(Form::Contact, quote!(), item);
    let space = split::Space { degrees: energy.degrees(), action: true };
    let found = split::pieces(&mut lowered.graph, lowered.terms.energy, space, None);
    let names = Names { energy: &energy, constants: lowered.constants };
    let printer = Printer::new(&lowered.graph, &names);
    let mut found: Vec<String> = found
        .map_err(|term| printer.formula(term))?
        .pieces
        .iter()
        .map(|piece| format!("{} ({:?}): {}", piece.family.name, piece.clock, printer.formula(piece.energy)))
        .collect();
    found.sort();
    Ok(found)
}

/// Asserts that an energy has these pieces, in any order.
#[track_caller]
fn found(item: TokenStream, expected: &[&str]) {
    let mut expected = expected.to_vec();
    expected.sort_unstable();
    assert_eq!(pieces(item).expect("pieces"), expected);
}

#[test]
fn damped_mechanics() {
    found(
        quote! { fn f(q: f64, p: f64, s: f64, g: f64, m: f64) -> f64 { p * p / (2.0 * m) - q.cos() + g * s } },
        &["damped drift (Own): p²/(2·m) + s·g", "prolongation (Own): -cos(q)"],
    );
}

/// T + g·s + V in many spellings, with a common factor of all terms or of the damping and its shift.
#[test]
fn mechanics_behind_a_common_factor() {
    let damping = |item| {
        let (energy, mut lowered) = lowered_by(Form::Contact, quote!(), item);
        let found = split::mechanics(&mut lowered.graph, lowered.terms.energy, energy.degrees());
        let names = Names { energy: &energy, constants: lowered.constants };
        let printer = Printer::new(&lowered.graph, &names);
        found.map(|found| printer.formula(found.damping)).map_err(|term| printer.formula(term))
    };
    let of = |h| damping(quote! { fn f(q: f64, p: f64, s: f64, t: f64, a: f64, b: f64) -> f64 { #h } });
    for h in [
        quote! { p.powi(4) + q * q + a * s },
        quote! { p.powi(4) + q * q + a * (s + 1.0) },
        quote! { p.powi(4) + a * (s + q * q - b) },
        quote! { a * (p.powi(4) + s + q.cos()) },
        quote! { (p.powi(4) + q * q) / 2.0 + a * (b * (q + s / b) - 2.0) },
    ] {
        assert_eq!(of(h.clone()).as_deref(), Ok("a"), "{h}");
    }
    assert_eq!(of(quote! { p.powi(4) + t.sin() * (s - b) }).as_deref(), Ok("sin(t)"));
    assert_eq!(of(quote! { p.powi(4) + a * (s + q) * q }), Err("q·a·(q + s)".into()));
}

/// The exponential of this damping has no elementary integral, so the damping is frozen at the stage.
#[test]
fn perturbed_kepler() {
    found(
        quote! {
            fn f(q: [f64; 2], p: [f64; 2], s: f64, t: f64, a: f64, w: f64) -> f64 {
                (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt() + a * (w * t).sin() * s
            }
        },
        &["damped drift (Stage): s·a·sin(t·w) + (p[0]²/2 + p[1]²/2)", "prolongation (Own): -1/√(q[0]² + q[1]²)"],
    );
}

#[test]
fn lane_emden() {
    found(
        quote! { fn f(q: f64, p: f64, s: f64, t: f64) -> f64 { p * p / 2.0 + 2.0 / t * s + q.powi(6) / 6.0 } },
        &["damped drift (Own): p²/2 + 2·s/t", "prolongation (Own): q⁶/6"],
    );
}

#[test]
fn van_der_pol() {
    found(
        quote! { fn f(q: f64, p: f64, s: f64, e: f64) -> f64 { p * s - e * (1.0 - q * q) * s + q } },
        &["prolongation (Own): p·s", "prolongation (Own): q - s·e·(-q² + 1)"],
    );
}

#[test]
fn cosmology() {
    found(
        quote! { fn f(q: f64, p: f64, s: f64, r: f64) -> f64 { (p * p + q * q + s * s) / 2.0 - r } },
        &["oscillators (Own): p²/2 + q²/2", "prolongation (Own): s²/2 - r"],
    );
}

#[test]
fn quadratic_dissipation() {
    found(
        quote! { fn f(q: f64, p: f64, s: f64, a: f64) -> f64 { p * p / 2.0 + q * q / 2.0 + a * s * s / 2.0 } },
        &["oscillators (Own): p²/2 + q²/2", "prolongation (Own): s²·a/2"],
    );
}

#[test]
fn thermostat() {
    found(
        quote! { fn f(q: f64, p: f64, s: f64) -> f64 { (p * p / 2.0 - q.cos()) * (0.6 * s).exp() } },
        &["weighted drift (Own): p²·exp(3·s/5)/2", "prolongation (Own): -cos(q)·exp(3·s/5)"],
    );
}

/// A constant belongs to the potential.
#[test]
fn thermostat_with_a_constant() {
    found(
        quote! { fn f(q: f64, p: f64, s: f64) -> f64 { (p * p / 2.0 + 1.0 - q.cos()) * (0.6 * s).exp() } },
        &["weighted drift (Own): p²·exp(3·s/5)/2", "prolongation (Own): exp(3·s/5) - cos(q)·exp(3·s/5)"],
    );
}

/// A charge in a magnetic field, with friction.
#[test]
fn charge() {
    found(
        quote! {
            fn f(q: [f64; 2], p: [f64; 2], s: f64, b: f64, g: f64) -> f64 {
                (p[0] + b * q[1]).powi(2) / 2.0 + (p[1] - b * q[0]).powi(2) / 2.0 + g * s
            }
        },
        &[
            "oscillators (Own): s·g + (q[1]²·b²/2 + q[0]²·b²/2) + (p[0]²/2 + p[1]²/2)",
            "prolongation (Own): q[1]·p[0]·b - q[0]·p[1]·b",
        ],
    );
}

/// Seven waves with a common factor, and a constant torque.
#[test]
fn spin_orbit() {
    let item = quote! {
        fn f(q: f64, p: f64, s: f64, t: f64, a: f64, l: f64, w: f64, e: f64, m: f64, c: [f64; 7]) -> f64 {
            let size = 1.0 + l * (w * t).cos();
            let mut waves = 0.0;
            for i in 0..7 {
                waves += c[i] * (2.0 * q - (i as f64 + 1.0) * t).cos();
            }
            p * p / 2.0 + (-a - l * w * (w * t).sin() / size) * s - e / (2.0 * size) * waves - m * q
        }
    };
    let found = pieces(item).expect("pieces");
    assert_eq!(found.len(), 2, "{found:#?}");
    assert!(found[0].starts_with("damped drift (Stage): p²/2 + s·(-a"), "{}", found[0]);
    assert!(found[1].starts_with("prolongation (Stage): -e·(c[0]·cos(2·q - t)"), "{}", found[1]);
}

/// Damping of any sign and size is one piece.
#[test]
fn damped_oscillator() {
    found(
        quote! { fn f(q: f64, p: f64, s: f64, c: f64) -> f64 { p * p / 2.0 + q * q / 2.0 + c * s } },
        &["oscillators (Own): p²/2 + q²/2 + s·c"],
    );
}

/// Lotka and Volterra's field, and Lorenz's: components that are linear in one coordinate, or in two.
#[test]
fn lifts() {
    found(
        quote! {
            fn f(q: [f64; 2], p: [f64; 2], s: f64) -> f64 { p[0] * (q[0] * q[1] - q[0]) + p[1] * (q[1] - q[0] * q[1]) }
        },
        &["prolongation (Own): p[0]·(q[0]·q[1] - q[0])", "prolongation (Own): p[1]·(q[1] - q[0]·q[1])"],
    );
    found(
        quote! {
            fn f(q: [f64; 3], p: [f64; 3], s: f64) -> f64 {
                p[0] * 10.0 * (q[1] - q[0]) + p[1] * (q[0] * (28.0 - q[2]) - q[1]) + p[2] * (q[0] * q[1] - 2.5 * q[2])
            }
        },
        &[
            "prolongation (Own): 10·p[0]·(q[1] - q[0]) + p[1]·(q[0]·(-q[2] + 28) - q[1])",
            "prolongation (Own): p[2]·(q[0]·q[1] - 5·q[2]/2)",
        ],
    );
}

/// The term without a rule is named.
#[test]
fn terms_without_a_flow() {
    let item = quote! { fn f(q: f64, p: f64, s: f64) -> f64 { p * p / 2.0 + (q * p * s).sin() + q } };
    assert_eq!(pieces(item), Err("sin(q·p·s)".to_string()));
    let item = quote! { fn f(q: f64, p: f64, s: f64) -> f64 { p * p * (1.0 + q * s) - q.cos() } };
    assert_eq!(pieces(item), Err("q·p²·s".to_string()));
}

/// Returns the message for pieces that the user gives.
fn message_of(split: &str, item: &TokenStream) -> String {
    let tokens = expansion(Form::Contact, quote!(split = #split), item.clone());
    let message = tokens.split_once("compile_error ! {").map_or("", |(_, rest)| rest);
    message.split('"').nth(1).unwrap_or_default().to_string()
}

#[test]
fn given_pieces_add_up_in_any_spelling() {
    let item = quote! {
        fn f(q: f64, p: f64, s: f64, m: f64, k: f64, gamma: f64, big: f64) -> f64 {
            let v = p / m;
            (m * v * v + k * (q + 1.0) * (q + 1.0)) / 2.0 + gamma * s - 6.674e-11 * big * q.cos()
                + if q < 0.0 { 100.0 * q.powi(3) } else { 0.0 }
        }
    };
    let wall = "if q < 0.0 { 100.0 * q * q * q } else { 0.0 }";
    for split in [
        &format!("p * p / (2.0 * m) + gamma * s | 0.5 * k * (1.0 + q).powi(2) - 6.674e-11 * big * q.cos() + {wall}"),
        &format!("{wall} - big * q.cos() * 6.674e-11 | k * (q * q / 2.0 + q + 0.5) | s * gamma | 0.5 * p * p / m"),
    ] {
        assert_eq!(message_of(split, &item), "", "{split}");
    }
    let missing = "the pieces do not add up to the energy; what is missing";
    for (split, left) in [
        // Missing: a small term, a branch, the second half of a term, the sign of a term. One term occurs twice.
        (format!("p * p / (2.0 * m) + gamma * s | k * (q + 1.0).powi(2) / 2.0 + {wall}"), "is: -6.674e-11·big·cos(q)"),
        (
            "p * p / (2.0 * m) + gamma * s | k * (q + 1.0).powi(2) / 2.0 - 6.674e-11 * big * q.cos()".into(),
            "where q < 0 is: 100·q³",
        ),
        (
            format!(
                "p * p / (2.0 * m) + gamma * s | gamma * s | k * (q + 1.0).powi(2) / 2.0 - 6.674e-11 * big * q.cos() + {wall}"
            ),
            "is: -s·gamma",
        ),
        (
            format!("p * p / (2.0 * m) + gamma * s | k * (q * q + 1.0) / 2.0 - 6.674e-11 * big * q.cos() + {wall}"),
            "is: q·k",
        ),
        (
            format!("p * p / (2.0 * m) - gamma * s | k * (q + 1.0).powi(2) / 2.0 - 6.674e-11 * big * q.cos() + {wall}"),
            "is: 2·s·gamma",
        ),
    ] {
        let message = message_of(&split, &item);
        assert_eq!(message, format!("{missing} {left}"), "{split}");
    }
    // The remainder as it is written, if this is shorter.
    let catenary =
        quote! { fn f(q: f64, p: f64, s: f64, a: f64) -> f64 { p * p / 2.0 + s + a * (q / a).cosh() + q.max(0.0) } };
    assert_eq!(message_of("p * p / 2.0 | s + q.max(0.0)", &catenary), format!("{missing} is: a·cosh(q/a)"));
    assert_eq!(message_of("p * p / 2.0 | s + a * (q / a).cosh()", &catenary), format!("{missing} is: max(q, 0)"));
    let logarithm = quote! { fn f(q: f64, p: f64, s: f64) -> f64 { p * p / 2.0 + s - (q - 5.0).ln() } };
    assert_eq!(message_of("p * p / 2.0 | s", &logarithm), format!("{missing} is: -ln(q - 5)"));
    // A relation between functions that is unknown is no proof.
    let angle = quote! { fn f(q: f64, p: f64, s: f64) -> f64 { p * p / 2.0 + s + (2.0 * q).sin() } };
    assert_eq!(message_of("p * p / 2.0 | s + 2.0 * q.sin() * q.cos()", &angle), "");
    let angle = quote! { fn f(q: f64, p: f64, s: f64) -> f64 { p * p / 2.0 + s + q.acos() } };
    assert!(
        message_of("p * p / 2.0 | s + std::f64::consts::FRAC_PI_2 - q.asin()", &angle)
            .contains("relation between functions")
    );
    let long = quote! { fn f(q: f64, p: f64, s: f64, a: f64, b: f64) -> f64 { p + s + (q + a + b + 1.0).powi(60) } };
    assert!(message_of("p | s + (a + q + b + 1.0).powi(60)", &long).is_empty());
    assert!(message_of("p | s + (a + q + b + 1.0).powi(60) + q", &long).contains("-q"));
}

//! Random tokens, and random changes of valid energies.

use crate::parse::Form;
use proc_macro2::{Group, TokenStream, TokenTree};
use proptest::prelude::*;

/// Draws a token.
fn word() -> impl Strategy<Value = String> {
    let words = [
        "fn", "let", "mut", "for", "in", "if", "else", "while", "match", "return", "const", "async", "unsafe",
        "struct", "pub", "use", "as", "q", "p", "t", "x", "f64", "f32", "usize", "Vector3", "self", "1", "2.5",
        "1e400", "0", "+", "-", "*", "/", "%", "=", "+=", "==", "<", ">", "..", "..=", "&", "|", "!", "->", "=>", ",",
        ";", ":", "::", ".", "#", "'a", "\"s\"", "'c'", "require", "name", "crate", "with", "const", "split", "lift",
        "s", "sin", "sum", "map", "iter", "r#type", "_",
    ];
    prop::sample::select(words.to_vec()).prop_map(str::to_string)
}

/// Draws tokens in nested groups.
pub(super) fn token_text() -> impl Strategy<Value = String> {
    let leaf = prop::collection::vec(word(), 0..8).prop_map(|words| words.join(" "));
    leaf.prop_recursive(4, 64, 6, |inner| {
        (prop::collection::vec(inner, 0..4), 0..3_usize).prop_map(|(parts, kind)| {
            let [open, close] = [["(", ")"], ["[", "]"], ["{", "}"]][kind];
            format!("{open} {} {close}", parts.join(" "))
        })
    })
}

/// Valid functions of several forms.
pub(super) const ENERGIES: [(Form, &str); 6] = [
    (
        Form::Field,
        "fn top(x: [f64; 3], t: f64, a: f64, w: Vector3<f64>) -> [f64; 3] {
        let [u, v, _] = x;
        let torque = if u > a { w.x * t.cos() } else { 0.0 };
        [(a - w.y) * v * x[2] + torque, (w.z - a) * x[2] * u, -u * v / (1.0 + a * a)]
    }",
    ),
    (
        Form::Hamiltonian,
        "/// Pendulum.
    pub fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 { p * p / (2.0 * m * l * l) - m * g * l * q.cos() }",
    ),
    (
        Form::Hamiltonian,
        "fn bodies(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3], t: f64) -> f64 {
        const G: f64 = 6.67e-11;
        fn square(x: [f64; 2]) -> f64 { x.iter().map(|x| x * x).sum() }
        let mut e = t.sin() * q[0][0];
        for i in 0..3 {
            e += square(p[i]) / (2.0 * m[i]);
            for j in 0..i { e -= G * m[i] * m[j] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]); }
        }
        e
    }",
    ),
    (
        Form::Hamiltonian,
        "fn chain(q: Vector3<f64>, p: Vector3<f64>, k: f64) -> f64 {
        let [a, b, c] = [q.x, q[1], q.z];
        let soft = |x: f64| if x > 0.0 && k < 1.0 { k * x.ln_1p() } else { x.powi(2) };
        let ring: f64 = (0..3).map(|i| soft(q[i] - q[(i + 1) % 3])).sum();
        0.5 * p.norm_squared() + ring + (a - b).powi(4) + c.abs()
    }",
    ),
    (
        Form::Contact,
        "fn braked(q: [f64; 2], p: [f64; 2], s: f64, t: f64, m: f64, alpha: f64) -> f64 {
        let mut anomaly = t;
        for _ in 0..3 { anomaly = anomaly - (anomaly - 0.3 * anomaly.sin() - t) / (1.0 - 0.3 * anomaly.cos()); }
        (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - 1.0 / q[0].hypot(q[1]) + alpha * anomaly.sin() * s
    }",
    ),
    (
        Form::Contact,
        "fn lift(q: f64, p: f64, s: f64, a: f64, w: [f64; 2]) -> f64 {
        let mut c = [0.0; 3];
        for i in 0..3 { c[i] += a.powi(i as i32); }
        p * (w[0] * q + c[2]) + w[1] * s * s - c[1] * (0.3 * s).exp() * q.sin()
    }",
    ),
];

/// A change of the tokens of an energy.
#[derive(Clone, Debug)]
pub(super) enum Damage {
    Remove,
    Double,
    Replace(String),
    Swap,
    Insert(String),
}

/// Draws a change and the number of the token.
pub(super) fn damage() -> impl Strategy<Value = (usize, Damage)> {
    let kind = prop_oneof![
        Just(Damage::Remove),
        Just(Damage::Double),
        Just(Damage::Swap),
        word().prop_map(Damage::Replace),
        super::functions::leaf().prop_map(Damage::Replace),
        word().prop_map(Damage::Insert),
    ];
    (0..400_usize, kind)
}

/// Returns the tokens with damage at token `at`, counted through all groups.
pub(super) fn damaged(stream: TokenStream, at: &mut usize, damage: &Damage) -> TokenStream {
    let mut out: Vec<TokenTree> = vec![];
    for tree in stream {
        let here = *at == 0;
        *at = at.wrapping_sub(1);
        let tree = match tree {
            TokenTree::Group(group) if !here => {
                TokenTree::Group(Group::new(group.delimiter(), damaged(group.stream(), at, damage)))
            }
            other => other,
        };
        match damage {
            Damage::Remove if here => {}
            Damage::Double if here => out.extend([tree.clone(), tree]),
            Damage::Replace(text) if here => out.extend(super::tokens(text).unwrap_or_default()),
            Damage::Insert(text) if here => {
                out.extend(super::tokens(text).unwrap_or_default().into_iter().chain([tree]))
            }
            Damage::Swap if here => {
                let before = out.pop();
                out.push(tree);
                out.extend(before);
            }
            _ => out.push(tree),
        }
    }
    out.into_iter().collect()
}

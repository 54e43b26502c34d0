//! Integrals of fields are proven. Integrals with one wrong sign are refuted.

use super::systems::{Field, Lowered, fields};
use super::{arrays, coordinates};
use crate::analyze::claims::is_kept;
use crate::analyze::{Identity, Proof};
use crate::ir::{Graph, Id, Symbol};
use proc_macro2::TokenStream;
use quote::quote;

#[test]
fn thirty_six_integrals_are_decided() {
    let mut count = 0;
    for field in fields() {
        let Lowered { mut graph, x, field: f, integrals, .. } = field.lowered();
        for (k, (integral, (_, kept))) in integrals.iter().zip(&field.integrals).enumerate() {
            let verdict = is_kept(&mut graph, &x, &f, *integral, None);
            assert_eq!(verdict.is_zero(), *kept, "{} {k}: {verdict:?}", field.name);
            count += 1;
        }
    }
    assert_eq!(count, 36);
}

/// Integrals with one wrong sign.
fn wrong(field: &Field) -> Vec<TokenStream> {
    match field.name {
        "Lotka–Volterra" => vec![quote!(b * x[0] + c * x[0].ln() + b * x[1] - a * x[1].ln())],
        "Euler top" => {
            vec![quote!(a * u * u + b * v * v - c * w * w), quote!(a * a * u * u - b * b * v * v + c * c * w * w)]
        }
        "Lorenz core" => vec![quote!(x[0] * x[0] - x[1] * x[1] + x[2] * x[2])],
        "Volterra lattice" => vec![
            quote!(p + q + r + s - u),
            quote!(p.ln() + r.ln() - u.ln()),
            quote!((p * p + q * q + r * r + s * s + u * u) / 2.0 + p * q + q * r + r * s - s * u),
        ],
        "ring" => vec![quote!(x[0] - x[1] + x[2])],
        "epidemic" => vec![quote!(x[0] + x[1] - x[2]), quote!(x[0].ln() - a / b * x[2])],
        "Lagrange top" => vec![quote!((m1 * w1 + m2 * w2 + m3 * w3) / 2.0 - g3), quote!(m1 * g1 + m2 * g2 - m3 * g3)],
        "Kovalevskaya top" => vec![
            quote!(((m1 * m1 - m2 * m2) / 4.0 - g1).powi(2) - (m1 * m2 / 2.0 - g2).powi(2)),
            quote!(((m1 * m1 - m2 * m2) / 4.0 + g1).powi(2) + (m1 * m2 / 2.0 - g2).powi(2)),
        ],
        "Toda" => vec![
            quote!((p * p + q * q + r * r + s * s) / 2.0 + u * u + v * v - w * w),
            quote!(p + q - r + s),
            quote!(
                (p.powi(3) + q.powi(3) + r.powi(3) + s.powi(3)) / 3.0 + u * u * (p + q) + v * v * (q + r)
                    - w * w * (r + s)
            ),
        ],
        "vortices" => vec![quote!(g[0] * x[0] + g[1] * x[1] - g[2] * x[2] + g[3] * x[3]), quote!(h + x[0] * x[0])],
        "Ablowitz–Ladik" => vec![quote!(norm - next + 2.0 * x[0] * x[1])],
        "charge" => vec![quote!((v1 * v1 + v2 * v2 + v3 * v3 + q1 * q1) / 2.0 + q2.powi(4) / 4.0 - q3 * q3 / 5.0)],
        "three waves" => vec![quote!((q1 * q2 + p1 * p2) * q3 + (q1 * p2 + p1 * q2) * p3)],
        _ => vec![],
    }
}

#[test]
fn integrals_with_one_wrong_sign_are_refuted() {
    let mut count = 0;
    for field in fields() {
        let wrong = wrong(&field);
        let Lowered { mut graph, x, field: f, integrals, .. } = field.with(&wrong);
        for (integral, text) in integrals.iter().zip(wrong) {
            let verdict = is_kept(&mut graph, &x, &f, *integral, None);
            assert!(matches!(&verdict, Identity::Wrong(_)), "{} {text}: {verdict:?}", field.name);
            count += 1;
        }
    }
    assert!(count >= 20, "{count}");
}

/// Three bodies in the plane: the field, its energy, angular momentum and momentum, and each integral with a wrong sign.
fn three_bodies() -> (Graph, Vec<Symbol>, Vec<Id>, Vec<Id>) {
    let setup = quote! {
        let m = [a, b, c];
        let mut f = [0.0; 12];
        let mut energy = 0.0;
        let mut around = 0.0;
        for i in 0..3 {
            let (px, py) = (x[6 + 2 * i], x[7 + 2 * i]);
            f[2 * i] = px / m[i];
            f[2 * i + 1] = py / m[i];
            energy += (px * px + py * py) / (2.0 * m[i]);
            around += x[2 * i] * py - x[2 * i + 1] * px;
            for j in 0..3 {
                if i != j {
                    let (dx, dy) = (x[2 * i] - x[2 * j], x[2 * i + 1] - x[2 * j + 1]);
                    let r = (dx * dx + dy * dy).sqrt();
                    f[6 + 2 * i] -= m[i] * m[j] * dx / r.powi(3);
                    f[7 + 2 * i] -= m[i] * m[j] * dy / (r * r * r);
                    if j < i { energy -= m[i] * m[j] / r; }
                }
            }
        }
    };
    let integrals =
        quote!([energy, around, x[6] + x[8] + x[10], energy + x[0], around + 2.0 * x[0] * x[7], x[6] + x[8] - x[10]]);
    let field = quote!([f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], f[9], f[10], f[11]]);
    let (graph, mut found) = arrays(12, &setup, &[&field, &integrals]);
    let integrals = found.remove(1);
    (graph, coordinates(12), found.remove(0), integrals)
}

#[test]
fn integrals_with_roots_are_decided() {
    let (mut graph, x, field, integrals) = three_bodies();
    for (k, integral) in integrals.into_iter().enumerate() {
        let verdict = is_kept(&mut graph, &x, &field, integral, None);
        assert_eq!(verdict.is_zero(), k < 3, "{k}: {verdict:?}");
        assert!(verdict.is_zero() || matches!(verdict, Identity::Wrong(_)), "{k}: {verdict:?}");
    }
}

#[test]
#[ignore = "prints times"]
fn times() {
    // The shortest of five times, each with a new graph.
    let timed = |name: &str, graph: &Graph, x: &[Symbol], field: &[Id], integral: Id| {
        let runs = (0..5).map(|_| {
            let mut graph = graph.clone();
            let start = std::time::Instant::now();
            let verdict = is_kept(&mut graph, x, field, integral, None);
            (start.elapsed().as_secs_f64() * 1e3, verdict)
        });
        let (time, verdict) = runs.min_by(|a, b| a.0.total_cmp(&b.0)).expect("five runs");
        let proof = match &verdict {
            Identity::Zero(Proof::Multiplied) => "multiplied out".into(),
            Identity::Zero(Proof::Points(bound)) => format!("{bound:?}"),
            other => format!("not proven, rest {}", other.rest().is_some()),
        };
        println!("{name:18} {time:7.3} ms, {proof}");
        time
    };
    let mut slowest = 0.0_f64;
    for field in fields() {
        for list in [field.integrals.iter().map(|(integral, _)| integral.clone()).collect(), wrong(&field)] {
            let Lowered { graph, x, field: f, integrals, .. } = field.with(&list);
            for integral in integrals {
                slowest = slowest.max(timed(field.name, &graph, &x, &f, integral));
            }
        }
    }
    println!("slowest of the list: {slowest:.3} ms");
    let (graph, x, field, integrals) = three_bodies();
    for integral in integrals {
        timed("three bodies", &graph, &x, &field, integral);
    }
}

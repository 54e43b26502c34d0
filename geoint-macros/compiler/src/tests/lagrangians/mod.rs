//! The Legendre transformation at random states, and Lagrangians without an energy.

mod inverse;
mod masses;
mod messages;
mod signs;

use super::{Noise, lowered, lowered_by};
use crate::ir::print::Printer;
use crate::ir::{Graph, Id, Symbol};
use crate::legendre::{self, Flaw, Kinetic, Legendre, Route};
use crate::lower::{Lowered, Terms};
use crate::parse::Form;
use crate::tests::eval::eval;
use proc_macro2::TokenStream;
use quote::quote;

/// Lowers and transforms a Lagrangian.
fn transformed(item: TokenStream) -> (Graph, Result<Legendre, Flaw>) {
    let (energy, lowered) = lowered_by(Form::Lagrangian, TokenStream::new(), item);
    let Lowered { mut graph, terms: Terms { energy: root, partial, .. }, .. } = lowered;
    let found = legendre::transform(&mut graph, root, energy.degrees(), true, &partial);
    (graph, found)
}

/// Transforms a Lagrangian that has an energy. Panics with the flaw otherwise.
fn regular(item: TokenStream) -> (Graph, Legendre) {
    let text = item.to_string();
    let (graph, found) = transformed(item);
    (graph, found.unwrap_or_else(|flaw| panic!("{flaw:?} of {text}")))
}

/// Returns the formula of a node, with symbols such as `Position(0)`.
fn printed(graph: &Graph, id: Id) -> String {
    Printer::new(graph, &|symbol: Symbol| format!("{symbol:?}")).formula(id)
}

/// Checks the transformation at random (q, v) with p = ∂L/∂v: H = p·v − L, ∂H/∂p = v, and ∂H/∂q = −∂L/∂q.
fn check(item: TokenStream, velocities: [f64; 2]) {
    let text = item.to_string();
    let (mut graph, found) = regular(item);
    let Route::Energy { energy, velocities: velocities_of } = &found.route else { panic!("no energy of {text}") };
    let degrees = found.momenta.len();
    let by_q = crate::diff::gradient(&mut graph, *energy, degrees as u32).q;
    let mut noise = Noise(7);
    for _ in 0..100 {
        let mut numbers = |low, high| -> Vec<f64> { (0..4).map(|_| noise.between(low, high)).collect() };
        let (q, v, k) = (numbers(0.3, 1.2), numbers(velocities[0], velocities[1]), numbers(0.6, 1.4));
        let given = |symbol: Symbol| match symbol {
            Symbol::Position(i) => q[i as usize],
            Symbol::Velocity(i) => v[i as usize],
            Symbol::Parameter(i) => k[i as usize],
            Symbol::Action => 0.3,
            Symbol::Time => 0.7,
            other => panic!("{other:?} in a Lagrangian"),
        };
        let momenta: Vec<f64> = found.momenta.iter().map(|momentum| eval(&graph, *momentum, &given)).collect();
        let there = |symbol: Symbol| match symbol {
            Symbol::Momentum(i) => momenta[i as usize],
            Symbol::Velocity(_) => panic!("a velocity in the energy of {text}"),
            other => given(other),
        };
        let close = |found: f64, expected: f64, what: &str| {
            assert!((found - expected).abs() < 1e-11 * (1.0 + expected.abs()), "{what}: {found} {expected} of {text}");
        };
        let action: f64 = momenta.iter().zip(&v).map(|(p, v)| p * v).sum();
        close(eval(&graph, *energy, &there), action - eval(&graph, found.lagrangian, &given), "H");
        for i in 0..degrees {
            close(eval(&graph, velocities_of[i], &there), v[i], "v");
            close(eval(&graph, by_q[i], &there), -eval(&graph, found.forces[i], &given), "∂H/∂q");
        }
    }
}

#[test]
fn energies_belong_to_lagrangians() {
    // Constant, diagonal and full mass matrices, with linear terms, time, and the action.
    check(quote! { fn f(q: f64, v: f64, m: f64, k: f64) -> f64 { m * v * v / 2.0 - k * q.powi(4) } }, [-1.0, 1.0]);
    check(
        quote! { fn f(q: [f64; 2], v: [f64; 2], a: f64, b: f64) -> f64 {
            a * v[0] * v[0] + v[0] * v[1] * b / 3.0 + (v[1] + q[0]).powi(2) - q[0] * q[1].cos()
        } },
        [-1.0, 1.0],
    );
    check(
        quote! { fn f(q: f64, v: f64, t: f64, m: f64) -> f64 { (m * t).exp() * (v * v / 2.0 - q.sin()) + t * v } },
        [-1.0, 1.0],
    );
    check(
        quote! { fn f(q: [f64; 3], v: [f64; 3], m: [f64; 3]) -> f64 {
            let sin = q[0].sin();
            m[0] * v[0] * v[0]
                + m[1] * (v[1] * sin + v[0]).powi(2)
                + m[2] * (v[2] + v[1] * q[1]).powi(2)
                + v[1] * q[2]
                - q[2] * q[0]
        } },
        [-1.0, 1.0],
    );
    check(
        quote! { fn f(q: f64, v: f64, s: f64, t: f64) -> f64 {
            v * v * (1.0 + s / 5.0) / 2.0 + q.cos() - s * s / 10.0 - t.sin() * s / 4.0
        } },
        [-1.0, 1.0],
    );
    // Each known conjugate, with linear terms and constants that depend on positions.
    check(
        quote! { fn f(q: [f64; 2], v: [f64; 2], m: f64, c: f64) -> f64 {
            -m * c * c * (1.0 - (v[0] * v[0] + v[1] * v[1]) / (c * c)).sqrt() + q[0] * v[1] - q[1]
        } },
        [-0.3, 0.3],
    );
    check(quote! { fn f(q: f64, v: f64) -> f64 { ((1.0 + v * v) / q).sqrt() } }, [-1.0, 1.0]);
    check(quote! { fn f(q: f64, v: f64, a: f64) -> f64 { a * q * v.powi(4) / 4.0 - q } }, [0.2, 1.0]);
    check(quote! { fn f(q: f64, v: f64, a: f64) -> f64 { a * (2.0 * v).abs().powf(1.5) + q * v } }, [-1.0, -0.2]);
    check(quote! { fn f(q: f64, v: f64, a: f64) -> f64 { a * q * (2.0 * v + q).exp() - q + 3.0 * v } }, [-1.0, 1.0]);
    check(quote! { fn f(q: f64, v: f64, a: f64) -> f64 { a * (v + q).ln() - q.sin() } }, [0.2, 1.0]);
    check(quote! { fn f(q: f64, v: f64, a: f64) -> f64 { -a * (3.0 * v).cosh() - v * q } }, [-1.0, 1.0]);
    // Parts of different kinds.
    check(
        quote! { fn f(q: [f64; 3], v: [f64; 3], m: f64, a: f64) -> f64 {
            a * (m * (v[0] + v[1] * q[0]).powi(2) / 2.0 + m * v[1] * v[1]
                - (1.0 - v[2] * v[2]).sqrt()
                - q[2] * q[1])
        } },
        [-0.9, 0.9],
    );
}

#[test]
fn flaws_say_why_there_is_no_energy() {
    let flaw = |item| transformed(item).1.expect_err("a flaw");
    assert!(matches!(flaw(quote! { fn f(q: [f64; 2], v: [f64; 2]) -> f64 { v[0] * v[0] - q[1] } }), Flaw::Unread(1)));
    assert!(matches!(
        flaw(quote! { fn f(q: [f64; 2], v: [f64; 2]) -> f64 { q[1] * v[0] - q[0] * v[1] - q[0] } }),
        Flaw::Linear(_)
    ));
    assert!(matches!(
        flaw(quote! { fn f(q: [f64; 2], v: [f64; 2]) -> f64 { q[1] * v[0] + v[1] * v[1] - q[0] } }),
        Flaw::LinearIn(0, _)
    ));
    // q[1] is the momentum of q[2], so the missing velocity of q[1] is no flaw.
    assert!(matches!(
        flaw(quote! { fn f(q: [f64; 3], v: [f64; 3]) -> f64 {
            v[0] * v[0] + q[1] * v[2] - q[0] * q[0] - q[1] * q[1]
        } }),
        Flaw::LinearIn(2, _)
    ));
    let singular = quote! { fn f(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
        m * (v[0] + v[1] * q[0].cos()).powi(2) - q[1]
    } };
    assert!(matches!(flaw(singular), Flaw::Singular(velocities, _) if velocities == [0, 1]));
    // Three velocities have no energy in closed form. The singular mass matrix is found all the same.
    let full = quote! { fn f(q: [f64; 3], v: [f64; 3]) -> f64 {
        (v[0] + v[1] * q[0].cos()).powi(2) + (v[1] + v[2] * q[1].sin()).powi(2) - q[2]
    } };
    assert!(matches!(flaw(full), Flaw::Singular(velocities, _) if velocities == [0, 1, 2]));
    // The function has no known conjugate, but reads a single combination of velocities.
    let quartic = quote! { fn f(q: [f64; 2], v: [f64; 2]) -> f64 { (v[0] + v[1] * q[0]).powi(4) - q[1] } };
    assert!(matches!(flaw(quartic), Flaw::Singular(velocities, _) if velocities == [0, 1]));
    // sin² + cos² − 1 is zero by a relation between functions.
    let hidden = quote! { fn f(q: [f64; 2], v: [f64; 2]) -> f64 {
        let (s, c) = q[0].sin_cos();
        v[0] * v[0] * (s * s + c * c) + 2.0 * v[0] * v[1] + v[1] * v[1] - q[1]
    } };
    assert!(matches!(flaw(hidden), Flaw::Singular(..)));
    assert!(matches!(
        flaw(quote!(fn f(q: f64, v: f64) -> f64 { v.powi(4) + v * v - q })),
        Flaw::NotClosed(velocities, _) if velocities == [0]
    ));
}

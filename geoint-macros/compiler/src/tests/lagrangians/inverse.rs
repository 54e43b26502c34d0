//! Lagrangians of energies at random states.

use crate::diff;
use crate::ir::Symbol;
use crate::legendre;
use crate::lower::{Lowered, Terms};
use crate::parse::Form;
use crate::tests::eval::eval;
use crate::tests::{Noise, lowered_by};
use proc_macro2::TokenStream;
use quote::quote;

/// Checks at random (q, p) with v = ∂H/∂p: L = p·v − H, and ∂L/∂v = p from its formula.
fn check(item: TokenStream) {
    let text = item.to_string();
    let (energy, lowered) = lowered_by(Form::Hamiltonian, TokenStream::new(), item);
    let Lowered { mut graph, terms: Terms { energy: root, .. }, .. } = lowered;
    let degrees = energy.degrees();
    let found = legendre::inverse(&mut graph, root, degrees).unwrap_or_else(|| panic!("no formula for {text}"));
    let velocities = diff::gradient(&mut graph, root, degrees).p;
    let mut noise = Noise(11);
    for _ in 0..100 {
        let mut numbers = |low, high| -> Vec<f64> { (0..4).map(|_| noise.between(low, high)).collect() };
        let (q, p, k) = (numbers(0.3, 1.2), numbers(0.2, 0.9), numbers(0.6, 1.4));
        let given = |symbol: Symbol| match symbol {
            Symbol::Position(i) => q[i as usize],
            Symbol::Momentum(i) => p[i as usize],
            Symbol::Parameter(i) => k[i as usize],
            Symbol::Time => 0.7,
            other => panic!("{other:?} in an energy"),
        };
        let v: Vec<f64> = velocities.iter().map(|velocity| eval(&graph, *velocity, &given)).collect();
        let there = |symbol: Symbol| match symbol {
            Symbol::Velocity(i) => v[i as usize],
            Symbol::Momentum(_) => panic!("a momentum in the Lagrangian of {text}"),
            other => given(other),
        };
        let power: f64 = p.iter().zip(&v).map(|(p, v)| p * v).sum();
        let expected = power - eval(&graph, root, &given);
        let lagrangian = eval(&graph, found.lagrangian, &there);
        assert!((lagrangian - expected).abs() < 1e-12, "{text}: {lagrangian} {expected}");
        for (momentum, p) in found.momenta.iter().zip(&p) {
            let momentum = eval(&graph, *momentum, &there);
            assert!((momentum - p).abs() < 1e-12, "{text}: {momentum} {p}");
        }
    }
}

#[test]
fn energies_have_their_lagrangians() {
    for energy in [
        quote! { fn h(q: f64, p: f64, m: f64, a: f64) -> f64 { (p - a * q).powi(2) / (2.0 * m) + q.cos() } },
        quote! { fn h(q: [f64; 2], p: [f64; 2], t: f64, m: f64, a: f64) -> f64 {
            (p[0] * p[0] / m + p[1] * p[1] / (m + q[0] * q[0]) + p[0] * p[1] * q[1] / 3.0) / 2.0 + p[1] * t.sin() + a * q[0]
        } },
        quote! { fn h(q: [f64; 3], p: [f64; 3], m: f64, a: f64) -> f64 {
            let [x, y, z] = p;
            (m * x * x + 2.0 * y * y + 3.0 * z * z + x * y + a * y * z) / 2.0 + q[0] * q[1] * q[2]
        } },
        // The table of conjugates from right to left.
        quote! { fn h(q: f64, p: f64, m: f64, c: f64) -> f64 { (p * p * c * c + m * m * c.powi(4)).sqrt() + q * q } },
        quote! { fn h(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
            (p[0] * p[0] + p[1] * p[1] + m * m).sqrt() + q[0] * p[0] / 5.0 - q[1]
        } },
        quote! { fn h(q: f64, p: f64, m: f64) -> f64 { m * p.powi(4) + q * q } },
        quote! { fn h(q: f64, p: f64, m: f64) -> f64 { m * p.abs().powf(1.5) + q * p } },
        quote! { fn h(q: f64, p: f64, m: f64) -> f64 { m * (2.0 * p).cosh() - q } },
        quote! { fn h(q: f64, p: f64, m: f64) -> f64 { m * p.exp() + q } },
    ] {
        check(energy);
    }
}

#[test]
fn other_energies_have_values_alone() {
    for energy in [
        quote! { fn h(q: f64, p: f64) -> f64 { p.powi(4) + p * p + q * q } },
        quote! { fn h(q: f64, p: f64) -> f64 { p * q } },
        quote! { fn h(q: [f64; 2], p: [f64; 2]) -> f64 { p[0] * p[0] + q[0] * q[1] } },
        quote! { fn h(q: f64, p: f64) -> f64 { if p > 0.0 { p * p } else { p * p + p } } },
        // The inverse of a full matrix that moves is longer than its solution by elimination.
        quote! { fn h(q: [f64; 3], p: [f64; 3]) -> f64 {
            let [x, y, z] = p;
            (x * x + y * y + z * z) * (2.0 + q[0].sin()) + x * y * q[1].sin() + y * z * q[2].cos() + x * z * (q[0] - q[1]).cos()
        } },
    ] {
        let text = energy.to_string();
        let (energy, mut lowered) = lowered_by(Form::Hamiltonian, TokenStream::new(), energy);
        let found = legendre::inverse(&mut lowered.graph, lowered.terms.energy, energy.degrees());
        assert!(found.is_none(), "{text}");
    }
}

//! Lagrangians with terms of unusual sign, and with kinks.

use super::{check, printed, regular, transformed};
use crate::legendre::{Definite, Flaw, Route, definite};
use quote::quote;

/// √(v² − a) needs |v| > √a. Its energy has the opposite sign of the energy of √(a + v²).
#[test]
fn roots_of_differences_of_squares() {
    check(quote! { fn f(q: f64, v: f64, a: f64) -> f64 { (v * v - a * a).sqrt() - q * q } }, [1.5, 3.0]);
    check(
        quote! { fn f(q: f64, v: f64, a: f64) -> f64 { (1.0 + q) * (4.0 * v * v + a * (q - 2.0)).sqrt() - q * q } },
        [1.5, 3.0],
    );
    check(
        quote! { fn f(q: [f64; 2], v: [f64; 2], a: f64) -> f64 {
            -(a * q[0] + v[0] * v[0] + v[0] * v[1] + 2.0 * v[1] * v[1]).sqrt() + q[1] * v[0]
        } },
        [-1.0, 1.0],
    );
}

/// (v + q)·q has a part without velocities.
#[test]
fn linear_terms_may_have_constants() {
    check(quote! { fn f(q: f64, v: f64) -> f64 { v.cosh() + (v + q) * q } }, [-1.0, 1.0]);
    check(
        quote! { fn f(q: [f64; 3], v: [f64; 3], a: f64) -> f64 {
            a * v[0].exp() + (v[0] + v[1] + 3.0) * (q[0] + 2.0 * q[1]) - (1.0 - v[1] * v[1]).sqrt()
                + (1.0 + q[0]) * v[2] * v[2]
        } },
        [-0.9, 0.9],
    );
}

/// Mass matrices with masses of both signs, which are regular but have no non-zero pivot on their diagonal. Example: free fall in coordinates that
/// cross a horizon. The elimination divides by the determinant of two rows, a number.
#[test]
fn pivots_may_be_blocks_of_two() {
    let falling = quote! { fn f(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
        let r = q[1];
        (-(1.0 - 2.0 * m / r) * v[0] * v[0] + 2.0 * v[0] * v[1] + r * r * v[2] * v[2]) / 2.0
    } };
    check(falling.clone(), [-1.0, 1.0]);
    let (graph, found) = regular(falling);
    let Route::Energy { energy, .. } = found.route else { panic!("no energy") };
    let text = printed(&graph, energy);
    assert!(!text.contains("/(1 - 2") && !text.contains("/(2·"), "{text}");
    check(
        quote! { fn f(q: [f64; 2], v: [f64; 2], m: f64) -> f64 { m * v[0] * v[1] - q[0] * q[1] + q[1] * v[0] } },
        [-1.0, 1.0],
    );
    // More such rows, with terms of both signs.
    check(
        quote! { fn f(q: [f64; 4], v: [f64; 4], m: f64) -> f64 {
            let sin = q[0].sin();
            sin * v[0] * v[0]
                + 3.0 * m * v[0] * v[1]
                + m * v[2] * (v[0] + 0.3 * v[1])
                + m * v[2] * v[2] / 5.0
                + q[1] * v[3]
                + m * v[3] * v[3] / 2.0
                + 0.1 * v[3] * v[0]
        } },
        [-1.0, 1.0],
    );
}

/// Momenta inside the jump of ∂L/∂v belong to no velocity.
#[test]
fn kinks_are_refused() {
    for item in [
        quote! { fn f(q: f64, v: f64, k: f64) -> f64 { v * v / 2.0 + k * v.abs() - q * q } },
        quote! { fn f(q: f64, v: f64, k: f64) -> f64 { v.abs() - q * q } },
        quote! { fn f(q: f64, v: f64, k: f64) -> f64 {
            (if v > q { v * v / 2.0 + k * v } else { v * v / 2.0 }) - q * q
        } },
        quote! { fn f(q: [f64; 2], v: [f64; 2], k: f64) -> f64 {
            (v[0] * v[0] + v[1] * v[1]) / 2.0 + (v[0] - v[1] * q[0]).max(0.0)
        } },
    ] {
        let text = item.to_string();
        assert!(matches!(transformed(item).1, Err(Flaw::Jumps(..))), "{text}");
    }
    // Where slopes change, momenta are continuous.
    let ratchet = quote! { fn f(q: f64, v: f64, k: f64) -> f64 {
        (if v > 0.0 { k * v * v } else { v * v / 2.0 }) + v.abs().powi(3) - q * q
    } };
    assert!(matches!(transformed(ratchet).1, Err(Flaw::NotClosed(..))));
}

/// A sum of squares is definite if it determines one velocity after the other. Other sums are not recognised.
#[test]
fn definite_mass_matrices_are_recognised() {
    let recognised = |item| {
        let (mut graph, found) = regular(item);
        let degrees = found.momenta.len() as u32;
        definite(&mut graph, found.lagrangian, degrees).map(|Definite { positive, .. }| positive.len())
    };
    let chain = quote! { fn f(q: [f64; 3], v: [f64; 3], m: f64, l: f64) -> f64 {
        let (mut x, mut y, mut sum) = (0.0, 0.0, 0.0);
        for i in 0..3 {
            x += l * v[i] * q[i].cos();
            y += l * v[i] * q[i].sin();
            sum += m * (x * x + y * y) / 2.0;
        }
        sum
    } };
    assert_eq!(recognised(chain), Some(3));
    // At q₀ = 0, the first coordinate has no inertia.
    let square = quote! { fn f(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
        m * (q[0] * v[0]).powi(2) + (v[1] + v[0]).powi(2)
    } };
    assert_eq!(recognised(square), None);
    let crossed = quote! { fn f(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
        m * (v[0] + q[0] * v[1]).powi(2) + (v[1] + q[0] * v[0]).powi(2)
    } };
    assert_eq!(recognised(crossed), None);
    let positive = quote! { fn f(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
        m * (1.0 + q[0] * q[0]).powi(2) * v[0] * v[0] + (v[1] + q[0] * v[0]).powi(2)
    } };
    assert!(recognised(positive).is_some());
}

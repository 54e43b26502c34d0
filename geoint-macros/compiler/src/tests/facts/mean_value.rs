//! Compares mean values of the gradient that have a closed form with quadrature.

use super::super::{Noise, lowered};
use crate::analyze::{self, MeanValue};
use crate::diff;
use crate::ir::print::Printer;
use crate::ir::{Id, Symbol};
use crate::tests::eval::eval;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the nodes and weights of Gauss's quadrature on (0, 1), by Newton's iteration on the Legendre polynomial.
fn gauss(points: u32) -> Vec<(f64, f64)> {
    let n = f64::from(points);
    let node = |i: u32| {
        let mut x = (std::f64::consts::PI * (f64::from(i) + 0.75) / (n + 0.5)).cos();
        let mut slope = 0.0;
        for _ in 0..50 {
            let (mut last, mut value) = (1.0, x);
            for k in 2..=points {
                let k = f64::from(k);
                (last, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * last) / k);
            }
            slope = n * (x * value - last) / (x * x - 1.0);
            x -= value / slope;
        }
        ((1.0 + x) / 2.0, 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..points).map(node).collect()
}

/// The fact about the mean of the gradient.
struct Found {
    fact: MeanValue,
    /// The term that has no closed form.
    term: Option<String>,
    /// The largest difference between the closed form and the mean of the gradient.
    difference: f64,
}

/// Returns the fact about the mean of the gradient, and compares it with quadrature.
fn mean_value(item: TokenStream) -> Found {
    let (energy, mut lowered) = lowered(item);
    let (degrees, graph) = (energy.degrees(), &mut lowered.graph);
    let structure = analyze::structure(graph, lowered.terms.energy, &energy.coordinates.shape);
    let gradient = diff::gradient(graph, lowered.terms.energy, degrees);
    let tree = diff::discrete_gradient(graph, lowered.terms.energy, degrees);
    let mut noise = Noise(11);
    let mut largest = 0.0_f64;
    for _ in 0..4 {
        let values: Vec<f64> = (0..64).map(|_| noise.between(0.4, 1.3)).collect();
        // The value between two points of the line.
        let value = |root: Id, start: f64, length: f64| {
            let coordinate = |i: u32| values[i as usize] + start * values[8 + i as usize];
            eval(graph, root, &|symbol| match symbol {
                Symbol::Position(i) => coordinate(i),
                Symbol::Momentum(i) => coordinate(16 + i),
                Symbol::PositionIncrement(i) => length * values[8 + i as usize],
                Symbol::MomentumIncrement(i) => length * values[24 + i as usize],
                Symbol::Parameter(i) => values[32 + i as usize],
                _ => values[63],
            })
        };
        let quadrature = |slope: Id, points: u32| -> f64 {
            gauss(points).iter().map(|(node, weight)| weight * value(slope, *node, 0.0)).sum()
        };
        let divided = |slope: Id, parts: u32| -> f64 {
            let length = 1.0 / f64::from(parts);
            (0..parts).map(|part| value(slope, f64::from(part) * length, length) * length).sum()
        };
        let slopes = [&gradient.q[..], &gradient.p].concat().into_iter().zip([&tree.q[..], &tree.p].concat());
        for (slope, tree) in slopes {
            let closed = match structure.mean_value {
                MeanValue::Gauss(points) => quadrature(slope, points),
                MeanValue::Parts(most) => at_zero((1..=most).map(|n| (f64::from(n).powi(-2), divided(tree, n)))),
                MeanValue::NotClosed(_) => divided(tree, 1),
            };
            largest = largest.max((closed - quadrature(slope, 40)).abs());
        }
    }
    let term = match structure.mean_value {
        MeanValue::NotClosed(term) => Some(term),
        _ => None,
    };
    let name = |symbol| match symbol {
        Symbol::Position(i) => format!("q{i}"),
        Symbol::Momentum(i) => format!("p{i}"),
        _ => "c".into(),
    };
    let printer = Printer::new(graph, &name);
    Found { fact: structure.mean_value, term: term.map(|term| printer.formula(term)), difference: largest }
}

/// Returns the value at 0 of the polynomial through some points, by Neville's scheme.
fn at_zero(points: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (nodes, mut values): (Vec<f64>, Vec<f64>) = points.unzip();
    for width in 1..nodes.len() {
        for i in 0..nodes.len() - width {
            let [a, b] = [nodes[i], nodes[i + width]];
            values[i] = (a * values[i + 1] - b * values[i]) / (a - b);
        }
    }
    values[0]
}

/// Asserts that an energy has this fact, and that the closed form is accurate.
#[track_caller]
fn assert_closed(item: &TokenStream, expected: MeanValue, tolerance: f64) {
    let Found { fact, difference, .. } = mean_value(item.clone());
    assert_eq!(fact, expected, "{item}");
    assert!(difference < tolerance, "{item} {difference:e}");
}

#[test]
fn ridge_functions_and_quadratic_terms() {
    let energies = [
        quote! { fn f(q: f64, p: f64, m: f64, k: f64) -> f64 { p * p / (2.0 * m) + p * q - k * (q.cos() + q.exp() * q) } },
        quote! { fn f(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
            p[0] * p[1] + k * q[0] * q[1] + (q[0] - q[1]).powi(4) / 4.0 + k * ((q[0] - k * q[1]).exp() + q[0].powi(6))
        } },
        quote! { fn f(q: [f64; 2], p: [f64; 2], k: f64) -> f64 {
            let d = q[0] - 2.0 * p[1];
            p[0].sin() + (d - k).exp() * (4.0 * p[1] - 2.0 * q[0]) + (d + (k + d).sqrt()).powi(3)
        } },
    ];
    for item in energies {
        assert_closed(&item, MeanValue::Parts(1), 1e-12);
    }
}

#[test]
fn polynomials_need_half_their_degree_in_points() {
    let energies = [
        (quote! { fn f(q: [f64; 2], p: [f64; 2]) -> f64 { p[0] * p[0] + q[0] * q[0] * q[1] } }, 2),
        (quote! { fn f(q: [f64; 2], p: [f64; 2], k: f64) -> f64 { k * p[0] * p[0] * q[1] * q[0] + q[0] } }, 2),
        (quote! { fn f(q: [f64; 2], p: [f64; 2], k: f64) -> f64 { k * (p[0] * p[0] + q[1]).powi(3) } }, 3),
    ];
    for (item, points) in energies {
        assert_closed(&item, MeanValue::Gauss(points), 1e-12);
    }
}

#[test]
fn polynomials_beside_ridge_functions() {
    let energies = [
        (quote! { k * (p[1] - q[0]).sin() + k * (p[0] * q[0] * q[1].powi(3) + q[1].exp()) }, 3),
        (quote! { k * q[0].powi(4) + 3.0 * q[0] * q[0] * q[1] * p[1] - q[1].cos() + (q[0] + 2.0 * q[1]).exp() }, 2),
        (quote! { (q[0] * p[1] - k * q[1] * p[0]).powi(4) + (k + p[0] * p[0]).sqrt() }, 4),
        (quote! { (q[0] * q[0] + q[1] * q[1]).powi(3) * (k - p[0] * p[1]).powi(3) - k / p[1] }, 6),
        // Divided differences are exact for powers of single linear forms. The degree of the other term decides.
        (quote! { q[0].powi(12) + (q[0] - q[1]).powi(8) + q[0] * q[0] * q[1] }, 2),
    ];
    for (rest, parts) in energies {
        let item = quote! { fn f(q: [f64; 2], p: [f64; 2], k: f64, m: f64) -> f64 { p[0] * p[0] / (2.0 * m) + #rest } };
        assert_closed(&item, MeanValue::Parts(parts), 1e-10);
    }
}

#[test]
fn terms_that_are_not_closed_are_named() {
    let energies = [
        (quote! { -1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt() }, "1/√(q0² + q1²)"),
        (quote! { q[0].exp() + (q[0] - q[1]).exp() * q[0] }, "q0·exp(q0 - q1)"),
        (quote! { 2.0 * (q[0] - q[1]).exp() * (q[0] - k * q[1]).sin() }, "exp(q0 - q1)·sin(q0 - q1·c)"),
    ];
    for (potential, term) in energies {
        let item =
            quote! { fn f(q: [f64; 2], p: [f64; 2], k: f64) -> f64 { p[0] * p[0] + k * p[1] * p[1] + #potential } };
        let Found { fact, term: found, difference } = mean_value(item);
        assert!(matches!(fact, MeanValue::NotClosed(_)), "{fact:?}");
        assert_eq!(found.as_deref(), Some(term));
        assert!(difference > 1e-4, "the tree is not the mean value here: {difference:e}");
    }
}

//! Mass matrices: constant matrices, simplification of entries, and pivots.

use super::*;
use crate::attribute;
use crate::tests::hidden_statements;
use quote::ToTokens;

/// The derivatives equal the derivatives of the usual energy, operation by operation.
#[test]
fn constant_diagonal_masses_give_the_usual_energy() {
    let pairs = [
        (
            quote! { fn f(q: [f64; 2], v: [f64; 2], m: f64, k: f64) -> f64 {
                m * (v[0] * v[0] + v[1] * v[1]) / 2.0 - k * (q[0] * q[1]).cos()
            } },
            quote! { fn f(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
                (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + k * (q[0] * q[1]).cos()
            } },
        ),
        (
            quote! { fn f(q: f64, v: f64, m: f64, l: f64, g: f64) -> f64 {
                m * l * l * v * v / 2.0 + m * g * l * q.cos()
            } },
            quote! { fn f(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
                p * p / (2.0 * m * l * l) - m * g * l * q.cos()
            } },
        ),
    ];
    for (lagrangian, hamiltonian) in pairs {
        let slopes = |mut graph: Graph, energy, degrees| {
            let gradient = crate::diff::gradient(&mut graph, energy, degrees);
            [gradient.q, gradient.p].concat().into_iter().map(|slope| printed(&graph, slope)).collect::<Vec<_>>()
        };
        let (graph, found) = regular(lagrangian);
        let Route::Energy { energy: root, .. } = found.route else { panic!("no energy") };
        let (energy, written) = lowered(hamiltonian);
        let degrees = energy.degrees();
        assert_eq!(slopes(graph, root, degrees), slopes(written.graph, written.terms.energy, degrees));
    }
}

/// The code of a step equals the code of the energy. Only the value of H keeps the spelling of L, and an energy gets momenta from velocities.
#[test]
fn constant_diagonal_masses_give_the_code_of_the_energy() {
    let properties = |form, item| -> Vec<(String, String)> {
        let file: syn::File = syn::parse2(attribute::expand(form, quote!(), item)).expect("what is emitted is Rust");
        let named = file.items.iter().filter_map(hidden_statements).flatten().filter_map(|statement| match statement {
            syn::Stmt::Item(syn::Item::Impl(item)) => {
                let (name, _) = item.trait_.as_ref()?;
                Some((name.to_token_stream().to_string(), item.to_token_stream().to_string()))
            }
            _ => None,
        });
        named.collect()
    };
    let of_velocities = properties(
        Form::Lagrangian,
        quote! { fn f(q: [f64; 2], v: [f64; 2], m: [f64; 2]) -> f64 {
            let [x, y] = q;
            0.5 * (m[0] * v[0] * v[0] + m[1] * v[1] * v[1]) - 0.5 * (x * x + y * y) - x * x * y + y.powi(3) / 3.0
        } },
    );
    let of_momenta = properties(
        Form::Hamiltonian,
        quote! { fn f(q: [f64; 2], p: [f64; 2], m: [f64; 2]) -> f64 {
            let [x, y] = q;
            0.5 * (p[0] * p[0] / m[0] + p[1] * p[1] / m[1]) + 0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
        } },
    );
    for kernel in ["Separable", "Collocation", "DiscreteField", "Jets"] {
        assert!(of_momenta.iter().any(|(name, _)| name.starts_with(kernel)), "{kernel}");
    }
    let differ = of_momenta.iter().filter(|code| !of_velocities.contains(code)).map(|(name, _)| name.as_str());
    assert_eq!(differ.collect::<Vec<_>>(), ["PhaseSpace < R >", "OfVelocities < R >"]);
}

/// Cartesian kinematics: sin² + cos² is 1, products of sines and cosines become functions of differences, and vanishing terms are zero.
#[test]
fn mass_matrices_are_simplified() {
    let masses = |item| {
        let (graph, found) = regular(item);
        let entries = found.parts.iter().flat_map(|part| match &part.kinetic {
            Kinetic::Quadratic { mass, .. } => mass.concat(),
            _ => vec![],
        });
        entries.map(|entry| printed(&graph, entry)).collect::<Vec<_>>()
    };
    let pendulum = quote! { fn f(q: f64, v: f64, l: f64) -> f64 {
        let [x, y] = [l * v * q.cos(), l * v * q.sin()];
        0.5 * (x * x + y * y) + q.cos()
    } };
    assert_eq!(masses(pendulum), ["Parameter(0)²"]);
    let double = quote! { fn f(q: [f64; 2], v: [f64; 2]) -> f64 {
        let [x, y] = [v[0] * q[0].cos() + v[1] * q[1].cos(), v[0] * q[0].sin() + v[1] * q[1].sin()];
        0.5 * (x * x + y * y) + v[1] * v[1]
    } };
    assert_eq!(masses(double), ["1", "cos(Position(0) - Position(1))", "cos(Position(0) - Position(1))", "3"]);
    let relative = quote! { fn f(q: [f64; 2], v: [f64; 2]) -> f64 {
        let (a, b) = (q[0], q[0] + q[1]);
        let (u, w) = (v[0], v[0] + v[1]);
        let [x, y] = [u * a.cos() + w * b.cos(), u * a.sin() + w * b.sin()];
        0.5 * (x * x + y * y)
    } };
    let found = masses(relative);
    assert!(found.iter().all(|entry| !entry.contains("Position(0)")), "{found:?}");
    let polar = quote! { fn f(q: [f64; 2], v: [f64; 2]) -> f64 {
        let (sin, cos) = q[1].sin_cos();
        let [x, y] = [v[0] * cos - q[0] * sin * v[1], v[0] * sin + q[0] * cos * v[1]];
        0.5 * (x * x + y * y) - q[0]
    } };
    assert_eq!(masses(polar), ["1", "Position(0)²"]);
}

/// A step checks the pivots of a mass matrix that depends on positions.
#[test]
fn pivots_must_not_vanish() {
    let (graph, found) = regular(quote! { fn f(q: f64, v: f64, e: f64) -> f64 {
        v * v / 2.0 + e * q * v * v - q * q
    } });
    let partial: Vec<String> = found.partial.iter().map(|partial| printed(&graph, partial.node)).collect();
    assert_eq!(partial.len(), 1, "{partial:?}");
}

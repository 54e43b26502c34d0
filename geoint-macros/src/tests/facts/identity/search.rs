//! What is kept is found from the field alone.

use super::systems::{Lowered, fields};
use super::{arrays, coordinates};
use crate::analyze::claims::{dependent, is_casimir, is_gradient_form, is_kept, is_poisson};
use crate::analyze::search::{Kept, kept_along, multiplier, structure};
use crate::ir::Ratio;
use quote::quote;

/// For each field how many integrals there are, how many of them linear, and which of the known ones are combinations of them.
#[test]
fn integrals_up_to_degree_two_are_found() {
    let expected: [(&str, usize, usize, &[usize]); 14] = [
        ("Lotka–Volterra", 1, 0, &[0]),
        ("Euler top", 2, 0, &[0, 1]),
        ("Lorenz core", 1, 0, &[0]),
        ("Volterra lattice", 3, 1, &[0, 1, 2]),
        // ln x₀x₁x₂.
        ("ring", 2, 1, &[0, 1]),
        ("epidemic", 2, 1, &[0, 1]),
        ("Lagrange top", 4, 1, &[0, 1, 2, 3]),
        ("Kovalevskaya top", 3, 0, &[0, 1, 2]),
        ("Goryachev top", 3, 0, &[0, 1, 2]),
        ("Toda", 2, 1, &[0, 1]),
        ("vortices", 3, 2, &[1, 2, 3]),
        // Σ(qq⁺ + pp⁺) and Σ(qp⁺ − pq⁺).
        ("Ablowitz–Ladik", 2, 0, &[]),
        // Along the field nothing but the oscillator acts.
        ("charge", 1, 0, &[]),
        ("three waves", 2, 0, &[1, 2]),
    ];
    for (field, (name, count, linear, known)) in fields().into_iter().zip(expected) {
        assert_eq!(field.name, name);
        let Lowered { mut graph, x, field: f, integrals, .. } = field.lowered();
        let found = kept_along(&mut graph, &x, std::slice::from_ref(&f)).expect("it is short");
        let linears = found.iter().filter(|kept| kept.linear).count();
        assert_eq!((found.len(), linears), (count, linear), "{name}");
        for Kept { value, .. } in &found {
            assert!(is_kept(&mut graph, &x, &f, *value, None).is_zero(), "{name}");
        }
        // Gradients of known ones depend on those that are found.
        let all: Vec<_> = found.iter().map(|kept| kept.value).chain(known.iter().map(|k| integrals[*k])).collect();
        let dependent = dependent(&mut graph, &x, &all).expect("it is decided").integrals;
        assert_eq!(dependent, (count..all.len()).collect::<Vec<_>>(), "{name}");
    }
}

#[test]
fn casimirs_are_found() {
    for field in fields() {
        if field.matrix.is_none() {
            continue;
        }
        let Lowered { mut graph, x, matrix, integrals, .. } = field.lowered();
        let found = kept_along(&mut graph, &x, &matrix).expect("it is short");
        // Toda's Σb; its square is a function of it. None for a charge, three waves, and two species.
        assert_eq!(found.len(), field.casimirs.len(), "{}", field.name);
        let values: Vec<_> = found.iter().map(|kept| kept.value).collect();
        for value in &values {
            assert!(is_casimir(&mut graph, &x, &matrix, *value).is_ok(), "{}", field.name);
        }
        let all = [values, field.casimirs.iter().map(|k| integrals[*k]).collect()].concat();
        let dependent = dependent(&mut graph, &x, &all).expect("it is decided").integrals;
        assert_eq!(dependent.len(), field.casimirs.len(), "{}", field.name);
    }
}

#[test]
fn parameters_stay_symbols() {
    // A heavy body on e(3)*: inertia a, b, c and its centre of mass at d along the third axis.
    let setup = quote! {
        let [m1, m2, m3, g1, g2, g3] = x;
        let (w1, w2, w3) = (m1 / a, m2 / b, m3 / c);
    };
    let field = quote! {[
        m2 * w3 - m3 * w2 + g2 * d, m3 * w1 - m1 * w3 - g1 * d, m1 * w2 - m2 * w1,
        g2 * w3 - g3 * w2, g3 * w1 - g1 * w3, g1 * w2 - g2 * w1
    ]};
    let known = quote! {[
        m1 * w1 + m2 * w2 + m3 * w3 + 2.0 * d * g3, g1 * g1 + g2 * g2 + g3 * g3, m1 * g1 + m2 * g2 + m3 * g3
    ]};
    let (mut graph, found) = arrays(6, &setup, &[&field, &known]);
    let x = coordinates(6);
    let kept = kept_along(&mut graph, &x, &found[..1]).expect("it is short");
    assert_eq!(kept.len(), 3);
    let all: Vec<_> = kept.iter().map(|kept| kept.value).chain(found[1].iter().copied()).collect();
    assert_eq!(dependent(&mut graph, &x, &all).expect("it is decided").integrals, [3, 4, 5]);
}

#[test]
fn multipliers_of_jacobi_are_products_of_powers() {
    let found = |n: usize, field| {
        let (mut graph, fields) = arrays(n, &quote!(), &[&field]);
        multiplier(&mut graph, &coordinates(n), &fields[0])
    };
    let integers = |n: &[i128]| Some(n.iter().map(|n| Ratio::integer(*n)).collect::<Vec<_>>());
    assert_eq!(found(2, quote!([x[0] * (a - b * x[1]), x[1] * (b * x[0] - c)])), integers(&[-1, -1]));
    let epidemic = quote!([-a * x[0] * x[1], a * x[0] * x[1] - b * x[1], b * x[1]]);
    assert_eq!(found(3, epidemic), integers(&[-1, -1, 0]));
    // Without divergence the multiplier is 1; with damping there is none.
    assert_eq!(found(2, quote!([x[1], -x[0] - x[0].powi(3)])), integers(&[0, 0]));
    assert_eq!(found(2, quote!([x[1], -x[0] - x[0].powi(3) - x[1] / 10.0])), None);
    // x' = x² y, y' = x y³ has μ = x⁻²y⁻³, and others.
    assert_eq!(found(2, quote!([2.0 * x[0] * x[1], -3.0 * x[1] * x[1]])).map(|a| a.len()), Some(2));
}

/// A skew matrix with S∇I = f from f and its first integral, whether there is one alone, and whether it is a Poisson structure.
#[test]
fn structures_are_found() {
    for field in fields() {
        let name = field.name;
        let Lowered { mut graph, x, field: f, integrals, .. } = field.lowered();
        let Some(found) = structure(&mut graph, &x, &f, integrals[0]) else {
            println!("{name}: none");
            continue;
        };
        assert!(is_gradient_form(&mut graph, &x, &found.matrix, integrals[0], &f).is_ok(), "{name}");
        let poisson = is_poisson(&mut graph, &x, &found.matrix).is_ok();
        let planes = (0..x.len())
            .flat_map(|i| (i + 1..x.len()).map(move |j| [i, j]))
            .filter(|[i, j]| !graph.is_zero(found.matrix[*i][*j]))
            .count();
        println!("{name}: {} {poisson} {planes}", found.unique);
    }
}

#[test]
#[ignore = "prints times"]
fn times() {
    for field in fields() {
        let Lowered { mut graph, x, field: f, matrix, .. } = field.lowered();
        let start = std::time::Instant::now();
        kept_along(&mut graph, &x, std::slice::from_ref(&f)).expect("it is short");
        let integrals = start.elapsed();
        kept_along(&mut graph, &x, &matrix).expect("it is short");
        println!("{:18} integrals {integrals:?}, Casimirs {:?}", field.name, start.elapsed() - integrals);
    }
}

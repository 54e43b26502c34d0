//! Integrals, Casimirs, multipliers and structure matrices are found from the field alone.

use super::systems::{Lowered, fields};
use super::{arrays, coordinates};
use crate::analyze::claims::{dependent, is_casimir, is_gradient_form, is_kept, is_poisson, is_skew};
use crate::analyze::search::{self, Kept, kept_along, multiplier, structure};
use crate::ir::Ratio;
use quote::quote;

/// For each field: the number of integrals, the number of linear ones, and the known integrals that depend on them.
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
        // Only the oscillator acts along the field.
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
        // Gradients of known integrals depend on gradients of found ones.
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
        // Toda has Σb; its square depends on it. A charge, three waves and two species have none.
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
    // A field with several multipliers.
    assert_eq!(found(2, quote!([2.0 * x[0] * x[1], -3.0 * x[1] * x[1]])).map(|a| a.len()), Some(2));
}

/// For each field, of the skew matrix with S∇I = f for its first integral: uniqueness, Jacobi's identity, and the number of planes.
#[test]
fn structures_are_found() {
    let expected = [
        ("Lotka–Volterra", Some((true, true, 1))),
        ("Euler top", Some((false, true, 2))),
        ("Lorenz core", Some((false, false, 3))),
        ("Volterra lattice", Some((false, true, 4))),
        ("ring", Some((false, false, 2))),
        ("epidemic", Some((false, true, 2))),
        ("Lagrange top", Some((false, false, 6))),
        ("Kovalevskaya top", Some((false, false, 5))),
        ("Goryachev top", Some((false, false, 5))),
        ("Toda", Some((true, true, 6))),
        ("vortices", Some((false, true, 4))),
        // S is the sum in the denominators of ∇I, and not a quotient of terms.
        ("Ablowitz–Ladik", None),
        ("charge", Some((false, true, 4))),
        ("three waves", Some((true, true, 3))),
    ];
    for (field, (name, expected)) in fields().into_iter().zip(expected) {
        assert_eq!(field.name, name);
        let Lowered { mut graph, x, field: f, integrals, .. } = field.lowered();
        let found = structure(&mut graph, &x, &f, integrals[0]).map(|found| {
            assert!(is_gradient_form(&mut graph, &x, &found.matrix, integrals[0], &f).is_ok(), "{name}");
            assert!(is_skew(&mut graph, &x, &found.matrix, &f).is_ok(), "{name}");
            let poisson = is_poisson(&mut graph, &x, &found.matrix, &f).is_ok();
            let entries = found.matrix.iter().flatten().filter(|entry| !graph.is_zero(**entry)).count();
            (found.unique, poisson, entries / 2)
        });
        assert_eq!(found, expected, "{name}");
    }
}

/// The field is not a polynomial, and its integral is linear in a coordinate.
#[test]
fn structures_have_one_row_where_an_integral_is_linear() {
    let field = quote!([x[1].sin(), (x[0] * x[2]).cos(), -x[1].sin() - x[1] * (x[0] * x[2]).cos()]);
    let integral = quote!([x[0] + x[1] * x[1] / 2.0 + x[2]]);
    let (mut graph, found) = arrays(3, &quote!(), &[&field, &integral]);
    let x = coordinates(3);
    let structure = structure(&mut graph, &x, &found[0], found[1][0]).expect("one row");
    assert!(is_gradient_form(&mut graph, &x, &structure.matrix, found[1][0], &found[0]).is_ok());
    // A function that is not an integral has no structure matrix.
    let x0 = graph.symbol(x[0]);
    assert_eq!(search::structure(&mut graph, &x, &found[0], x0), None);
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

//! Claims about fields and their structure matrices are decided. A wrong entry is named with its remainder.

use super::points::word;
use super::systems::{Lowered, fields};
use super::{arrays, coordinates};
use crate::analyze::claims::{dependent, divergence, is_casimir, is_gradient_form, is_kept, is_poisson, is_skew};
use crate::analyze::{Identity, Value};
use crate::ir::print::Printer;
use crate::ir::{Graph, Id, Ratio, Symbol};
use proc_macro2::TokenStream;
use quote::quote;

fn printed(graph: &Graph, id: Id) -> String {
    let name = |symbol| match symbol {
        Symbol::Position(i) => format!("x{i}"),
        Symbol::Time => "t".into(),
        // The parameters follow the weights of the test.
        Symbol::Parameter(i) => format!("c{i}"),
        other => format!("{other:?}"),
    };
    Printer::new(graph, &name).excerpt(id)
}

fn rest(graph: &Graph, verdict: &Identity) -> String {
    verdict.rest().map_or("?".into(), |rest| printed(graph, rest.rest))
}

#[test]
fn matrices_are_skew_and_give_the_field() {
    let mut count = 0;
    for field in fields() {
        let Lowered { mut graph, x, field: f, integrals, matrix } = field.lowered();
        if field.matrix.is_none() {
            continue;
        }
        assert!(is_skew(&mut graph, &x, &matrix, &f).is_ok(), "{}", field.name);
        let form = is_gradient_form(&mut graph, &x, &matrix, integrals[0], &f);
        assert!(form.is_ok(), "{}: {form:?}", field.name);
        for casimir in &field.casimirs {
            let verdict = is_casimir(&mut graph, &x, &matrix, integrals[*casimir]);
            assert!(verdict.is_ok(), "{}: {verdict:?}", field.name);
        }
        // The energy is no Casimir.
        assert!(is_casimir(&mut graph, &x, &matrix, integrals[0]).is_err(), "{}", field.name);
        let poisson = is_poisson(&mut graph, &x, &matrix, &f);
        assert_eq!(poisson.is_ok(), field.name != "Lorenz core", "{}: {poisson:?}", field.name);
        count += 1;
    }
    assert_eq!(count, 11);
}

#[test]
fn the_matrix_of_lorenz_breaks_the_identity_of_jacobi() {
    // S₀₁ = −y, S₀₂ = −z, S₁₂ = −4x.
    let matrix = quote!([0.0, -x[1], -x[2], x[1], 0.0, -4.0 * x[0], x[2], 4.0 * x[0], 0.0]);
    let (mut graph, found) = arrays(3, &quote!(), &[&matrix]);
    let matrix: Vec<Vec<Id>> = found[0].chunks(3).map(<[Id]>::to_vec).collect();
    let Err((indices, verdict)) = is_poisson(&mut graph, &coordinates(3), &matrix, &[]) else { panic!("it holds") };
    assert_eq!((indices, rest(&graph, &verdict).as_str()), ([0, 1, 2], "-8·x0"));
}

#[test]
fn an_entry_that_is_not_skew_is_named() {
    let matrix = quote!([0.0, x[0], x[1], x[0], 0.0, x[2], -x[1], -x[2], 0.0]);
    let (mut graph, found) = arrays(3, &quote!(), &[&matrix]);
    let matrix: Vec<Vec<Id>> = found[0].chunks(3).map(<[Id]>::to_vec).collect();
    let Err((entry, verdict)) = is_skew(&mut graph, &coordinates(3), &matrix, &[]) else { panic!("it is skew") };
    assert_eq!((entry, rest(&graph, &verdict).as_str()), ([0, 1], "2·x0"));
    let diagonal = vec![vec![matrix[0][1]]];
    assert!(matches!(is_skew(&mut graph, &coordinates(1), &diagonal, &[]), Err(([0, 0], _))));
}

#[test]
fn matrices_with_quotients_and_roots_are_decided() {
    // A charge in a field of strength B(x): S = [[0, 1/B], [−1/B, 0]] has no Casimir, and any 2 × 2 matrix is a Poisson structure.
    let b = quote!((1.0 + x[0] * x[0] + x[1] * x[1]).sqrt());
    let skew = |s: TokenStream| quote!([0.0, #s, 0.0, -(#s), 0.0, 0.0, 0.0, 0.0, 0.0]);
    let (mut graph, found) = arrays(3, &quote!(let b = #b;), &[&skew(quote!(1.0 / b)), &quote!([x[2], x[0]])]);
    let matrix: Vec<Vec<Id>> = found[0].chunks(3).map(<[Id]>::to_vec).collect();
    let x = coordinates(3);
    assert!(is_skew(&mut graph, &x, &matrix, &[]).is_ok() && is_poisson(&mut graph, &x, &matrix, &[]).is_ok());
    assert!(is_casimir(&mut graph, &x, &matrix, found[1][0]).is_ok());
    assert!(matches!(is_casimir(&mut graph, &x, &matrix, found[1][1]), Err((1, Identity::Wrong(_)))));
}

#[test]
fn what_remains_of_a_wrong_integral_is_named_with_a_state() {
    let goryachev = fields().into_iter().find(|field| field.name == "Goryachev top").expect("it is in the list");
    let Lowered { mut graph, x, field, integrals, .. } = goryachev.lowered();
    let Identity::Wrong(wrong) = is_kept(&mut graph, &x, &field, integrals[3], None) else { panic!("not refuted") };
    // −x₁·(x₀x₃ + x₁x₄ + x₂x₅). The claim holds where m·γ = 0.
    let rest = wrong.rest.expect("it is short");
    assert_eq!(printed(&graph, rest.rest), "-x1·x2·x5 - x0·x1·x3 - x1²·x4");
    assert!(wrong.witness.state.iter().all(|(_, value)| *value == Ratio::ONE));
    assert_eq!(wrong.witness.value, Value::Exact(Ratio::integer(-3)));
}

#[test]
fn time_forcing_and_loss_are_accounted_for() {
    let field = quote!([x[1], -x[0] + a * (2.0 * t).sin() - b * x[1]]);
    let integrals =
        quote!([(x[0] * x[0] + x[1] * x[1]) / 2.0, x[0] * t.cos() - x[1] * t.sin(), x[0] * t.cos() + x[1] * t.sin()]);
    let but = quote!([0.0, a * (2.0 * t).sin() - b * x[1]]);
    let free = quote!([x[1], -x[0]]);
    let (mut graph, found) = arrays(2, &quote!(), &[&field, &integrals, &but, &free]);
    let [field, integrals, but, free] = &found[..] else { panic!("four arrays") };
    let x = coordinates(2);
    assert_eq!(word(&is_kept(&mut graph, &x, field, integrals[0], None)), "wrong");
    assert!(is_kept(&mut graph, &x, field, integrals[0], Some(but)).is_zero());
    assert!(is_kept(&mut graph, &x, free, integrals[0], None).is_zero());
    // An integral that depends on time, and its variant with a wrong sign.
    assert!(is_kept(&mut graph, &x, free, integrals[1], None).is_zero());
    assert_eq!(word(&is_kept(&mut graph, &x, free, integrals[2], None)), "wrong");
}

#[test]
fn divergences_are_found() {
    let fields = quote!([x[0] * t - 2.0 * x[1], x[0] + 2.0 * x[1], x[0] * t + 2.0 * x[1], x[0] * x[0] - x[1] * t]);
    let (mut graph, found) = arrays(2, &quote!(), &[&fields]);
    let (value, verdict) = divergence(&mut graph, &coordinates(2), &found[0][..2]);
    assert_eq!((printed(&graph, value).as_str(), verdict.is_zero()), ("t + 2", false));
    assert!(divergence(&mut graph, &coordinates(2), &found[0][2..]).1.is_zero());
}

#[test]
fn dependent_integrals_are_named() {
    for field in fields() {
        let Lowered { mut graph, x, integrals, .. } = field.lowered();
        let found = dependent(&mut graph, &x, &integrals).expect("it is decided");
        // Lagrange's top, for example, has four independent integrals.
        assert_eq!(found.integrals, Vec::<usize>::new(), "{}", field.name);
    }
    let integrals = quote!([
        (x[0] * x[0] + x[1] * x[1]).sqrt(),
        x[2].sin(),
        (x[0] * x[0] + x[1] * x[1]).ln() * (1.0 + x[2].cos().powi(2)),
        x[0] + x[1],
        x[2]
    ]);
    let (mut graph, found) = arrays(3, &quote!(), &[&integrals]);
    let found = dependent(&mut graph, &coordinates(3), &found[0]).expect("it is decided");
    assert_eq!(found.integrals, [2, 4]);
    assert!(found.bound.bits > 80, "{found:?}");
}

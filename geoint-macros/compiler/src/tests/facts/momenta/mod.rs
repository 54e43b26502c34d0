//! Conserved momenta that the compiler finds. Each must be constant along the flow and over a step. Other momenta must not be claimed.

mod linear;

use super::super::{Noise, lowered};
use crate::ir::print::Printer;
use crate::ir::{Graph, Id, Symbol};
use crate::tests::eval::eval;
use crate::{analyze, diff};
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::HashMap;

/// Returns the change of J along the flow and over a step with the discrete gradient, relative to the sum of magnitudes.
fn changes(graph: &mut Graph, energy: Id, j: Id, degrees: u32) -> (f64, f64) {
    let gradient = [j, energy].map(|root| diff::gradient(graph, root, degrees));
    let tree = diff::discrete_gradient(graph, energy, degrees);
    let mut noise = Noise(7);
    let mut values: HashMap<Symbol, f64> = HashMap::new();
    for id in graph.ids_from(0) {
        if let crate::ir::Node::Symbol(symbol) = graph.node(id) {
            values.insert(*symbol, noise.between(0.3, 1.4));
        }
    }
    let start = |symbol| values[&symbol];
    let middle = |symbol| match symbol {
        Symbol::Position(i) => values[&symbol] + values.get(&Symbol::PositionIncrement(i)).unwrap_or(&0.0) / 2.0,
        Symbol::Momentum(i) => values[&symbol] + values.get(&Symbol::MomentumIncrement(i)).unwrap_or(&0.0) / 2.0,
        _ => values[&symbol],
    };
    let bracket = |of_j: &dyn Fn(Id) -> f64, of_h: &diff::Gradient| {
        let (mut sum, mut magnitude) = (0.0, 0.0);
        for i in 0..degrees as usize {
            let first = of_j(gradient[0].q[i]) * eval(graph, of_h.p[i], &start);
            let second = of_j(gradient[0].p[i]) * eval(graph, of_h.q[i], &start);
            sum += first - second;
            magnitude += first.abs() + second.abs();
        }
        sum / magnitude.max(1.0)
    };
    let flow = bracket(&|id| eval(graph, id, &start), &gradient[1]);
    let step = bracket(&|id| eval(graph, id, &middle), &tree);
    (flow.abs(), step.abs())
}

/// Returns names and formulas of the momenta of an energy, and checks that each is conserved.
fn momenta(item: TokenStream) -> Vec<String> {
    let (energy, mut lowered) = lowered(item);
    let graph = &mut lowered.graph;
    let structure = analyze::structure(graph, lowered.terms.energy, &energy.coordinates.shape);
    for momentum in &structure.momenta {
        let (flow, step) = changes(graph, lowered.terms.energy, momentum.value, energy.degrees());
        assert!(flow < 1e-14, "{} {flow:e}", momentum.name);
        assert!(step < 1e-14, "{} {step:e}", momentum.name);
    }
    let name = |symbol| match symbol {
        Symbol::Position(i) => format!("q{i}"),
        Symbol::Momentum(i) => format!("p{i}"),
        Symbol::Parameter(i) => format!("c{i}"),
        _ => "t".into(),
    };
    let printer = Printer::new(graph, &name);
    structure.momenta.iter().map(|j| format!("{}: {}", j.name, printer.formula(j.value))).collect()
}

/// Returns an energy in the plane with equal masses and a potential.
fn planar(potential: TokenStream) -> TokenStream {
    quote! {
        fn f(q: [f64; 2], p: [f64; 2], t: f64, m: f64, k: f64) -> f64 {
            (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + { #potential }
        }
    }
}

#[test]
fn angular_momentum_of_central_forces_in_the_plane() {
    let potentials = [
        quote! { -k / (q[0] * q[0] + q[1] * q[1]).sqrt() },
        quote! { k * (q[0].powi(2) + q[1].powi(2)).powi(3) },
        quote! { -k / q[0].hypot(q[1]) },
        quote! { (q[0].hypot(q[1]).hypot(k) - 1.0).powi(2) },
        quote! { let r = (q[0] * q[0] + q[1] * q[1]).sqrt(); (1.0 - (k - r).exp()).powi(2) + k * r.ln() },
        quote! { (q[0] * q[0] + q[1] * q[1]).sqrt() * (t * k).sin() },
        // The terms of a rotation-invariant sum are apart.
        quote! { let r = q[0] * q[0] + q[1] * q[1]; k * q[0] * q[0] + r * r + k * q[1] * q[1] },
        quote! { let r = q[0] * q[0] + q[1] * q[1]; k * (r.exp() + q[0] * q[0]) + q[1] * q[1] * k },
        // A product of invariants: the step conserves the momentum as well.
        quote! { (q[0] * q[0] + q[1] * q[1] + k) * (q[0] * p[1] - q[1] * p[0]).cos() * (q[0] * p[0] + q[1] * p[1]) },
        // The parameters are equal after simplification.
        quote! { (q[0] * q[0] * k * m * m + q[1] * q[1] / (1.0 / (m * k * m))).sqrt() },
        quote! { (0.00028558373315105 * q[0] * q[0] + 0.00028558373315105 * q[1] * q[1]).sqrt() },
        // Both sides of a condition on parameters. The minimum of two numbers is a sum with |a − b|.
        quote! { let r = q[0] * q[0] + q[1] * q[1]; if k > 1.0 { r.sqrt() } else { -1.0 / r } },
        quote! { let r = q[0] * q[0] + q[1] * q[1]; r.min(r.sqrt()) },
    ];
    for potential in potentials {
        let text = potential.to_string();
        assert_eq!(momenta(planar(potential)), ["angular momentum: q0·p1 - q1·p0"], "{text}");
    }
}

#[test]
fn angular_momentum_of_vectors() {
    let about = [
        "angular momentum about x: q1·p2 - q2·p1",
        "angular momentum about y: q2·p0 - q0·p2",
        "angular momentum about z: q0·p1 - q1·p0",
    ];
    let kepler = quote! {
        fn f(q: Vector3<f64>, p: Vector3<f64>, m: f64, k: f64) -> f64 { p.norm_squared() / (2.0 * m) - k / q.norm() }
    };
    assert_eq!(momenta(kepler), about);
    let nested = quote! {
        fn f(q: [f64; 3], p: [f64; 3], m: f64, k: f64) -> f64 {
            (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) - k / q[0].hypot(q[1]).hypot(q[2])
        }
    };
    assert_eq!(momenta(nested), about);
    let field = quote! {
        fn f(q: [f64; 3], p: [f64; 3], m: f64, k: f64) -> f64 {
            let r = (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt();
            (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) - k / r + (k * q[2]).cos()
        }
    };
    assert_eq!(momenta(field), about[2..]);
}

/// Returns (q₀² + q₁²)³, multiplied out.
fn expanded() -> TokenStream {
    quote! { let [x, y] = q.map(|q| q * q); x.powi(3) + 3.0 * x * y * (x + y) + y.powi(3) }
}

/// The flow may conserve the momentum. A claim would be wrong for a step, or is not proven.
#[test]
fn angular_momentum_is_not_claimed() {
    let potentials = [
        quote! { -k / (q[0] * q[0] + 2.0 * q[1] * q[1]).sqrt() },
        quote! { -k / (q[0] * q[0] + k * q[1] * q[1]).sqrt() },
        quote! { q[1].atan2(q[0]) },
        quote! { (q[1].atan2(q[0]) - p[1].atan2(p[0])).cos() },
        quote! { (q[0] * q[0]).hypot(q[1] * q[1]) },
        expanded(),
        quote! { let r = q[0] * q[0] + q[1] * q[1]; if r > 1.0 { r.sqrt() } else { r * r } },
        quote! { let r = q[0] * q[0] + q[1] * q[1]; if q[0] > k { r.sqrt() } else { r * r } },
        quote! { q[0] * q[0] * q[1] - q[1].powi(3) / 3.0 + (q[0] * q[0] + q[1] * q[1]) / 2.0 },
        // The numbers differ in the last digit.
        quote! { (0.10000000000000001 * q[0] * q[0] + 0.10000000000000002 * q[1] * q[1]).sqrt() },
    ];
    for potential in potentials {
        let text = potential.to_string();
        assert_eq!(momenta(planar(potential)), Vec::<String>::new(), "{text}");
    }
    let masses = quote! {
        fn f(q: [f64; 2], p: [f64; 2], m: [f64; 2]) -> f64 {
            p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]) - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
        }
    };
    assert_eq!(momenta(masses), Vec::<String>::new());
}

/// The control: an expanded potential changes the momentum in a step, but not along the flow.
#[test]
fn an_expanded_central_force_turns_the_step_but_not_the_flow() {
    let (_, mut lowered) = lowered(planar(expanded()));
    let graph = &mut lowered.graph;
    let [q, p] = [Symbol::Position, Symbol::Momentum].map(|symbol| [0, 1].map(|i| graph.symbol(symbol(i))));
    let (first, second) = (graph.mul(q[0], p[1]), graph.mul(q[1], p[0]));
    let angular = graph.sub(first, second);
    let (flow, step) = changes(graph, lowered.terms.energy, angular, 2);
    assert!(flow < 1e-14 && step > 1e-3, "{flow:e} {step:e}");
}

/// Returns a random function of some parts.
fn composed(parts: &[&str], depth: u32, noise: &mut Noise) -> String {
    if depth == 0 {
        return parts[noise.between(0.0, parts.len() as f64) as usize].into();
    }
    let [a, b] = [(); 2].map(|()| composed(parts, depth - 1, noise));
    match noise.between(0.0, 6.0) as u32 {
        0 => format!("({a} + k * {b})"),
        1 => format!("m * ({a} + {b} - 2.0)"),
        2 => format!("{a} * {b} / m"),
        3 => format!("({a} + k * {b}).sin()"),
        4 => format!("(k + ({a}).powi(2)).sqrt() * {b}"),
        _ => format!("{a} / (k + ({b}).powi(2))"),
    }
}

/// A function of invariants conserves the momentum. One part that is not invariant destroys the conservation.
#[test]
fn random_functions_of_invariants() {
    let invariants = ["(q[0] * q[0] + q[1] * q[1])", "p.norm_squared()", "q.dot(&p)", "(q[0] * p[1] - q[1] * p[0])"];
    let others = ["q[0]", "(q[0] + k)", "q[0] * p[1]", "(k * q[0] * q[0] + q[1] * q[1])", "(q[0] - 1.0).powi(2)"];
    let mut noise = Noise(5);
    for i in 0..100 {
        let mut body = composed(&invariants, 3, &mut noise);
        let spoilt = i % 2 == 0;
        if spoilt {
            let part = invariants.iter().find(|part| body.contains(**part)).expect("a part");
            body = body.replacen(part, others[i % 5], 1);
        }
        let body: TokenStream = body.parse().expect("tokens");
        let item = quote! { fn f(q: Vector2<f64>, p: Vector2<f64>, m: f64, k: f64) -> f64 { #body } };
        let found = momenta(item.clone());
        assert_eq!(found.iter().any(|line| line.starts_with("angular momentum: q0·p1 - q1·p0")), !spoilt, "{item}");
    }
}

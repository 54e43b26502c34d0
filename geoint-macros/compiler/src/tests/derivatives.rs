//! Compares derivatives with difference quotients, for all functions of the table.

use super::{Noise, graph_of, lowered};
use crate::diff;
use crate::ir::op::{Domain, Entry, FUNCTIONS};
use crate::ir::{Function, Id, Ratio, Symbol};
use crate::tests::eval::eval;
use quote::quote;

const Q: Symbol = Symbol::Position(0);

/// Returns a random point inside the domain of a function's argument, away from the ends.
fn argument(function: Function, noise: &mut Noise) -> f64 {
    match function.entry().domain {
        Domain::Everywhere => noise.between(-1.5, 1.5),
        Domain::Interval(low, high, _) => {
            let high = if high.is_finite() { high } else { low + 3.0 };
            let margin = 0.1 * (high - low);
            noise.between(low + margin, high - margin)
        }
    }
}

/// Returns f'(x) by a difference quotient of order 4.
fn quotient(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    let h = 1e-3;
    (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h)
}

#[test]
fn every_function_has_its_derivative() {
    let mut noise = Noise(1);
    // Nothing differentiates these functions twice: Newton's matrices need derivatives of slopes once, and some flows give their momenta without
    // derivatives.
    let once = |entry: &Entry| {
        entry.name.ends_with("_derivative") && entry.function != Function::AbsSlopeDerivative
            || Function::KEPLER.contains(&entry.function)
            || Function::LINEAR_FLOW.contains(&entry.function)
            || matches!(
                entry.function,
                Function::FlowMatrix | Function::FlowChange | Function::Spread | Function::Swept
            )
            || entry.function == Function::DecayMean
    };
    for entry in FUNCTIONS.iter().filter(|entry| !once(entry)) {
        // A third argument is an exponent that does not vary.
        for place in 0..entry.arity.min(2) {
            let (mut graph, q) = graph_of(Q);
            let x = argument(entry.function, &mut noise);
            // Helpers do not state their domain. All of them are defined here.
            let x = if entry.public { x } else { 0.5 + x.abs() };
            // `AtMost`, `Provided` and `Bounded` compare their arguments. This value decides the comparison for all x.
            let other = match entry.function {
                Function::AtMost | Function::Provided => [4.0, 0.25][place],
                Function::Bounded => [1e3, 0.25][place],
                _ => 0.75,
            };
            let mut args = vec![graph.number(crate::ir::Number::float(other)); entry.arity];
            args[place] = q;
            let value = graph.call(entry.function, &args);
            let slope = diff::gradient(&mut graph, value, 1).q[0];
            let at = |root: Id, x: f64| eval(&graph, root, &|_| x);
            let (found, expected) = (at(slope, x), quotient(|x| at(value, x), x));
            assert!((found - expected).abs() < 1e-8 * (1.0 + expected.abs()), "{} {found} {expected}", entry.name);
        }
    }
}

#[test]
fn powers_have_their_derivative() {
    for n in -7..=7_i64 {
        for denominator in [1, 2] {
            let exponent = Ratio::new(n.into(), denominator).unwrap();
            let (mut graph, q) = graph_of(Q);
            let power = graph.pow(q, exponent);
            let slope = diff::gradient(&mut graph, power, 1).q[0];
            let expected = exponent.to_f64() * 1.3_f64.powf(exponent.to_f64() - 1.0);
            let found = eval(&graph, slope, &|_| 1.3);
            assert!((found - expected).abs() <= 1e-14 * expected.abs(), "{exponent:?} {found} {expected}");
        }
    }
}

/// ∇̄H·(x₁ − x₀) = H(x₁) − H(x₀) for an energy with many kinds of terms. For a zero step, ∇̄H is the gradient.
#[test]
fn the_discrete_gradient_satisfies_the_discrete_chain_rule() {
    let (_, mut lowered) = lowered(quote! {
        fn mixed(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
            let r = (q[0] * q[0] + 2.0 * q[1] * q[1] + 1.0).sqrt();
            p[0] * p[0] / (2.0 * m * r) + p[1].powi(3) * (q[0] - 3.0 * q[1]).sin() * q[1].exp()
                - (p[0] * q[1]).cos() / (2.0 + r.ln()) + (q[0] * p[1] * r).powi(2)
        }
    });
    let graph = &mut lowered.graph;
    let slopes = diff::discrete_gradient(graph, lowered.terms.energy, 2);
    let gradient = diff::gradient(graph, lowered.terms.energy, 2);
    let mut noise = Noise(7);
    for _ in 0..200 {
        let mut draw = |size: f64| [(); 4].map(|()| noise.between(-size, size));
        let (x, d) = (draw(1.5), draw(1.0));
        let at = |shift: f64| {
            move |symbol: Symbol| match symbol {
                Symbol::Position(i) => x[i as usize] + shift * d[i as usize],
                Symbol::Momentum(i) => x[2 + i as usize] + shift * d[2 + i as usize],
                Symbol::PositionIncrement(i) => d[i as usize],
                Symbol::MomentumIncrement(i) => d[2 + i as usize],
                _ => 1.7,
            }
        };
        let roots = [&slopes.q[..], &slopes.p[..]].concat();
        let along: f64 = roots.iter().zip(d).map(|(root, d)| eval(graph, *root, &at(0.0)) * d).sum();
        let change = eval(graph, lowered.terms.energy, &at(1.0)) - eval(graph, lowered.terms.energy, &at(0.0));
        assert!((along - change).abs() < 1e-12 * (1.0 + change.abs()), "{along} {change}");

        let still = |symbol: Symbol| {
            if matches!(symbol, Symbol::PositionIncrement(_) | Symbol::MomentumIncrement(_)) {
                0.0
            } else {
                at(0.0)(symbol)
            }
        };
        for (slope, derivative) in roots.iter().zip(gradient.q.iter().chain(&gradient.p)) {
            let (slope, derivative) = (eval(graph, *slope, &still), eval(graph, *derivative, &still));
            assert!((slope - derivative).abs() < 1e-12 * (1.0 + derivative.abs()));
        }
    }
}

/// The derivative at a branch is the derivative of the chosen side.
#[test]
fn a_branch_is_differentiated_on_each_side() {
    let (_, mut lowered) = lowered(quote! {
        fn soft_wall(q: f64, p: f64) -> f64 {
            p * p / 2.0 + if q < 0.5 { (q - 0.5).powi(2) * 3.0 } else { 0.25 * (q - 0.5).ln_1p() }
        }
    });
    let graph = &mut lowered.graph;
    let slope = diff::gradient(graph, lowered.terms.energy, 1).q[0];
    for x in [-0.3, 0.2, 0.8, 2.0] {
        let expected = quotient(|x| eval(graph, lowered.terms.energy, &|_| x) - x * x / 2.0, x);
        assert!((eval(graph, slope, &|_| x) - expected).abs() < 1e-9);
    }
}

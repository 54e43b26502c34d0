//! Mean velocities of conservative steps: they conserve the integrals, and their derivatives are complete.

mod boundaries;
mod measures;
mod messages;
mod reports;
mod turns;

use super::{Noise, lowered_by};
use crate::derive::{Flow, proof};
use crate::diff::field::Field;
use crate::diff::flow::{self, Order};
use crate::ir::{Graph, Symbol};
use crate::parse::Form;
use crate::tests::eval::eval;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns a field and its integrals as nodes. Checks that the integrals are conserved and independent.
fn field(args: &TokenStream, item: &TokenStream) -> (Graph, Flow) {
    let (energy, mut lowered) = lowered_by(Form::Field, args.clone(), item.clone());
    let flow = Flow::of_field(&lowered.terms.field, energy.options.keeps.iter().zip(&lowered.terms.keeps));
    let found = proof::integrals(&mut lowered.graph, &flow);
    let kept = found.kept.iter().all(|verdict| verdict.is_zero());
    assert!(kept && found.dependent.is_none(), "{:?}", found);
    (lowered.graph, flow)
}

/// Returns systems of one to four integrals. One depends on time, one has a loss.
fn fields() -> Vec<(Graph, Flow)> {
    let all = [
        (
            quote!(keeps(wealth = d * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln())),
            quote! { fn f(x: [f64; 2], a: f64, b: f64, c: f64, d: f64) -> [f64; 2] {
                [x[0] * (a - b * x[1]), x[1] * (d * x[0] - c)]
            } },
        ),
        (
            quote!(keeps(
                energy = (a * x[0] * x[0] + b * x[1] * x[1] + c * x[2] * x[2]) / 2.0,
                momentum = (a * a * x[0] * x[0] + b * b * x[1] * x[1] + c * c * x[2] * x[2]) / 2.0,
            )),
            quote! { fn f(x: [f64; 3], a: f64, b: f64, c: f64) -> [f64; 3] {
                [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
            } },
        ),
        (
            quote!(keeps(
                sum = x.iter().sum::<f64>(),
                product = (x[0] * x[2] * x[4]).ln(),
                third = {
                    let squares: f64 = x.iter().map(|x| x * x).sum();
                    squares / 2.0 + (0..4).map(|i| x[i] * x[i + 1]).sum::<f64>()
                }
            )),
            quote! { fn f(x: [f64; 5]) -> [f64; 5] {
                [x[0] * x[1], x[1] * (x[2] - x[0]), x[2] * (x[3] - x[1]), x[3] * (x[4] - x[2]), -x[4] * x[3]]
            } },
        ),
        (
            // Lagrange's top.
            quote!(keeps(
                energy = (x[0] * x[0] + x[1] * x[1]) / 4.0 + x[2] * x[2] / 2.0 + l * x[5],
                length = x[3] * x[3] + x[4] * x[4] + x[5] * x[5],
                along = x[0] * x[3] + x[1] * x[4] + x[2] * x[5],
                spin = x[2],
            )),
            quote! { fn f(x: [f64; 6], l: f64) -> [f64; 6] {
                let [m0, m1, m2, g0, g1, g2] = x;
                let [u, v, w] = [m0 / 2.0, m1 / 2.0, m2];
                [
                    m1 * w - m2 * v + g1 * l,
                    m2 * u - m0 * w - g0 * l,
                    m0 * v - m1 * u,
                    g1 * w - g2 * v,
                    g2 * u - g0 * w,
                    g0 * v - g1 * u,
                ]
            } },
        ),
        (
            // A non-autonomous oscillator: (x, y) turns with a frequency that rises.
            quote!(keeps(
                radius = x[0] * x[0] + x[1] * x[1],
                begun = x[0] * (w * t * t).cos() - x[1] * (w * t * t).sin(),
            )),
            quote! { fn f(x: [f64; 3], t: f64, w: f64) -> [f64; 3] {
                [2.0 * w * t * x[1], -2.0 * w * t * x[0], x[0] * x[2]]
            } },
        ),
        (
            quote!(keeps(
                half_square = (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / 2.0,
                but = [a * (f - x[0]), g - x[1], -x[2]],
            )),
            quote! { fn h(x: [f64; 3], a: f64, b: f64, f: f64, g: f64) -> [f64; 3] {
                [
                    -x[1] * x[1] - x[2] * x[2] + a * (f - x[0]),
                    x[0] * x[1] - b * x[0] * x[2] + g - x[1],
                    b * x[0] * x[1] + x[0] * x[2] - x[2],
                ]
            } },
        ),
    ];
    all.iter().map(|(args, item)| field(args, item)).collect()
}

const T: f64 = 0.7;

/// Returns random values of symbols. Increments are at most 0.1.
fn point(noise: &mut Noise, h: f64) -> impl Fn(Symbol) -> f64 + Clone {
    let x: [f64; 8] = std::array::from_fn(|_| noise.between(0.3, 1.5));
    let d: [f64; 8] = std::array::from_fn(|_| noise.between(-0.1, 0.1));
    let a: [f64; 8] = std::array::from_fn(|_| noise.between(0.5, 2.0));
    move |symbol| match symbol {
        Symbol::Position(i) => x[i as usize],
        Symbol::PositionIncrement(i) => d[i as usize],
        Symbol::Parameter(i) => a[i as usize],
        Symbol::Time => T,
        Symbol::StepStart => T - 0.5 * h,
        Symbol::StepEnd => T + 0.5 * h,
        Symbol::StepLength => h,
        other => panic!("{other:?}"),
    }
}

/// Returns the increment d of a step, which solves d = h·v(d), by iteration. Only for this increment, h·ḡ·v is the change of the integral.
fn solved<'a>(graph: &'a Graph, v: &'a Field, at: impl Fn(Symbol) -> f64 + Clone + 'a, h: f64) -> Vec<f64> {
    let mut d = vec![0.0; v.f.len()];
    for _ in 0..30 {
        let here = with(at.clone(), d.clone());
        d = v.f.iter().map(|f| h * eval(graph, *f, &here)).collect();
    }
    d
}

/// Replaces the increments.
fn with(at: impl Fn(Symbol) -> f64, d: Vec<f64>) -> impl Fn(Symbol) -> f64 {
    move |symbol| match symbol {
        Symbol::PositionIncrement(i) => d[i as usize],
        other => at(other),
    }
}

#[test]
fn steps_keep_every_integral_to_rounding() {
    let mut noise = Noise(1);
    for (mut graph, flow) in fields() {
        let conserved: Vec<_> = flow.kept.iter().map(|kept| kept.conserved.clone()).collect();
        for order in [Order::Two, Order::Four] {
            let v = flow::mean_velocity(&mut graph, &flow.field, &conserved, order);
            let h = 0.05;
            for _ in 0..2 {
                let at = point(&mut noise, h);
                let d = solved(&graph, &v, at.clone(), h);
                let ends = [(0.0, -0.5), (1.0, 0.5)].map(|(part, shift)| {
                    let (at, d) = (at.clone(), d.clone());
                    move |symbol| match symbol {
                        Symbol::Position(i) => at(symbol) + part * d[i as usize],
                        Symbol::Time => T + shift * h,
                        other => at(other),
                    }
                });
                for kept in &conserved {
                    let [before, after] = [&ends[0], &ends[1]].map(|end| eval(&graph, kept.value, end));
                    let change = after - before;
                    if kept.but.is_some() {
                        assert!(change.abs() > 1e-4, "the loss does nothing: {change:e}");
                    } else {
                        assert!(change.abs() < 4e-15 * (1.0 + before.abs()), "{order:?} {change:e}");
                        // The control: without projection, the velocity differs.
                        let free = flow::mean_velocity(&mut graph, &flow.field, &[], order);
                        assert!(free.f != v.f);
                    }
                }
            }
        }
    }
}

/// Compares the Jacobian for Newton's method with difference quotients of order 4, at points that solve no step.
#[test]
fn derivatives_of_mean_velocities_are_complete() {
    let mut noise = Noise(2);
    for (mut graph, flow) in fields() {
        let conserved: Vec<_> = flow.kept.iter().map(|kept| kept.conserved.clone()).collect();
        for order in [Order::Two, Order::Four] {
            let v = flow::mean_velocity(&mut graph, &flow.field, &conserved, order);
            let at = point(&mut noise, 0.2);
            for (i, f) in v.f.iter().enumerate() {
                for (j, unknown) in v.unknowns.iter().enumerate() {
                    let moved = |step: f64| {
                        let at = at.clone();
                        eval(&graph, *f, &|symbol| if symbol == *unknown { at(symbol) + step } else { at(symbol) })
                    };
                    let e = 1e-3;
                    let quotient = (8.0 * (moved(e) - moved(-e)) - (moved(2.0 * e) - moved(-2.0 * e))) / (12.0 * e);
                    let found = eval(&graph, v.jacobian[i][j], &at);
                    assert!((found - quotient).abs() < 1e-9 * (1.0 + quotient.abs()), "{order:?} {found} {quotient}");
                }
            }
        }
    }
}

/// In a permanent rotation, two gradients are parallel. The projection drops one of them.
#[test]
fn dependent_and_zero_gradients_are_dropped() {
    let (mut graph, flow) = fields().swap_remove(1);
    let conserved: Vec<_> = flow.kept.iter().map(|kept| kept.conserved.clone()).collect();
    for order in [Order::Two, Order::Four] {
        let v = flow::mean_velocity(&mut graph, &flow.field, &conserved, order);
        for x in [[0.0, 0.0, 1.3], [0.0; 3], [1e-200, 0.0, 0.0]] {
            let at = |symbol| match symbol {
                Symbol::Position(i) => x[i as usize],
                Symbol::PositionIncrement(_) => 0.0,
                Symbol::Parameter(i) => f64::from(i + 1),
                _ => 0.1,
            };
            for node in v.f.iter().chain(v.jacobian.iter().flatten()) {
                assert!(eval(&graph, *node, &at).is_finite(), "{order:?} {x:?}");
            }
        }
    }
}

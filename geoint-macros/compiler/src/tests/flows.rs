//! Tests the functions inside flows with hundreds of digits, and random pieces by their differential equations.

use super::fuzz::{config, config_of, one_of};
use super::precise::{Big, big};
use super::{Noise, lowered_by};
use crate::ir::{Graph, Id, Symbol};
use crate::parse::Form;
use crate::split::{self, Clock, Piece};
use crate::tests::eval::eval;
use geoint_runtime::private::slope;
use proc_macro2::TokenStream;
use proptest::prelude::*;
use proptest::sample::select;

const BITS: usize = 450;

fn exact(x: f64) -> Big {
    big(x, BITS)
}

/// Returns cos √x and sin √x/√x, or for x < 0 cosh √−x and sinh √−x/√−x.
fn stumpff(x: &Big) -> [Big; 2] {
    if *x < Big::ZERO {
        let root = (-x).sqrt();
        [root.cosh(), root.sinh() / root]
    } else {
        let root = x.sqrt();
        [root.cos(), root.sin() / root]
    }
}

fn phi_1(x: &Big) -> Big {
    x.exp_m1() / x
}

fn phi_1_derivative(x: &Big) -> Big {
    (x.exp() * (x - exact(1.0)) + exact(1.0)) / (x * x)
}

fn stumpff_c1_derivative(x: &Big) -> Big {
    let [c0, c1] = stumpff(x);
    (c0 - c1) / (x + x)
}

/// A helper of the runtime: its name, function, exact function, and range.
type Helper = (&'static str, fn(f64) -> f64, fn(&Big) -> Big, [f64; 2]);

const HELPERS: [Helper; 5] = [
    ("phi_1", slope::phi_1, phi_1, [-1e4, 700.0]),
    ("phi_1_derivative", slope::phi_1_derivative, phi_1_derivative, [-1e4, 700.0]),
    ("stumpff_c0", slope::stumpff_c0, |x| stumpff(x)[0].clone(), [-4e5, 1e6]),
    ("stumpff_c1", slope::stumpff_c1, |x| stumpff(x)[1].clone(), [-4e5, 1e6]),
    ("stumpff_c1_derivative", slope::stumpff_c1_derivative, stumpff_c1_derivative, [-4e5, 1e6]),
];

/// The mean of a power of r/(r + (1 − r)v) is accurate relative to its value and its condition in r and k.
#[test]
fn means_of_decay_are_accurate() {
    let exact_mean = |r: &Big, k: &Big| {
        let (one, ln) = (exact(1.0), r.ln());
        let above = r - (&ln * k).exp();
        above / ((k - &one) * (one - r))
    };
    let mut noise = Noise(7);
    for kind in 0..2 * config().cases {
        let near_one = |noise: &mut Noise| 1.0 + noise.between(-1.0, 1.0).signum() * noise.between(-30.0, -1.0).exp();
        let r = if kind % 3 == 0 { near_one(&mut noise) } else { noise.between(-12.0, 3.0).exp() };
        let k = if kind % 2 == 0 { near_one(&mut noise) } else { noise.between(-4.0, 12.0) };
        let at = |r: f64, k: f64| exact_mean(&exact(r), &exact(k)).to_f64().value();
        let (found, expected) = (slope::decay_mean(r, k), at(r, k));
        let gap = 1.0 + 1e-6;
        let condition = expected.abs()
            + [at(r * gap, k), at(r, k * gap)].map(|moved| (moved - expected).abs() / 1e-6).iter().sum::<f64>();
        assert!(
            (found - expected).abs() <= 4.0 * f64::EPSILON * condition,
            "r = {r}, k = {k}: {found:e}, not {expected:e}"
        );
    }
    for k in [0.01, 0.5, 1.0, 1.7, 2.0, 40.0] {
        assert_eq!(slope::decay_mean(0.0, k), 0.0);
        assert_eq!(slope::decay_mean(0.0_f32, k as f32), 0.0);
        assert!((slope::decay_mean(1.0_f64, k) - 1.0).abs() <= f64::EPSILON);
    }
    assert!((slope::decay_mean(0.25_f64, 1.0) - 0.25 * 4.0_f64.ln() / 0.75).abs() < 1e-16);
}

/// The error is relative to the value and to its change for one ε of x.
#[test]
fn helpers_are_accurate() {
    let mut noise = Noise(7);
    for (name, found, expected, [low, high]) in HELPERS {
        let mut worst = 0.0_f64;
        for kind in 0..2 * config().cases {
            let sign = noise.between(-1.0, 1.0).signum();
            let x = match kind % 5 {
                0 => sign * noise.between(-60.0, 0.0).exp(),
                1 => sign * noise.between(-6.0, 3.0).exp(),
                // The ends of the series.
                2 => sign * [0.015625, 1.0, 4.0][kind as usize / 5 % 3] * (1.0 + noise.between(-1e-12, 1e-12)),
                _ => noise.between(low, high),
            };
            let (there, gap) = (exact(x), exact(x) * exact(2_f64.powi(-100)));
            let value = expected(&there);
            let size = |x: &Big| x.to_f64().value().abs();
            let change = size(&(expected(&(&there + &gap)) - &value)) * 2_f64.powi(100);
            let error = size(&(exact(found(x)) - &value)) / (size(&value) + change) / f64::EPSILON;
            assert!(error <= 3.0, "{name}({x:e}) = {:e}: {error:.2} ε", found(x));
            worst = worst.max(error);
        }
        println!("{name:24} {worst:.2} ε");
    }
}

/// Values at zero, near zero, and far away.
#[test]
fn helpers_have_limits() {
    for x in [0.0, -0.0, 5e-324, -1e-300, 1e-40] {
        let found = [slope::phi_1(x), slope::phi_1_derivative(x), slope::stumpff_c0(x), slope::stumpff_c1(x)];
        assert_eq!(found, [1.0, 0.5, 1.0, 1.0]);
        assert_eq!(slope::stumpff_c1_derivative(x), -1.0 / 6.0);
    }
    assert_eq!([slope::phi_1(-1e4), slope::phi_1_derivative(-1e4)], [1e-4, 1e-8]);
    assert!(
        [slope::phi_1(f64::NAN), slope::stumpff_c0(f64::NAN), slope::stumpff_c1(f64::NAN)].iter().all(|x| x.is_nan())
    );
}

/// Terms that can be split in many combinations.
const TERMS: &str = "1.0, q[0], q[0].sin(), q[0] * q[1], q[0] * q[0], q[1] * q[1], p[0], p[0] * p[0], p[1] * p[1], p[0] * p[1], \
    (2.0 + p[1]).sqrt(), s, s * s, s.powi(3), s.exp(), (0.5 * s + 0.2).sin(), q[0] * s, (1.0 + q[0] * q[0]) * s * s, \
    q[1].cos() * (0.3 * s).exp(), p[0] * s, p[1] * s.sin(), p[0] * q[0], p[0] * q[1], p[1] * q[0], p[1] * q[1], \
    p[0] * q[0] * q[0], p[1] * (1.5 + q[1]).sqrt(), p[0] * q[1].cos(), t * s, s / t, (2.0 * t).sin() * q[0], \
    (2.0 * t).cos() * s, t * t * p[0], (0.3 * t).exp() * s * s, p[0] * p[0] * s, \
    (p[0] * p[0] + p[1] * p[1]) * (0.5 * s).exp(), (s - p[0] * q[0] - p[1] * q[1]).powi(2), \
    p[1].sin() * (s - p[0] * q[0] - p[1] * q[1]), (p[0] * p[0] + q[1].cos()) * (0.5 * s).exp(), t.tan() * s, \
    (t * q[0]).cos()";

/// A point of phase space and time: q, p, s, t.
type Place = [f64; 6];

fn value(graph: &Graph, id: Id, x: &Place, h: f64) -> f64 {
    eval(graph, id, &|symbol| match symbol {
        Symbol::Position(i) => x[i as usize],
        Symbol::Momentum(i) => x[2 + i as usize],
        Symbol::Action => x[4],
        Symbol::Time => x[5],
        Symbol::StepLength => h,
        _ => f64::NAN,
    })
}

/// Returns q', p' and s' by difference quotients of the energy.
fn field(graph: &Graph, energy: Id, x: &Place) -> [f64; 5] {
    let gap = 1e-5;
    let slope: [f64; 5] = std::array::from_fn(|i| {
        let [mut low, mut high] = [*x; 2];
        low[i] -= gap;
        high[i] += gap;
        (value(graph, energy, &high, 0.0) - value(graph, energy, &low, 0.0)) / (2.0 * gap)
    });
    let [q0, q1, p0, p1, s] = slope;
    [p0, p1, -q0 - x[2] * s, -q1 - x[3] * s, x[2] * p0 + x[3] * p1 - value(graph, energy, x, 0.0)]
}

/// Checks that a flow starts at the given point, and that its first `moving` coordinates follow their differential equation.
fn flows(graph: &mut Graph, piece: &Piece, x: &Place, moving: usize, text: &str) {
    let ends = [&piece.flow.q[..], &piece.flow.p, &[piece.flow.s]].concat();
    let at = |graph: &Graph, h: f64| -> [f64; 5] { std::array::from_fn(|i| value(graph, ends[i], x, h)) };
    let start = at(graph, 1e-13);
    assert!((0..5).all(|i| (start[i] - x[i]).abs() < 1e-10), "{text}, {piece:?}: {start:?} from {x:?}");
    for h in [0.1, -0.07] {
        let [before, there, after] = [h - 1e-5, h, h + 1e-5].map(|h| at(graph, h));
        let mut place = *x;
        place[..5].copy_from_slice(&there);
        place[5] += if piece.clock == Clock::Own { h } else { 0.0 };
        let field = field(graph, piece.energy, &place);
        for i in 0..moving {
            let rate = (after[i] - before[i]) / 2e-5;
            let error =
                (rate - field[i]).abs() / (1.0 + rate.abs() + field.iter().fold(0.0, |max, x| x.abs().max(max)));
            assert!(error < 1e-6, "{text}, {} at {h}, {i}: {rate} {}", piece.family.name, field[i]);
        }
    }
}

/// Checks that each increment is the end minus the start. Short steps avoid this difference if the end contains the term 1·x.
fn increments(graph: &mut Graph, piece: &Piece, x: &Place, text: &str) {
    let ends = piece.flow.changed(graph);
    let increments = split::increments(graph, &ends);
    for ((symbol, end), increment) in ends.into_iter().zip(increments) {
        let own = graph.symbol(symbol);
        for h in [0.1, -0.07, 1e-3] {
            let [end, start, change] = [end, own, increment].map(|id| value(graph, id, x, h));
            let size = end.abs() + start.abs();
            assert!(
                (end - start - change).abs() <= 1e-13 * (1.0 + size),
                "{text}, {symbol:?}: {end} − {start}, {change}"
            );
        }
    }
}

/// Returns the graph of an energy and the energy in it. `action` is the text of the argument for the action.
fn graph_of_sum(form: Form, action: &str, sum: &str) -> (Graph, Id) {
    let item = format!("fn f(q: [f64; 2], p: [f64; 2], {action}t: f64) -> f64 {{ {sum} }}");
    let (_, lowered) = lowered_by(form, TokenStream::new(), item.parse().expect("tokens"));
    (lowered.graph, lowered.terms.energy)
}

proptest! {
    #![proptest_config(config())]

    /// The pieces of a sum add up to the sum, and each flow solves its differential equation.
    #[test]
    fn pieces_are_the_energy_and_flow(
        terms in prop::collection::vec((one_of(TERMS), select(&[1.0, -0.5, 0.75, 2.0][..])), 1..5),
        x in prop::array::uniform5(-0.5..0.5),
    ) {
        let sum = terms.iter().map(|(term, c)| format!("{c:?} * {term}")).collect::<Vec<_>>().join(" + ");
        let (mut graph, root) = graph_of_sum(Form::Contact, "s: f64, ", &sum);
        let [q0, q1, p0, p1, s] = x;
        let x = [q0, q1, p0, p1, s, 0.6];
        if let Ok(found) = split::pieces(&mut graph, root, split::Space { degrees: 2, action: true }, None) {
            let pieces = found.pieces;
            let whole: f64 = pieces.iter().map(|piece| value(&graph, piece.energy, &x, 0.0)).sum();
            prop_assert!((whole - value(&graph, root, &x, 0.0)).abs() < 1e-12, "{}", sum);
            for piece in &pieces {
                flows(&mut graph, piece, &x, 5, &sum);
                increments(&mut graph, piece, &x, &sum);
            }
        }
    }
}

proptest! {
    // Each case takes ten times as long as a case above.
    #![proptest_config(config_of(75))]

    /// Polynomials without an action, and coupled terms. The pieces may omit a constant.
    #[test]
    fn canonical_pieces_are_the_energy_and_flow(
        monomials in prop::collection::vec((prop::array::uniform4(0..3_u32), select(&[1.0, -0.5, 0.75, 2.0][..])), 1..6),
        others in prop::collection::vec(one_of(COUPLED), 0..3),
        x in prop::array::uniform4(-0.5..0.5),
    ) {
        let monomial = |(powers, c): &([u32; 4], f64)| {
            let power = |(name, n): (&str, &u32)| format!(" * {name}.powi({n})");
            format!("{c:?}") + &["q[0]", "q[1]", "p[0]", "p[1]"].into_iter().zip(powers).filter(|(_, n)| **n > 0).map(power).collect::<String>()
        };
        let sum = monomials.iter().map(monomial).chain(others.iter().map(|term| (*term).into())).collect::<Vec<_>>().join(" + ");
        let (mut graph, root) = graph_of_sum(Form::Hamiltonian, "", &sum);
        let x = [x[0], x[1], x[2], x[3], 0.0, 0.6];
        if let Ok(found) = split::pieces(&mut graph, root, split::Space { degrees: 2, action: false }, None) {
            let origin = [0.0, 0.0, 0.0, 0.0, 0.0, 0.6];
            let moved = |energy: Id| value(&graph, energy, &x, 0.0) - value(&graph, energy, &origin, 0.0);
            let (whole, own) = (moved(root), found.pieces.iter().map(|piece| moved(piece.energy)).sum::<f64>());
            prop_assert!((whole - own).abs() < 1e-12, "{}", sum);
            for piece in &found.pieces {
                flows(&mut graph, piece, &x, 4, &sum);
                increments(&mut graph, piece, &x, &sum);
            }
        }
    }
}

/// Coupled terms, of which many are pieces.
const COUPLED: &str = "(p[0] + 0.5 * q[1]).powi(2), (p[1] - q[0].sin()).powi(2), (1.0 + (p[0] - q[1] * q[1]).powi(2)).sqrt(), \
    (q[0] + p[0]).powi(4), (p[0] * p[0] + q[0] * q[0]).powi(2), (q[0] * p[1] - q[1] * p[0]).powi(2), \
    (q[0] * p[1]).sin(), t * q[0] * p[1], t.sin() * (q[0] - p[0]).powi(3), \
    (q[0] * q[0] + 1.0) * (p[0] * p[0] + 1.0), (q[0] * p[0] * q[1]).cos()";

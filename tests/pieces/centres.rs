//! Motion about a centre that a short step does not test: many half turns, the centre itself, units.

use crate::check::{Over, step};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

#[hamiltonian(
    split = "p[0] * p[0] / (2.0 * m) + p[1] * p[1] / (2.0 * m) + k / (q[0] * q[0] + q[1] * q[1]) + b * (q[0] * q[0] + q[1] * q[1])"
)]
fn round_wall(q: [f64; 2], p: [f64; 2], m: f64, k: f64, b: f64) -> f64 {
    let square = q[0] * q[0] + q[1] * q[1];
    p[0] * p[0] / (2.0 * m) + p[1] * p[1] / (2.0 * m) + k / square + b * square
}

#[hamiltonian(split = "p * p / (2.0 * m) + k / (q * q) + b * q * q")]
fn wall(q: f64, p: f64, m: f64, k: f64, b: f64) -> f64 {
    p * p / (2.0 * m) + k / (q * q) + b * q * q
}

#[hamiltonian(
    split = "p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[0]) + p[2] * p[2] / (2.0 * m[1]) + p[3] * p[3] / (2.0 * m[1]) - g * m[0] * m[1] / ((q[2] - q[0]).powi(2) + (q[3] - q[1]).powi(2)).sqrt()"
)]
fn two_bodies(q: [f64; 4], p: [f64; 4], m: [f64; 2], g: f64) -> f64 {
    let kinetic = p[0] * p[0] / (2.0 * m[0])
        + p[1] * p[1] / (2.0 * m[0])
        + p[2] * p[2] / (2.0 * m[1])
        + p[3] * p[3] / (2.0 * m[1]);
    kinetic - g * m[0] * m[1] / ((q[2] - q[0]).powi(2) + (q[3] - q[1]).powi(2)).sqrt()
}

/// Returns the difference between one step and many shorter steps, relative to the state.
fn parts_of_a_step<const N: usize, S: Over<f64, N>>(system: S, x: &[f64], h: f64, parts: u32) -> f64 {
    let whole = step::<f64, N, S>(system, x, 0.0, h).expect("a step");
    let mut now = x.to_vec();
    for _ in 0..parts {
        now = step::<f64, N, S>(system, &now, 0.0, h / f64::from(parts)).expect("a short step");
    }
    let largest = |x: &[f64]| x.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    let gap: Vec<f64> = whole.iter().zip(&now).map(|(a, b)| a - b).collect();
    largest(&gap) / largest(&now)
}

/// One long step equals 40 short steps. It passes any number of half periods, in both directions, and with almost no barrier around the centre. Unstable
/// and free motions are covered, too.
#[test]
fn long_steps_are_many_short_ones() {
    let x = [0.7, -0.4, 0.3, 0.9];
    for b in [0.75, 0.0, -0.5] {
        for k in [0.4, 1e-9, 0.0, -0.02] {
            let system = RoundWall { m: 1.7, k, b };
            let lengths = if b < 0.0 { &[0.4, -0.4, 2.5][..] } else { &[0.4, -0.4, 2.5, 4.0, -9.0, 23.0][..] };
            for h in lengths {
                let gap = parts_of_a_step::<2, _>(system, &x, *h, 40);
                assert!(gap < 1e-12, "k = {k}, b = {b}, h = {h}: {gap:e}");
            }
        }
        for k in [0.4, 1e-3] {
            for h in [0.4, -0.4, 2.5] {
                let gap = parts_of_a_step::<1, _>(Wall { m: 1.7, k, b }, &[-0.7, 0.3], h, 40);
                assert!(gap < 1e-12, "k = {k}, b = {b}, h = {h}: {gap:e}");
            }
        }
    }
    let orbit = TwoBodies { m: [1.0, 1e-30], g: 1.3 };
    let gap = parts_of_a_step::<4, _>(orbit, &[0.0, 0.1, 1.0, -0.2, 0.1, 0.0, 0.3e-30, 0.9e-30], 2.0, 40);
    assert!(gap < 1e-12, "{gap:e}");
}

/// A motion that ends in the centre is refused, and the error names the piece.
#[test]
fn the_centre_ends_the_motion() {
    let fails = |error: geoint_runtime::StepError, word: &str| {
        assert!(error.to_string().contains(word), "{error}");
    };
    // From rest, the motion reaches the centre after the time a/√(2k/m).
    for (h, ends) in [(0.9, false), (1.1, true), (-1.1, true), (9.0, true)] {
        let found = step::<f64, 1, _>(Wall { m: 1.0, k: -0.5, b: 0.0 }, &[1.0, 0.0], 0.0, h);
        assert_eq!(found.is_err(), ends, "h = {h}");
        if let Some(error) = found.err() {
            fails(error, "k/q²");
        }
        let system = RoundWall { m: 1.0, k: -0.5, b: 0.2 };
        assert!(step::<f64, 2, _>(system, &[0.8, 0.6, 0.0, 0.0], 0.0, 9.0 * h).is_err(), "h = {h}");
    }
    // Without a force, a line through the centre ends there. A line beside the centre continues.
    let free = RoundWall { m: 1.0, k: 0.0, b: 0.0 };
    assert!(step::<f64, 2, _>(free, &[1.0, 0.0, -1.0, 0.0], 0.0, 2.0).is_err());
    let beside = step::<f64, 2, _>(free, &[1.0, 1e-3, -1.0, 0.0], 0.0, 2.0).expect("a line");
    assert!((beside[0] + 1.0).abs() < 1e-12 && (beside[1] - 1e-3).abs() < 1e-12, "{beside:?}");
    let error =
        step::<f64, 4, _>(TwoBodies { m: [1.0, 2.0], g: 1.0 }, &[0.5, 0.5, 0.5, 0.5, 0.0, 0.1, 0.2, 0.0], 0.0, 0.1);
    fails(error.expect_err("equal positions"), "q[2]");
}

/// Results do not depend on units: atoms in SI units, and single precision.
#[test]
fn units_do_not_matter() {
    let (length, mass, time) = (1e-10, 1.7e-27, 1e-14);
    let energy = mass * length * length / time / time;
    let here =
        step::<f64, 2, _>(RoundWall { m: 1.0, k: 0.4, b: 0.75 }, &[0.7, -0.4, 0.3, 0.9], 0.0, 1.1).expect("a step");
    let system = RoundWall { m: mass, k: 0.4 * energy * length * length, b: 0.75 * energy / length / length };
    let momentum = mass * length / time;
    let there =
        step::<f64, 2, _>(system, &[0.7 * length, -0.4 * length, 0.3 * momentum, 0.9 * momentum], 0.0, 1.1 * time);
    for (i, x) in there.expect("a step").into_iter().enumerate() {
        let unit = if i < 2 { length } else { momentum };
        assert!((x / unit - here[i]).abs() < 1e-14);
    }
    let single = RoundWall { m: 1.0_f32, k: 0.4, b: 0.75 };
    let state = State::new([0.7_f32, -0.4], [0.3, 0.9]);
    let mut sim = Integrator::new(single, PieceSplitting, 1.1, state);
    sim.step().expect("a step");
    assert!((f64::from(sim.state().q[0]) - here[0]).abs() < 1e-6);
}

//! Kinetic energies f(q)p², in which f is a power with parameters: both signs, and points without motion.

use crate::check::step;
use geoint_runtime::prelude::*;

#[hamiltonian]
fn lever(q: f64, p: f64, m: f64, a: f64) -> f64 {
    (1.0 + q / a) * p * p / (2.0 * m)
}

#[hamiltonian]
fn wedge(q: f64, p: f64, m: f64, a: f64) -> f64 {
    (1.0 - a * q).powi(2) * p * p / (2.0 * m)
}

#[hamiltonian]
fn growing_mass(q: f64, p: f64, m: f64, a: f64) -> f64 {
    p * p / (2.0 * m * (1.0 + a * q))
}

/// Returns the difference between one step and 64 steps of a method without flows.
macro_rules! gap {
    ($system:expr, $x:expr, $h:expr) => {{
        let found = step::<f64, 1, _>($system, &$x, 0.0, $h).expect("a step");
        let mut exact = $system.integrator(Gauss::<4>, $h / 64.0, State::new($x[0], $x[1]));
        exact.advance(64).expect("steps");
        let State { q, p, .. } = exact.state();
        ((found[0] - q).abs() / (1.0 + q.abs())).max((found[1] - p).abs() / (1.0 + p.abs()))
    }};
}

#[test]
fn factors_of_both_signs() {
    for a in [0.5, -0.5, 3.0, 1e30, f64::INFINITY] {
        for q in [0.75, -0.75, 0.0, -0.5] {
            for h in [0.3, -0.2, 1e-6] {
                let x = [q, 0.4];
                let error = gap!(Lever { m: 1.7, a }, x, h);
                assert!(error < 1e-14, "lever, a = {a}, q = {q}, h = {h}: {error:e}");
                let error = gap!(Wedge { m: 1.7, a: 1.0 / a }, x, h);
                assert!(error < 1e-14, "wedge, a = {a}, q = {q}, h = {h}: {error:e}");
                if 1.0 + q / a != 0.0 {
                    let error = gap!(GrowingMass { m: 1.7, a: 1.0 / a }, x, h);
                    assert!(error < 1e-14, "mass, a = {a}, q = {q}, h = {h}: {error:e}");
                }
            }
        }
    }
}

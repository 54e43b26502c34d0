//! Loops that assign again are unrolled; what they compute is differentiated.
use geoint_runtime::prelude::*;

/// A planet on a given ellipse pulls: its place solves Kepler's equation.
#[hamiltonian]
fn third_body(q: [f64; 2], p: [f64; 2], t: f64, e: f64, mu: f64) -> f64 {
    let mut anomaly = t;
    for _ in 0..5 {
        anomaly = anomaly - (anomaly - e * anomaly.sin() - t) / (1.0 - e * anomaly.cos());
    }
    let planet = [anomaly.cos() - e, (1.0 - e * e).sqrt() * anomaly.sin()];
    let mut r = [0.0; 2];
    for i in 0..2 {
        r[i] = (q[0] - mu * i as f64 * planet[0]).hypot(q[1] - mu * i as f64 * planet[1]);
    }
    (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / r[0] - mu / r[1]
}

/// Legendre's polynomials by their recurrence.
#[hamiltonian]
fn multipoles(q: f64, p: f64, c: [f64; 5]) -> f64 {
    let x = q.cos();
    let (mut before, mut now) = (1.0, x);
    let mut v = c[0];
    for n in 1..5 {
        v += c[n] * now;
        let n = n as f64;
        (before, now) = (now, ((2.0 * n + 1.0) * x * now - n * before) / (n + 1.0));
    }
    p * p / 3.0 + v
}

#[test]
fn compiles_and_means_what_it_says() {
    let system = ThirdBody { e: 0.3, mu: 0.2 };
    let (q, p) = ([3.0, 0.4], [0.1, 0.6]);
    assert!((system.energy(&State::at(0.7, q, p)) - third_body(q, p, 0.7, 0.3, 0.2)).abs() < 1e-14);
    system.integrator(BlanesMoanSrkn14a, 0.05, State::new(q, p)).advance(100).unwrap();

    let c = [0.1, -0.3, 0.7, 0.2, -0.5];
    let mut sim = Multipoles { c }.integrator(DiscreteGradient, 0.1, State::new(0.5, 0.3));
    assert!((sim.energy() - multipoles(0.5, 0.3, c)).abs() < 1e-14);
    let start = sim.energy();
    sim.advance(1000).unwrap();
    assert!((sim.energy() - start).abs() < 1e-13);
}

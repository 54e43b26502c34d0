//! Scenes with many alike parts, written as loops. The steps must agree with a computation of each part by hand.

use geoint_runtime::prelude::*;

const N: usize = 40;

/// Pendulums on springs between walls, every mass and every spring another one.
#[hamiltonian(const N = 40)]
fn row(q: [f64; N], p: [f64; N], m: [f64; N], k: [f64; N], g: f64) -> f64 {
    let mut energy = k[0] * (q[0].powi(2) / 2.0 + q[N - 1].powi(4) / 4.0);
    for i in 0..N {
        energy += p[i] * p[i] / (2.0 * m[i]) - g * m[i] * q[i].cos();
    }
    for i in 1..N {
        let d = q[i] - q[i - 1];
        energy += k[i] * (d * d / 2.0 + d * d * d / 50.0 + (2.0 * d).sin() * d.cos());
    }
    energy
}

fn row_by_hand(s: &Row, q: &[f64; N]) -> [f64; N] {
    let mut force = [0.0; N];
    force[0] -= s.k[0] * q[0];
    force[N - 1] -= s.k[0] * q[N - 1].powi(3);
    for i in 0..N {
        force[i] -= s.g * s.m[i] * q[i].sin();
    }
    for i in 1..N {
        let d = q[i] - q[i - 1];
        let pull = s.k[i] * (d + 0.06 * d * d + 2.0 * (2.0 * d).cos() * d.cos() - (2.0 * d).sin() * d.sin());
        force[i] -= pull;
        force[i - 1] += pull;
    }
    force
}

/// Beads on a ring in space, with the nearest and the second nearest.
#[hamiltonian(const N = 40)]
fn ring(q: [[f64; 3]; N], p: [[f64; 3]; N], m: f64, k: f64) -> f64 {
    let mut energy = 0.0;
    for i in 0..N {
        for j in [(i + 1) % N, (i + 2) % N] {
            let mut square = 0.0;
            for a in 0..3 {
                square += (q[i][a] - q[j][a]).powi(2);
            }
            energy += k * (square.sqrt() - 1.0).powi(2) / 2.0;
        }
        for a in 0..3 {
            energy += p[i][a].powi(2) / (2.0 * m);
        }
    }
    energy
}

fn ring_by_hand(s: &Ring, q: &[[f64; 3]; N]) -> [[f64; 3]; N] {
    let mut force = [[0.0; 3]; N];
    for i in 0..N {
        for j in [(i + 1) % N, (i + 2) % N] {
            let d: [f64; 3] = std::array::from_fn(|a| q[i][a] - q[j][a]);
            let r = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
            for a in 0..3 {
                let pull = s.k * (r - 1.0) * d[a] / r;
                force[i][a] -= pull;
                force[j][a] += pull;
            }
        }
    }
    force
}

/// A weather (E. N. Lorenz, 1996) that nothing drives.
#[vector_field(const N = 40)]
fn weather(x: [f64; N]) -> [f64; N] {
    let mut rate = [0.0; N];
    for i in 0..N {
        rate[i] = (x[(i + 1) % N] - x[(i + N - 2) % N]) * x[(i + N - 1) % N];
    }
    rate
}

fn wave(i: usize) -> f64 {
    (0.7 * i as f64).sin() + 0.3 * (2.3 * i as f64).cos()
}

/// Verlet's method by hand.
fn verlet<const D: usize>(
    (h, steps): (f64, usize),
    (mut q, mut p): ([f64; D], [f64; D]),
    mass: impl Fn(usize) -> f64,
    force: impl Fn(&[f64; D]) -> [f64; D],
) -> [[f64; D]; 2] {
    for _ in 0..steps {
        for half in 0..2 {
            let f = force(&q);
            (0..D).for_each(|i| p[i] += h / 2.0 * f[i]);
            if half == 0 {
                (0..D).for_each(|i| q[i] += h * p[i] / mass(i));
            }
        }
    }
    [q, p]
}

fn gap(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |gap, (a, b)| gap.max((a - b).abs()))
}

#[test]
fn neighbours_with_numbers_of_their_own() {
    let system =
        Row { m: std::array::from_fn(|i| 1.0 + 0.1 * wave(i)), k: std::array::from_fn(|i| 2.0 + wave(3 * i)), g: 0.7 };
    let start = State::new(std::array::from_fn(wave), std::array::from_fn(|i| wave(2 * i + 1)));
    let [q, p] = verlet((0.01, 100), (start.q, start.p), |i| system.m[i], |q| row_by_hand(&system, q));
    let mut sim = system.integrator(StormerVerlet, 0.01, start);
    sim.advance(100).expect("a regular motion");
    let state = sim.state();
    assert!(gap(&state.q, &q) < 1e-12 && gap(&state.p, &p) < 1e-12, "{:e}", gap(&state.q, &q));
    // Compares a method that solves equations with a method that adds rates.
    let mut sim = system.integrator(Gauss::<2>, 0.02, start);
    let mut other = system.integrator(RK4, 0.002, start);
    sim.advance(20).expect("a regular motion");
    other.advance(200).expect("a regular motion");
    assert!(gap(&sim.state().q, &other.state().q) < 1e-6);
    let mut sim = system.integrator(DiscreteGradient, 0.02, start);
    sim.advance(20).expect("a regular motion");
    assert!((sim.energy() / system.energy(&start) - 1.0).abs() < 1e-14);
}

#[test]
fn neighbours_in_space() {
    let system = Ring { m: 1.3, k: 2.0 };
    let place = |i: usize| [wave(i), wave(2 * i + 5), wave(3 * i + 1)];
    let start = State::new(std::array::from_fn(place), [[0.0; 3]; N]);
    let flat = |x: &[[f64; 3]; N]| -> [f64; 3 * N] { std::array::from_fn(|i| x[i / 3][i % 3]) };
    let force = |q: &[f64; 3 * N]| {
        flat(&ring_by_hand(&system, &std::array::from_fn(|i| std::array::from_fn(|a| q[3 * i + a]))))
    };
    let [q, p] = verlet((0.02, 50), (flat(&start.q), flat(&start.p)), |_| system.m, force);
    let mut sim = system.integrator(StormerVerlet, 0.02, start);
    sim.advance(50).expect("a regular motion");
    let state = sim.state();
    assert!(gap(&flat(&state.q), &q) < 1e-11 && gap(&flat(&state.p), &p) < 1e-11, "{:e}", gap(&flat(&state.q), &q));
}

#[test]
fn neighbours_of_a_field() {
    let start: [f64; N] = std::array::from_fn(wave);
    let rate = |x: &[f64; N]| -> [f64; N] {
        std::array::from_fn(|i| (x[(i + 1) % N] - x[(i + N - 2) % N]) * x[(i + N - 1) % N])
    };
    let moved = |x: &[f64; N], w: f64, d: &[f64; N]| -> [f64; N] { std::array::from_fn(|i| x[i] + w * d[i]) };
    let (mut x, h) = (start, 0.01);
    for _ in 0..100 {
        let k1 = rate(&x);
        let k2 = rate(&moved(&x, h / 2.0, &k1));
        let k3 = rate(&moved(&x, h / 2.0, &k2));
        let k4 = rate(&moved(&x, h, &k3));
        x = std::array::from_fn(|i| x[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
    }
    let mut sim = Weather {}.integrator(RK4, h, FlowState::new(start));
    sim.advance(100).expect("a regular motion");
    assert!(gap(&sim.state().x, &x) < 1e-12, "{:e}", gap(&sim.state().x, &x));
}

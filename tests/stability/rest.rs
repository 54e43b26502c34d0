//! Friction brings systems to rest. No step is refused on the way, and nothing moves at rest.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A chain between walls: springs that pull with a force of 1 at rest, where all coordinates are 0.
#[hamiltonian(damping = c)]
fn chain(q: [f64; 6], p: [f64; 6], m: f64, c: f64) -> f64 {
    let mut h = (-q[0]).exp() + q[5].exp();
    for i in 0..6 {
        h += p[i] * p[i] / (2.0 * m);
    }
    for i in 0..5 {
        h += (q[i] - q[i + 1]).exp();
    }
    h
}

/// Atoms in a row, each on its place.
#[hamiltonian(damping = c)]
fn row(q: [f64; 6], p: [f64; 6], m: f64, c: f64) -> f64 {
    let mut h = 0.0;
    for i in 0..6 {
        h += p[i] * p[i] / (2.0 * m);
    }
    for i in 0..5 {
        let s = (q[i + 1] - q[i]).powi(-6);
        h += 4.0 * (s * s - s);
    }
    h
}

/// Charges on the corners of a square, held by springs.
#[hamiltonian(damping = c)]
fn corners(q: [[f64; 2]; 4], p: [[f64; 2]; 4], m: f64, k: f64, c: f64) -> f64 {
    let mut h = 0.0;
    for i in 0..4 {
        h += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m);
        for j in 0..i {
            let r = (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
            h += k / r + k * r.powi(3);
        }
    }
    h
}

/// The same chain under friction by its action.
#[contact_hamiltonian]
fn contact_chain(q: [f64; 3], p: [f64; 3], s: f64, m: f64, c: f64) -> f64 {
    let mut h = c * s + (-q[0]).exp() + q[2].exp();
    for i in 0..3 {
        h += p[i] * p[i] / (2.0 * m);
    }
    for i in 0..2 {
        h += (q[i] - q[i + 1]).exp();
    }
    h
}

/// A double pendulum with friction in its joints.
#[lagrangian(rayleigh = c * (v[0] * v[0] + (v[1] - v[0]) * (v[1] - v[0])) / 2.0)]
fn double_pendulum(q: [f64; 2], v: [f64; 2], m: f64, g: f64, c: f64) -> f64 {
    v[0] * v[0] * m + v[1] * v[1] / 2.0 + v[0] * v[1] * (q[0] - q[1]).cos() + g * (2.0 * q[0].cos() + q[1].cos())
}

/// A time after which friction has damped all waves. Then only rounding moves the system, by a different amount in each step.
const SETTLED: f64 = 900.0;

/// Runs a system until only rounding moves it. The energy is then at its minimum, to the rounding of terms of size `$size`.
macro_rules! rests {
    ($system:expr, $start:expr, $h:expr, ($least:expr, $size:expr); $($method:expr),* $(,)?) => { $({
        let mut sim = $system.integrator($method, $h, $start);
        let steps = (SETTLED / $h) as u64;
        let outcome = sim.advance(steps);
        assert_eq!(outcome, Ok(()), "{}, h = {}, step {} of {steps}", stringify!($system, $method), $h, sim.steps());
        let left = (sim.energy() - $least).abs() / $size;
        assert!(left <= 16.0 * f64::EPSILON, "{}, h = {}: {left:.1e}", stringify!($system, $method), $h);
    })* };
}

#[test]
fn a_chain_comes_to_rest() {
    let start = State::new([0.3, -0.1, 0.2, 0.05, -0.3, 0.1], [0.1, 0.2, -0.3, 0.0, 0.1, -0.2]);
    rests!(Chain { m: 1.7, c: 0.6 }, start, 0.3, (7.0, 7.0);
        DiscreteGradient, ImplicitMidpoint, Gauss::<2>, Suzuki4.of(ImplicitMidpoint));
}

#[test]
fn a_row_comes_to_rest() {
    let distance = 2.0_f64.powf(1.0 / 6.0);
    let q = [0.03, -0.05, 0.02, 0.0, 0.04, -0.01];
    let start = State::new(core::array::from_fn(|i| q[i] + i as f64 * distance), [0.1, -0.2, 0.0, 0.3, 0.1, -0.2]);
    rests!(Row { m: 1.3, c: 0.9 }, start, 0.3, (-5.0, 5.0); DiscreteGradient, ImplicitMidpoint, Gauss::<2>);
}

#[test]
fn a_square_comes_to_rest() {
    // The minimum of 4(k/a + ka³) + 2(k/(√2a) + k(√2a)³) over the side a.
    let (k, root) = (0.7, 2.0_f64.sqrt());
    let a = ((4.0 + root) / (12.0 * (1.0 + root))).powf(0.25);
    let least = k * ((4.0 + root) / a + (4.0 + 4.0 * root) * a.powi(3));
    let start = State::new(
        [[0.45, 0.02], [-0.03, 0.5], [-0.4, 0.01], [0.05, -0.45]],
        [[0.1, 0.2], [0.0, -0.1], [0.2, 0.1], [-0.1, 0.3]],
    );
    rests!(Corners { m: 1.3, k, c: 0.9 }, start, 0.2, (least, least); DiscreteGradient, ImplicitMidpoint, Gauss::<2>);
}

#[test]
fn a_double_pendulum_comes_to_rest() {
    let system = || DoublePendulum { m: 1.3, g: 2.0, c: 1.1 };
    let start = system().at([1.2, -0.7], [0.3, 0.1]);
    rests!(system(), start, 0.1, (-6.0, 6.0); DiscreteGradient, ImplicitMidpoint, Gauss::<2>);
}

/// A contact energy decays to zero: H' = −cH. The rounding error of a step survives for 1/(ch) steps.
#[test]
fn a_contact_chain_comes_to_rest() {
    let (start, h) = (ContactState::new([0.3, -0.1, 0.2], [0.1, 0.2, -0.3], 0.0), 0.3);
    rests!(ContactChain { m: 1.7, c: 0.6 }, start, h, (0.0, 4.0 / h);
        ContactMidpoint, ContactGauss::<2>, Suzuki4.of(ContactMidpoint));
}

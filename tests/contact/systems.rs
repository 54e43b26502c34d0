//! Contact systems from the literature, each with expected numbers. The numbers belong to a known solution, or were computed beforehand by another program.

mod celestial;
mod oscillators;
mod lifts;
mod thermostat;

use crate::measure::{self, flat};
use geoint_runtime::prelude::*;
use geoint_runtime::system::Pieces;
use geoint_runtime::{Contact, Failure};
use geoint_tests::measure::extrapolated;
use geoint_tests::scalars::Double;

/// An oscillator with friction.
#[contact_hamiltonian]
fn damped_oscillator(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + gamma * s
}

/// The same, taken apart further than need be.
#[contact_hamiltonian(split = "p * p / 2.0 | gamma * s | q * q / 2.0")]
fn three_pieces(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + gamma * s
}

/// The oscillator under a periodic force.
#[contact_hamiltonian]
fn driven(q: f64, p: f64, s: f64, t: f64, gamma: f64, beta: f64, omega: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 - beta * (omega * t).sin() * q + gamma * s
}

/// Two bodies with friction that changes its sign.
#[contact_hamiltonian]
fn perturbed_kepler(q: [f64; 2], p: [f64; 2], s: f64, t: f64, alpha: f64, omega: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt() + alpha * (omega * t).sin() * s
}

/// A star in hydrostatic equilibrium, with V = a q + b q²/2 + c q⁶/6.
#[contact_hamiltonian]
fn lane_emden(q: f64, p: f64, s: f64, t: f64, a: f64, b: f64, c: f64) -> f64 {
    p * p / 2.0 + 2.0 / t * s + a * q + b * q * q / 2.0 + c * q.powi(6) / 6.0
}

/// The rotation of a satellite on an ellipse: friction and a constant torque, λ and Ω of its moment of inertia, torques.
#[contact_hamiltonian]
fn spin_orbit(q: f64, p: f64, s: f64, t: f64, tide: [f64; 2], inertia: [f64; 2], torque: [f64; 15]) -> f64 {
    let [lambda, omega] = inertia;
    let inertia = 1.0 + lambda * (omega * t).cos();
    let friction = tide[0] - lambda * omega * (omega * t).sin() / inertia;
    let potential = (0..15).map(|i| torque[i] * (2.0 * q - (i as f64 - 5.0) * t).cos()).sum::<f64>();
    p * p / 2.0 + friction * s - potential / (2.0 * inertia) - tide[1] * q
}

/// Van der Pol's oscillator in (q, s).
#[contact_hamiltonian(lift)]
fn van_der_pol(q: f64, p: f64, s: f64, eps: f64) -> f64 {
    p * s - eps * (1.0 - q * q) * s + q
}

/// The same under a periodic force.
#[contact_hamiltonian(lift)]
fn forced_van_der_pol(q: f64, p: f64, s: f64, t: f64, eps: f64, a: f64, omega: f64) -> f64 {
    p * s - eps * (1.0 - q * q) * s + q - a * (omega * t).cos()
}

/// An oscillator whose sphere H = 0 is invariant.
#[contact_hamiltonian]
fn cosmological(q: f64, p: f64, s: f64, r: f64) -> f64 {
    (p * p + q * q + s * s) / 2.0 - r
}

/// Friction that grows with the action.
#[contact_hamiltonian]
fn quadratic_dissipation(q: f64, p: f64, s: f64, a: f64) -> f64 {
    p * p / 2.0 + q * q / 2.0 + a * s * s / 2.0
}

/// An oscillator with friction and a clock that follow the action.
#[contact_hamiltonian]
fn thermostat(q: f64, p: f64, s: f64, k: f64) -> f64 {
    (p * p / 2.0 + q * q / 2.0) * (k * s).exp()
}

/// Steepest descent on U = (|q|² − 1)²/4 + b q₀²/2, as H = −p·∇U.
#[contact_hamiltonian(lift)]
fn descent(q: [f64; 2], p: [f64; 2], s: f64, b: f64) -> f64 {
    let r = q[0] * q[0] + q[1] * q[1] - 1.0;
    -p[0] * q[0] * (r + b) - p[1] * q[1] * r + 0.0 * s
}

/// A pendulum with friction, q = (angle, momentum, heat), as H = p·X(q).
#[contact_hamiltonian(lift)]
fn pendulum_in_bath(q: [f64; 3], p: [f64; 3], s: f64, gamma: f64) -> f64 {
    p[0] * q[1] - p[1] * (q[0].sin() + gamma * q[1]) + p[2] * gamma * q[1] * q[1] + 0.0 * s
}

/// (q, p, s) of the solution after a time.
fn solution<S: Contact<Double>>(system: &S, start: &[f64], duration: f64, parts: usize) -> Vec<f64> {
    measure::solution(system, 0.0, start, duration, parts).into_iter().map(Double::value).collect()
}

/// (q, p, s) that a method has reached after a time.
fn after<S: Contact, M: Method<S, f64>>(
    system: S,
    method: M,
    h: f64,
    state: ContactState<S::Coordinates>,
    duration: f64,
) -> Vec<f64> {
    let mut sim = system.integrator(method, h, state);
    sim.advance((duration / h).round() as u64).unwrap();
    flat(&sim.state())
}

/// The largest difference.
fn gap(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    largest(a.iter().zip(b).map(|(a, b)| a - b))
}

/// Returns the largest absolute value, or NaN if one of the values is NaN.
fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |largest, x| if x.abs() > largest || x.is_nan() { x.abs() } else { largest })
}

/// The order that errors at h and at h/2 tell of.
fn order([whole, half]: [f64; 2]) -> f64 {
    (whole / half).log2()
}

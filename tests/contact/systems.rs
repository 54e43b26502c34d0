//! The systems of the field, each with numbers that must come out.

mod celestial;
mod oscillators;
mod relaxation;
mod thermal;

use geoint_runtime::array::Array;
use geoint_runtime::prelude::*;
use geoint_runtime::{Contact, Coordinates};
use geoint_tests::measure::extrapolated;

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

/// The rotation of a satellite on an ellipse.
#[contact_hamiltonian]
fn spin_orbit(q: f64, p: f64, s: f64, t: f64, delta: f64, lambda: f64, omega: f64, eps: f64, mu: f64, c: [f64; 15]) -> f64 {
    let inertia = 1.0 + lambda * (omega * t).cos();
    let friction = delta - lambda * omega * (omega * t).sin() / inertia;
    let torque = (0..15).map(|i| c[i] * (2.0 * q - (i as f64 - 5.0) * t).cos()).sum::<f64>();
    p * p / 2.0 + friction * s - eps / (2.0 * inertia) * torque - mu * q
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

/// An oscillator in contact with a heat bath: E(q, p) cosh s with E ≥ `ground`.
#[contact_hamiltonian(split = "p * p * (k * s).exp() / 4.0 | p * p * (-k * s).exp() / 4.0
    | (q * q / 2.0 + ground) * (k * s).exp() / 2.0 | (q * q / 2.0 + ground) * (-k * s).exp() / 2.0")]
fn thermostat(q: f64, p: f64, s: f64, ground: f64, k: f64) -> f64 {
    (p * p / 2.0 + q * q / 2.0 + ground) * ((k * s).exp() + (-k * s).exp()) / 2.0
}

/// An oscillator whose friction and clock slow down together.
#[contact_hamiltonian]
fn product(q: f64, p: f64, s: f64, k: f64) -> f64 {
    (p * p / 2.0 - q.cos() + 1.0) * (k * s).exp()
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

/// (q, p, s) at a point.
fn flat<Q: Coordinates<Real = f64>>(state: &ContactState<Q>) -> Vec<f64> {
    let (q, p) = (state.q.into_array(), state.p.into_array());
    [q.as_slice(), p.as_slice(), &[state.s]].concat()
}

/// The solution after a time, of which the equations of motion are written once more; by extrapolation in equal parts.
fn solution<S: Contact>(system: &S, state: &ContactState<S::Coordinates>, duration: f64, parts: usize) -> Vec<f64> {
    let n = S::Array::LEN;
    let field = |t: f64, y: &[f64]| {
        let [mut q, mut p, mut dq, mut dp] = [S::Array::zero(); 4];
        q.as_mut_slice().copy_from_slice(&y[..n]);
        p.as_mut_slice().copy_from_slice(&y[n..2 * n]);
        let (s, mut ds) = (y[2 * n], 0.0);
        system.gradient(t, &q, &p, &s, &mut dq, &mut dp, &mut ds);
        let energy = system.hamiltonian(t, &q, &p, &s);
        let (dq, dp) = (dq.as_slice(), dp.as_slice());
        let force = (0..n).map(|i| -dq[i] - y[n + i] * ds);
        let action = (0..n).map(|i| y[n + i] * dp[i]).sum::<f64>() - energy;
        dp.iter().copied().chain(force).chain([action]).collect()
    };
    extrapolated(field, state.t, flat(state), duration, parts)
}

/// (q, p, s) that a method has reached after a time.
fn after<S: Contact, M: Method<S, f64>>(
    system: S,
    method: M,
    h: f64,
    state: ContactState<S::Coordinates>,
    duration: f64,
) -> Result<Vec<f64>, StepError> {
    let mut sim = system.integrator(method, h, state);
    sim.advance((duration / h).round() as u64)?;
    Ok(flat(&sim.state()))
}

/// The largest difference.
fn gap(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

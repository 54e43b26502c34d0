//! The systems of the ablation.

use geoint_runtime::{contact_hamiltonian, hamiltonian, lagrangian};

/// Planar pendulum.
#[hamiltonian]
pub(crate) fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
    p * p / (2.0 * m * l * l) - m * g * l * q.cos()
}

/// A body around a fixed centre.
#[hamiltonian]
pub(crate) fn kepler(q: [f64; 2], p: [f64; 2]) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// The galaxy of Hénon and Heiles.
#[hamiltonian]
pub(crate) fn henon_heiles(q: [f64; 2], p: [f64; 2]) -> f64 {
    let [x, y] = q;
    (p[0] * p[0] + p[1] * p[1] + x * x + y * y) / 2.0 + x * x * y - y * y * y / 3.0
}

/// Two pendulums, the second hanging from the first; angles from the vertical.
#[hamiltonian]
pub(crate) fn double_pendulum(q: [f64; 2], p: [f64; 2], g: f64) -> f64 {
    let (sin, cos) = (q[0] - q[1]).sin_cos();
    let kinetic = (p[0] * p[0] + 2.0 * p[1] * p[1] - 2.0 * p[0] * p[1] * cos) / (2.0 * (1.0 + sin * sin));
    kinetic - 2.0 * g * q[0].cos() - g * q[1].cos()
}

/// The double pendulum by its Lagrangian.
#[lagrangian]
pub(crate) fn double_pendulum_lagrangian(q: [f64; 2], v: [f64; 2], g: f64) -> f64 {
    let kinetic = v[0] * v[0] + 0.5 * v[1] * v[1] + v[0] * v[1] * (q[0] - q[1]).cos();
    kinetic + 2.0 * g * q[0].cos() + g * q[1].cos()
}

/// A free rigid body; x is its angular momentum.
#[hamiltonian(structure = so3)]
pub(crate) fn top(x: [f64; 3], inertia: [f64; 3]) -> f64 {
    (0..3).map(|i| x[i] * x[i] / (2.0 * inertia[i])).sum()
}

/// A pendulum with friction.
#[contact_hamiltonian]
pub(crate) fn damped_pendulum(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 - q.cos() + gamma * s
}

/// Kepler's problem with friction.
#[contact_hamiltonian]
pub(crate) fn damped_kepler(q: [f64; 2], p: [f64; 2], s: f64, gamma: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 - 1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt() + gamma * s
}

/// A pendulum with a friction that grows with the action.
#[contact_hamiltonian]
pub(crate) fn varying_pendulum(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 - q.cos() + gamma * s + 0.1 * gamma * s * s
}

/// The double pendulum by its Lagrangian, with friction.
#[lagrangian]
pub(crate) fn damped_double_pendulum(q: [f64; 2], v: [f64; 2], s: f64, g: f64, gamma: f64) -> f64 {
    let kinetic = v[0] * v[0] + 0.5 * v[1] * v[1] + v[0] * v[1] * (q[0] - q[1]).cos();
    kinetic + 2.0 * g * q[0].cos() + g * q[1].cos() - gamma * s
}

/// A chain of 20 particles between walls, with springs that are not linear.
#[hamiltonian]
pub(crate) fn chain(q: [f64; 20], p: [f64; 20], alpha: f64) -> f64 {
    let mut energy = q[0] * q[0] / 2.0 + q[19] * q[19] / 2.0;
    for i in 0..20 {
        energy += p[i] * p[i] / 2.0;
    }
    for i in 0..19 {
        let d = q[i + 1] - q[i];
        energy += d * d / 2.0 + alpha * d * d * d / 3.0;
    }
    energy
}

/// The chain with linear springs.
#[hamiltonian]
pub(crate) fn linear_chain(q: [f64; 20], p: [f64; 20], k: f64) -> f64 {
    let mut energy = k * q[0] * q[0] / 2.0 + k * q[19] * q[19] / 2.0;
    for i in 0..20 {
        energy += p[i] * p[i] / 2.0;
    }
    for i in 0..19 {
        energy += k * (q[i + 1] - q[i]) * (q[i + 1] - q[i]) / 2.0;
    }
    energy
}

//! The energies whose generated steps are timed.

use geoint_runtime::{contact_hamiltonian, hamiltonian};
use nalgebra::{UnitQuaternion, Vector3};

/// Planar pendulum.
#[hamiltonian]
pub(crate) fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
    p * p / (2.0 * m * l * l) - m * g * l * q.cos()
}

/// A body around a fixed centre.
#[hamiltonian]
pub(crate) fn kepler(q: [f64; 2], p: [f64; 2], m: f64, mu: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - mu * m / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// The same under friction that comes and goes.
#[contact_hamiltonian]
pub(crate) fn driven_kepler(q: [f64; 2], p: [f64; 2], s: f64, t: f64, mu: f64, alpha: f64, omega: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 - mu / (q[0] * q[0] + q[1] * q[1]).sqrt() + alpha * (omega * t).sin() * s
}

/// The same under constant friction.
#[contact_hamiltonian]
pub(crate) fn damped_kepler(q: [f64; 2], p: [f64; 2], s: f64, mu: f64, alpha: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 - mu / (q[0] * q[0] + q[1] * q[1]).sqrt() + alpha * s
}

/// Hénon & Heiles' galaxy.
#[hamiltonian]
pub(crate) fn henon_heiles(q: [f64; 2], p: [f64; 2], lambda: f64) -> f64 {
    let [x, y] = q;
    (p[0] * p[0] + p[1] * p[1] + x * x + y * y) / 2.0 + lambda * (x * x * y - y * y * y / 3.0)
}

/// Sun, Jupiter, Saturn, Uranus, Neptune, Pluto.
#[hamiltonian(coordinates = jacobi)]
pub(crate) fn outer_solar_system(q: [Vector3<f64>; 6], p: [Vector3<f64>; 6], m: [f64; 6], g: f64) -> f64 {
    let mut energy = 0.0;
    for i in 0..6 {
        energy += p[i].norm_squared() / (2.0 * m[i]);
        for j in 0..i {
            energy -= g * m[i] * m[j] / (q[i] - q[j]).norm();
        }
    }
    energy
}

/// Two pendulums, the second hanging from the first; angles from the vertical.
#[hamiltonian]
pub(crate) fn double_pendulum(q: [f64; 2], p: [f64; 2], m: [f64; 2], l: [f64; 2], g: f64) -> f64 {
    let total = m[0] + m[1];
    let (sin, cos) = (q[0] - q[1]).sin_cos();
    let kinetic = (m[1] * l[1] * l[1] * p[0] * p[0] + total * l[0] * l[0] * p[1] * p[1]
        - 2.0 * m[1] * l[0] * l[1] * p[0] * p[1] * cos)
        / (2.0 * m[1] * l[0] * l[0] * l[1] * l[1] * (m[0] + m[1] * sin * sin));
    kinetic - total * g * l[0] * q[0].cos() - m[1] * g * l[1] * q[1].cos()
}

/// Predators and prey.
#[hamiltonian(structure = [[0.0, -x[0] * x[1]], [x[0] * x[1], 0.0]])]
pub(crate) fn lotka_volterra(x: [f64; 2], a: f64, b: f64, c: f64) -> f64 {
    b * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()
}

/// A free body; x is the angular momentum.
#[hamiltonian(structure = so3)]
pub(crate) fn free_momentum(x: [f64; 3], inertia: [f64; 3]) -> f64 {
    (0..3).map(|i| x[i] * x[i] / (2.0 * inertia[i])).sum()
}

/// The same; x is the angular velocity.
#[hamiltonian(structure = |i, j| {
    let k = 3 - i - j;
    (if j == i + 1 { -1.0 } else { 1.0 }) * inertia[k] * x[k] / (inertia[i] * inertia[j])
})]
pub(crate) fn free_velocity(x: [f64; 3], inertia: [f64; 3]) -> f64 {
    (0..3).map(|i| inertia[i] * x[i] * x[i] / 2.0).sum()
}

/// A heavy body about a fixed point.
#[hamiltonian(attitude = r)]
pub(crate) fn heavy_body(r: UnitQuaternion<f64>, m: Vector3<f64>, inertia: [f64; 3], c: Vector3<f64>) -> f64 {
    (m.x * m.x / inertia[0] + m.y * m.y / inertia[1] + m.z * m.z / inertia[2]) / 2.0 + (r * c).z
}

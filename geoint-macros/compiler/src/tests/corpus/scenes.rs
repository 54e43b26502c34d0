//! Short functions of all eight forms. This file is read by the corpus, and no part of the crate.

/// Coupled coordinates without a kick and a drift of one coordinate.
#[hamiltonian]
fn coupled(q: [f64; 2], p: [f64; 2]) -> f64 {
    (1.0 + q[0] * q[0]) * p[0] * p[0] + p[1] * q[1]
}

/// A branch, explicit time, and no parameters. The kinetic energy is not quadratic.
#[hamiltonian(name = Spring)]
fn half_spring(q: f64, p: f64, t: f64) -> f64 {
    (1.0 + p * p).sqrt() + if q > 0.0 { q.powi(4) * t.cos() } else { 0.0 }
}

/// A field with an integral.
#[vector_field(keeps(radius = x[0] * x[0] + x[1] * x[1]))]
fn turning(x: [f64; 2], w: f64) -> [f64; 2] {
    [-w * x[1], w * x[0]]
}

#[contact_hamiltonian]
fn damped(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 - q.cos() + gamma * s
}

#[hamiltonian(attitude = r)]
fn rotor(r: UnitQuaternion<f64>, m: Vector3<f64>, inertia: [f64; 3]) -> f64 {
    (m.x * m.x / inertia[0] + m.y * m.y / inertia[1] + m.z * m.z / inertia[2]) / 2.0
}

#[hamiltonian(structure = so3)]
fn spin(x: [f64; 3], inertia: [f64; 3]) -> f64 {
    (x[0] * x[0] / inertia[0] + x[1] * x[1] / inertia[1] + x[2] * x[2] / inertia[2]) / 2.0
}

#[lagrangian]
fn bead(q: f64, v: f64, g: f64) -> f64 {
    (1.0 + q * q) * v * v / 2.0 - g * q * q / 2.0
}

/// A Lagrangian with an action.
#[lagrangian]
fn fading(q: f64, v: f64, s: f64, gamma: f64) -> f64 {
    v * v / 2.0 + q.cos() - gamma * s
}

/// A Lagrangian that is linear in velocities.
#[lagrangian]
fn vortex(q: [f64; 2], v: [f64; 2], k: f64) -> f64 {
    k * q[0] * v[1] - (1.0 + q[0] * q[0] + q[1] * q[1]).ln()
}

#[energy_function]
fn well(x: f64) -> f64 {
    x.powi(4) - x * x
}

#[hamiltonian(with(well))]
fn in_a_well(q: f64, p: f64) -> f64 {
    p * p / 2.0 + well(q)
}

//! Lagrangians with an action, and energies by hand.

use geoint_runtime::prelude::*;

/// Three rods whose masses grow with the action, in a field that is linear in velocities.
#[lagrangian]
pub(super) fn chain(q: [f64; 3], v: [f64; 3], s: f64, m: [f64; 3], c: f64) -> f64 {
    let squares = m[0] * v[0] * v[0] + m[1] * v[1] * v[1] + m[2] * v[2] * v[2];
    let coupled = m[1] * v[0] * v[1] * (q[0] - q[1]).cos()
        + m[2] * (v[1] * v[2] * (q[1] - q[2]).cos() + 0.5 * v[0] * v[2] * (q[0] - q[2]).cos());
    (1.0 + s / 10.0) * (squares + 0.8 * coupled) + (0.3 + s / 5.0) * q[1] * v[0] + 2.0 * q[0].cos() + q[2].cos()
        - c * s
        - s * s / 40.0
}

/// The same by hand, with M = LDLᵀ.
#[contact_hamiltonian]
pub(super) fn chain_by_hand(q: [f64; 3], p: [f64; 3], s: f64, m: [f64; 3], c: f64) -> f64 {
    let w = 1.0 + s / 10.0;
    let [a, b, d] = [
        0.8 * m[1] * (q[0] - q[1]).cos() * w,
        0.8 * m[2] * (q[1] - q[2]).cos() * w,
        0.4 * m[2] * (q[0] - q[2]).cos() * w,
    ];
    let d0 = 2.0 * m[0] * w;
    let (l10, l20) = (a / d0, d / d0);
    let d1 = 2.0 * m[1] * w - a * l10;
    let l21 = (b - d * l10) / d1;
    let d2 = 2.0 * m[2] * w - d * l20 - (b - d * l10) * l21;
    let y0 = p[0] - (0.3 + s / 5.0) * q[1];
    let y1 = p[1] - l10 * y0;
    let y2 = p[2] - l20 * y0 - l21 * y1;
    0.5 * (y0 * y0 / d0 + y1 * y1 / d1 + y2 * y2 / d2) - 2.0 * q[0].cos() - q[2].cos() + c * s + s * s / 40.0
}

/// Friction that depends on time alone: s follows, and need not be solved for.
#[lagrangian]
pub(super) fn braked_chain(q: [f64; 3], v: [f64; 3], s: f64, t: f64, m: [f64; 3], c: f64) -> f64 {
    let squares = m[0] * v[0] * v[0] + m[1] * v[1] * v[1] + m[2] * v[2] * v[2];
    let coupled = m[1] * v[0] * v[1] * (q[0] - q[1]).cos() + m[2] * v[1] * v[2] * (q[1] - q[2]).cos();
    squares + 0.8 * coupled + 2.0 * q[0].cos() + q[2].cos() + 0.2 * t * q[1] - c * (1.0 + t.sin() / 2.0) * s
}

/// The same for a constant c, and without the push.
#[lagrangian]
pub(super) fn fading_chain(q: [f64; 3], v: [f64; 3], s: f64, m: [f64; 3], c: f64) -> f64 {
    let squares = m[0] * v[0] * v[0] + m[1] * v[1] * v[1] + m[2] * v[2] * v[2];
    let coupled = m[1] * v[0] * v[1] * (q[0] - q[1]).cos() + m[2] * v[1] * v[2] * (q[1] - q[2]).cos();
    squares + 0.8 * coupled + 2.0 * q[0].cos() + q[2].cos() - c * s
}

/// Its friction as that of Rayleigh's function.
#[lagrangian(rayleigh = c * (m[0] * v[0] * v[0] + m[1] * v[1] * v[1] + m[2] * v[2] * v[2]
    + 0.8 * (m[1] * v[0] * v[1] * (q[0] - q[1]).cos() + m[2] * v[1] * v[2] * (q[1] - q[2]).cos())))]
pub(super) fn rubbed_chain(q: [f64; 3], v: [f64; 3], m: [f64; 3], c: f64) -> f64 {
    let squares = m[0] * v[0] * v[0] + m[1] * v[1] * v[1] + m[2] * v[2] * v[2];
    let coupled = m[1] * v[0] * v[1] * (q[0] - q[1]).cos() + m[2] * v[1] * v[2] * (q[1] - q[2]).cos();
    squares + 0.8 * coupled + 2.0 * q[0].cos() + q[2].cos()
}

/// Two masses in the plane with something between them that resists being drawn out, and friction that grows with the action.
#[lagrangian]
pub(super) fn fading_telescope(q: [[f64; 2]; 2], v: [[f64; 2]; 2], s: f64, m: [f64; 2], c: f64) -> f64 {
    let [x, y] = [q[1][0] - q[0][0], q[1][1] - q[0][1]];
    let drawn = x * (v[1][0] - v[0][0]) + y * (v[1][1] - v[0][1]);
    0.5 * m[0] * (v[0][0] * v[0][0] + v[0][1] * v[0][1])
        + 0.5 * m[1] * (v[1][0] * v[1][0] + v[1][1] * v[1][1])
        + 0.5 * c * drawn * drawn
        - (x * x + y * y).powi(2)
        - 0.2 * s
        - 0.05 * s * s
}

/// v⁴ + v², of no known conjugate, with friction.
#[lagrangian]
pub(super) fn stiff(q: f64, v: f64, s: f64, c: f64) -> f64 {
    0.5 * v * v + 0.25 * v.powi(4) - 0.5 * q * q - c * s - s * s / 20.0
}

/// Whose mass matrix is singular where q₀ = 0.
#[lagrangian]
pub(super) fn vanishing(q: [f64; 3], v: [f64; 3], s: f64, m: f64) -> f64 {
    let shifted = v[1] + 0.3 * v[0] * q[2].cos();
    0.5 * m * q[0] * v[0] * v[0] + 0.5 * shifted * shifted + 0.7 * (v[2] + 0.2 * v[1] * q[0].sin()).powi(2)
        - 0.5 * q[1] * q[1]
        - 0.5 * q[2] * q[2]
        - 0.1 * s
}

/// The double pendulum with an action in its masses, its field and its weight, and a third coordinate at rest relative to the first: where its
/// momentum is 0 it adds nothing, but couples three velocities.
#[lagrangian]
pub(super) fn pendulum_with_another(q: [f64; 3], v: [f64; 3], s: f64, m: [f64; 2], l: [f64; 2], g: f64) -> f64 {
    let x = [l[0] * v[0], l[1] * v[1]];
    let coupling = 2.0 * x[0] * x[1] * (q[0] - q[1]).cos();
    let kinetic = 0.5 * m[0] * x[0].powi(2) + 0.5 * m[1] * (x[0].powi(2) + x[1].powi(2) + coupling);
    (1.0 + s / 10.0) * kinetic
        + (q[1] + s * q[0] / 5.0) * v[0]
        + (m[0] + m[1]) * g * l[0] * q[0].cos()
        + m[1] * g * l[1] * q[1].cos()
        - 0.3 * s
        - s * s / 40.0
        + 0.5 * (v[2] + 0.3 * v[0]).powi(2)
}

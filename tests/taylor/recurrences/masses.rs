//! Systems whose series use forces written in velocities. The reference is the truncated series of the rates that every other method uses.

use geoint_runtime::prelude::*;
use geoint_runtime::private::Jets;
use geoint_runtime::scalar::Series;
use geoint_tests::jets::{BAR, Both, N, of_contact, of_field};

/// Asserts that both ways give the same coefficients.
fn check(name: &str, both: &Both) {
    assert!(both.error() <= BAR, "{name}: {:.1e}", both.error());
}

#[hamiltonian]
fn double_pendulum(q: [f64; 2], p: [f64; 2], m1: f64, m2: f64, l1: f64, l2: f64, g: f64) -> f64 {
    let (sin, cos) = (q[0] - q[1]).sin_cos();
    let numerator =
        m2 * l2 * l2 * p[0] * p[0] + (m1 + m2) * l1 * l1 * p[1] * p[1] - 2.0 * m2 * l1 * l2 * p[0] * p[1] * cos;
    let denominator = 2.0 * m2 * l1 * l1 * l2 * l2 * (m1 + m2 * sin * sin);
    numerator / denominator - (m1 + m2) * g * l1 * q[0].cos() - m2 * g * l2 * q[1].cos()
}

#[hamiltonian(damping = 0.3 + 0.1 * q[0].cos())]
fn arm(q: [f64; 2], p: [f64; 2]) -> f64 {
    let (a, b, c) = (3.1, 1.2, 0.9);
    let cos = q[1].cos();
    let determinant = a * b - b * b - c * c * cos * cos;
    (b * p[0] * p[0] - 2.0 * (b + c * cos) * p[0] * p[1] + (a + 2.0 * c * cos) * p[1] * p[1]) / (2.0 * determinant)
        + 1.7 * q[0].sin()
        + 0.4 * (q[0] + q[1]).sin()
}

#[hamiltonian]
fn spring(q: [f64; 2], p: [f64; 2]) -> f64 {
    let m = 1.3;
    (p[0] * p[0] + p[1] * p[1] / (q[0] * q[0])) / (2.0 * m) + 2.1 * (q[0] - 0.8) * (q[0] - 0.8)
        - 9.81 * m * q[0] * q[1].cos()
}

/// The angle is in nothing else: its momentum is a number.
#[hamiltonian]
fn kepler(q: [f64; 2], p: [f64; 2]) -> f64 {
    p[0] * p[0] / 2.6 + p[1] * p[1] / (2.6 * q[0] * q[0]) - 1.3 / q[0]
}

/// On a wire that moves, with momenta that are not those of velocities alone.
#[hamiltonian]
fn bead(q: f64, p: f64, t: f64) -> f64 {
    let momentum = p - 0.4 * q * q * t.sin();
    momentum * momentum / (2.0 * (1.0 + 0.7 * q * q + 0.2 * t * t)) + 0.7 * q * q
}

/// One mass for two momenta that are coupled, and one for a third.
#[hamiltonian]
fn conformal(q: [f64; 3], p: [f64; 3]) -> f64 {
    let mass = 1.7 + q[0].cos() * q[1].sin();
    (p[0] * p[0] + 0.6 * p[1] * p[1] + 0.3 * p[0] * p[1]) / (2.0 * mass)
        + p[2] * p[2] / (1.0 + q[0] * q[0])
        + p[2] * q[1]
        + q[0] * q[1] * q[2]
}

#[contact_hamiltonian]
fn sliding(q: f64, p: f64, s: f64) -> f64 {
    p * p / (2.0 + q * q + 0.1 * s * s) + 0.3 * q * q + 0.2 * s
}

#[lagrangian]
fn carriage(q: [f64; 2], v: [f64; 2], t: f64) -> f64 {
    v[0] * v[0] + v[1] * v[1] / 2.0 + v[0] * v[1] * q[1].cos() + 0.3 * q[0] * v[1] + q[1].cos() - 0.2 * q[0] * t.sin()
}

/// Its momentum is no multiple of the velocity.
#[lagrangian]
fn relativistic(q: f64, v: f64) -> f64 {
    -(1.0 - v * v).sqrt() * (1.0 + 0.3 * q * q)
}

#[test]
fn forces_in_velocities() {
    let pendulum = DoublePendulum { m1: 1.3, m2: 0.7, l1: 0.9, l2: 1.2, g: 9.81 };
    let [m1, m2, l1, l2, g] = [1.3, 0.7, 0.9, 1.2, 9.81].map(Series::<f64, N>::constant);
    let over = DoublePendulum { m1, m2, l1, l2, g };
    check("double pendulum", &of_field(&pendulum, &over, 0.0, &[1.0, 1.2, 0.3, -0.8]));
    check("arm", &of_field(&Arm, &Arm, 0.0, &[0.7, -0.4, 0.3, 1.1]));
    check("spring", &of_field(&Spring, &Spring, 0.0, &[0.9, -0.4, 0.3, 1.1]));
    check("kepler", &of_field(&Kepler, &Kepler, 0.0, &[0.9, -0.4, 0.3, 1.1]));
    check("bead", &of_field(&Bead, &Bead, 0.3, &[0.9, -0.4]));
    check("conformal", &of_field(&Conformal, &Conformal, 0.0, &[0.9, -0.4, 0.2, 0.3, 1.1, -0.6]));
    check("sliding", &of_contact(&Sliding, &Sliding, 0.0, &[0.9, -0.4, 0.3]));
    check("carriage", &of_field(&Carriage, &Carriage, 0.3, &[0.9, -0.4, 0.3, 1.1]));
    check("relativistic", &of_field(&Relativistic, &Relativistic, 0.0, &[0.9, 0.4]));
}

/// The number of convolutions equals a calculation by hand: sine and cosine of three angles, sin², p·cos of both momenta, two velocities, their product and
/// its product with sin.
#[test]
fn the_double_pendulum_is_as_short_as_by_hand() {
    assert_eq!(<DoublePendulum as Jets>::CONVOLUTIONS, 13);
}

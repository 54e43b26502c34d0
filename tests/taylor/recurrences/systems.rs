//! Every kind of system against truncated series as a scalar.

use geoint_runtime::prelude::*;
use geoint_runtime::private::Jets;
use geoint_runtime::scalar::Real;
use geoint_tests::jets::{BAR, Both, N, by_series, error, of_contact, of_field};

/// Asserts that both ways give the same coefficients.
fn check(name: &str, both: &Both) {
    assert!(both.error() <= BAR, "{name}: {:.1e}", both.error());
}

#[hamiltonian]
fn coupled(q: [f64; 2], p: [f64; 2]) -> f64 {
    let mass = 1.7 + q[0].cos() * q[1].sin();
    (p[0] * p[0] + 0.6 * p[1] * p[1] + 0.3 * p[0] * p[1]) / (2.0 * mass) + (q[0] * q[1]).exp() + q[1].atan2(q[0])
}

#[hamiltonian]
fn driven(q: f64, p: f64, t: f64) -> f64 {
    p * p / (1.4 + t * t) + q.powi(4) / 4.0 - 0.3 * q * (1.3 * t + 0.2).cos() + (-0.4 * t).exp() * q.tanh()
}

#[hamiltonian(damping = 0.2 + q * q)]
fn damped(q: f64, p: f64) -> f64 {
    p * p / 2.6 - 1.7 * q.cos()
}

#[contact_hamiltonian]
fn twice_damped(q: [f64; 2], p: [f64; 2], s: f64, t: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.4 - (q[0] - q[1]).cos() + (0.2 + 0.1 * s.sin()) * s + 0.1 * t * q[0]
}

#[hamiltonian(structure = so3)]
fn top(x: [f64; 3]) -> f64 {
    x[0] * x[0] / 1.4 + x[1] * x[1] / 2.3 + x[2] * x[2] / 3.9 + 0.2 * x[0].powi(3)
}

#[vector_field]
fn van_der_pol(x: [f64; 2]) -> [f64; 2] {
    [x[1], 5.0 * (1.0 - x[0] * x[0]) * x[1] - x[0]]
}

#[lagrangian]
fn double_pendulum(q: [f64; 2], v: [f64; 2]) -> f64 {
    v[0] * v[0] + v[1] * v[1] / 2.0 + v[0] * v[1] * (q[0] - q[1]).cos() + 9.81 * (2.0 * q[0].cos() + q[1].cos())
}

#[hamiltonian]
fn branches(q: f64, p: f64) -> f64 {
    let wall = if q > 1.0 { (q - 1.0).powi(2) } else { 0.3 * (q - 1.0).powi(3) };
    p * p / 2.6 + wall + (q - 0.3).abs() * p.max(q) + (p * q).min(0.1)
}

#[hamiltonian]
fn powers(q: f64, p: f64) -> f64 {
    let r = 1.0 + q * q;
    p.powi(3) / 3.0
        + r.powf(-1.5)
        + r.powf(-2.5)
        + r.sqrt()
        + 1.0 / r
        + q.powi(7)
        + (2.0 + q).powf(p)
        + (3.0 + p).cbrt()
        + 2.0_f64.powf(q)
        + (q / 9.0).asin()
        + (q / 7.0).acos()
        + (q / 8.0).atanh()
        + q.asinh()
        + (2.0 + r).acosh()
        + r.ln()
        + r.log10()
        + q.ln_1p() * p.exp_m1()
        + q.tan()
        + p.sinh()
        + q.cosh()
        + q.hypot(p)
        + r.log2()
}

#[test]
fn every_kind_of_system() {
    check("coupled", &of_field(&Coupled, &Coupled, 0.0, &[0.7, -0.4, 0.3, 1.1]));
    check("driven", &of_field(&Driven, &Driven, 0.3, &[0.7, -0.4]));
    check("damped", &of_field(&Damped, &Damped, 0.0, &[0.7, -0.4]));
    check("top", &of_field(&Top, &Top, 0.0, &[0.7, -0.4, 0.9]));
    check("van der pol", &of_field(&VanDerPol, &VanDerPol, 0.0, &[1.9, -0.4]));
    check("double pendulum", &of_field(&DoublePendulum, &DoublePendulum, 0.0, &[1.0, 1.2, 0.3, -0.8]));
    check("branches", &of_field(&Branches, &Branches, 0.0, &[0.7, -0.4]));
    check("branches", &of_field(&Branches, &Branches, 0.0, &[1.3, 0.4]));
    check("powers", &of_field(&Powers, &Powers, 0.0, &[0.4, 0.3]));
    check("contact", &of_contact(&TwiceDamped, &TwiceDamped, 0.2, &[0.7, -0.4, 0.3, 1.1, 0.6]));
}

#[test]
fn a_recurrence_that_is_wrong_is_seen() {
    let right = by_series::<f64, N>(&[0.7, -0.4], |x, _| vec![x[1], -Real::sin(x[0])], 0.0);
    let mut wrong: Vec<Vec<f64>> = right.iter().map(|x| x[1..].to_vec()).collect();
    assert_eq!(error(&wrong, &right), 0.0);
    wrong[1][12] *= 1.0 + 1e-11;
    assert!(error(&wrong, &right) > BAR);
}

/// Numbers of the step on either side of a factor.
#[vector_field]
fn reaction(x: [f64; 2], a: f64, b: f64) -> [f64; 2] {
    [-(a * x[0] * x[1]), b * (x[0] * x[1])]
}

/// The kernel has one product of series, x₀·x₁, whatever numbers stand between its factors.
#[test]
fn numbers_are_drawn_out_of_products() {
    assert_eq!(<Reaction as Jets>::CONVOLUTIONS, 1);
}

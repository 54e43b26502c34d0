//! T36: from an energy H(q, p, t) to its Lagrangian, and from velocities to momenta. Numbers follow from the formulas in the comments.

use geoint_runtime::methods::Rattle;
use geoint_runtime::prelude::*;

/// Example 2.2.7 of the thesis with F = fp²/2: L = (v + 2q)²/(2(f − 2q)) − q².
#[hamiltonian]
fn one_equation(q: f64, p: f64, f: f64) -> f64 {
    -p * p * q + q * q - 2.0 * p * q + f * p * p / 2.0
}

/// L = −mc²√(1 − v²/c²) − q²/2.
#[hamiltonian]
fn relativistic(q: f64, p: f64, m: f64, c: f64) -> f64 {
    (p * p * c * c + m * m * c.powi(4)).sqrt() + q * q / 2.0
}

/// Two coupled masses in a wind a(t): L = (v − a)·M(v − a)/2 − V with M the inverse of [2 1; 1 3].
#[hamiltonian]
fn coupled(q: [f64; 2], p: [f64; 2], t: f64, v: f64) -> f64 {
    (2.0 * p[0] * p[0] + 2.0 * p[0] * p[1] + 3.0 * p[1] * p[1]) / 2.0 + p[0] * t.sin() + p[1] * v + q[0] * q[0] * q[1]
}

/// ∂H/∂p = p³ + p has no formula here.
#[hamiltonian]
fn quartic(q: f64, p: f64) -> f64 {
    p.powi(4) / 4.0 + p * p / 2.0 + q * q / 2.0
}

/// A pendulum in Cartesian coordinates, of mass m.
#[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] - 1.0])]
fn hanging(q: [f64; 2], p: [f64; 2], m: f64, g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + m * g * q[1]
}

/// The equation of example 2.2.7 as a Lagrangian.
#[lagrangian]
fn one_equation_by_velocity(q: f64, v: f64, f: f64) -> f64 {
    (v + 2.0 * q) * (v + 2.0 * q) / (2.0 * (f - 2.0 * q)) - q * q
}

#[test]
fn the_example_of_the_thesis_has_its_lagrangian() {
    let (system, own) = (OneEquation { f: 3.0 }, OneEquationByVelocity { f: 3.0 });
    let state = system.at(0.5, 0.4);
    // (0.4 + 1)²/(2·2) − 0.25, and p = (v + 2q)/(f − 2q).
    assert!((system.lagrangian(&state) - 0.24).abs() < 1e-15, "{}", system.lagrangian(&state));
    assert!((state.p - 0.7).abs() < 1e-15, "{}", state.p);
    assert!((own.lagrangian(0.0, 0.5, 0.4) - 0.24).abs() < 1e-15 && (own.at(0.5, 0.4).p - state.p).abs() < 1e-15);
    assert!((own.energy(&state) - system.energy(&state)).abs() < 1e-15);
    // Singular at q = f/2: no momentum belongs to a velocity.
    assert!(!system.at(1.5, 0.4).p.is_finite());
    assert!(OneEquation::REPORT.contains("with v = ∂H/∂p"), "{}", OneEquation::REPORT);
    // Control: H is not L, and p is not v.
    assert!((system.energy(&state) - 0.24).abs() > 0.1);
}

#[test]
fn a_fast_particle_has_its_lagrangian() {
    let system = Relativistic { m: 1.3, c: 1.0 };
    let velocity = 0.499_722_453_489_577_1;
    let state = system.at(0.4, velocity);
    assert!((state.p - 0.75).abs() < 1e-15, "{}", state.p);
    let found = system.lagrangian(&State::new(0.4, 0.75));
    assert!((found + 1.206_041_261_863_180_6).abs() < 1e-15, "{found}");
    // Faster than light.
    assert!(system.at(0.4, 1.1).p.is_nan());
}

#[test]
fn linear_terms_and_time_are_part_of_momenta() {
    let system = Coupled { v: 0.3 };
    let (t, q, v) = (0.7_f64, [0.4, -0.6], [0.9, -0.2]);
    let state = system.at_time(t, q, v);
    // M = [3 −1; −1 2]/5.
    let u = [v[0] - t.sin(), v[1] - 0.3];
    let p = [(3.0 * u[0] - u[1]) / 5.0, (2.0 * u[1] - u[0]) / 5.0];
    let lagrangian = (u[0] * p[0] + u[1] * p[1]) / 2.0 - q[0] * q[0] * q[1];
    assert!((0..2).all(|i| (state.p[i] - p[i]).abs() < 1e-15) && state.t == t, "{state:?}");
    assert!((system.lagrangian(&state) - lagrangian).abs() < 1e-15, "{}", system.lagrangian(&state));
    // The parameter has the usual name of velocities.
    assert!(Coupled::REPORT.contains("with q' = ∂H/∂p"), "{}", Coupled::REPORT);
    // Control: `at` is at t = 0.
    assert!((system.at(q, v).p[0] - p[0]).abs() > 0.1);
}

#[test]
fn energies_without_a_formula_have_values() {
    assert!(Quartic::REPORT.contains("∂H/∂p = v has no formula for p: L by values only"), "{}", Quartic::REPORT);
    let (q, p) = (0.3_f64, 0.8_f64);
    let expected = 0.75 * p.powi(4) + p * p / 2.0 - q * q / 2.0;
    assert!((Quartic.lagrangian(&State::new(q, p)) - expected).abs() < 1e-15);
}

#[test]
fn constraints_leave_the_lagrangian_as_it_is() {
    let system = Hanging { m: 1.7, g: 9.81 };
    let state = system.at([0.6, -0.8], [0.8, 0.6]);
    assert!((0..2).all(|i| (state.p[i] - 1.7 * [0.8, 0.6][i]).abs() < 1e-15), "{state:?}");
    let expected = 1.7 / 2.0 + 1.7 * 9.81 * 0.8;
    assert!((system.lagrangian(&state) - expected).abs() < 1e-13, "{}", system.lagrangian(&state));
    let mut sim = system.integrator(Rattle, 0.01, state);
    sim.advance(100).expect("a hundred steps");
}

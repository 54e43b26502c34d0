//! Energies other than T(p) + V(q): with pieces that have flows in closed form, and of degree 3.

use crate::problems::{Over, Problem, Shaped, problems};
use crate::scalars::Scalar;
use geoint_runtime::hamiltonian;

/// A charge in a field that grows, with a mass: two pieces, for which Runge–Kutta–Nyström tables keep their order.
#[hamiltonian]
pub fn sheet(q: [f64; 2], p: [f64; 2], m: f64, b: f64) -> f64 {
    let [x, _] = q;
    (p[0] * p[0] + (p[1] - b * (x + x * x / 4.0)).powi(2)) / (2.0 * m)
}

/// The same where the field has a maximum.
#[hamiltonian]
pub fn ridge(q: [f64; 2], p: [f64; 2], m: f64, b: f64) -> f64 {
    let [x, _] = q;
    (p[0] * p[0] + (p[1] - b * (x - x * x * x / 5.0)).powi(2)) / (2.0 * m)
}

/// With a potential in both coordinates and a field that pulsates: three pieces, one of them at frozen time.
#[hamiltonian]
pub fn pulsating(q: [f64; 2], p: [f64; 2], t: f64, m: f64, b: f64) -> f64 {
    let [x, y] = q;
    (p[0] * p[0] + (p[1] - b * (t * t).sin() * x * x).powi(2)) / (2.0 * m) + (x * y).cos() + 0.3 * y * t
}

/// Four shears.
#[hamiltonian]
pub fn shears(q: f64, p: f64, a: f64) -> f64 {
    (p * p + q * q) / 2.0 + a * q * q * p + a / 2.0 * q * p.powi(3)
}

/// Of degree 3, with terms of all kinds.
#[hamiltonian]
pub fn of_degree_three(q: [f64; 2], p: [f64; 2], m: [f64; 2], a: f64) -> f64 {
    let kinetic = p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]);
    kinetic
        + (q[0] * q[0] + 1.3 * q[1] * q[1]) / 2.0
        + a * (q[0] * q[0] * p[1] + q[1] * p[0] * p[1] - q[1].powi(3) / 4.0)
}

problems! { t q p:
    sheet Sheet { m: 1.5, b: 1.25 } (q, p, m, b) at [0.3, 0.1], [0.5, -0.4];
    ridge Ridge { m: 0.7, b: 1.1 } (q, p, m, b) at [0.3, 0.1], [0.5, -0.4];
    pulsating Pulsating { m: 1.5, b: 1.25 } (q, p, t, m, b) at [0.3, 0.1], [0.5, -0.4];
    shears Shears { a: 0.2 } (q, p, a) at [0.5], [0.3];
    of_degree_three OfDegreeThree { m: [1.6, 0.7], a: 0.3 } (q, p, m, a) at [0.4, -0.3], [0.35, 0.25];
}

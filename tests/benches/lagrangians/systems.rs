//! The systems whose steps are timed.

use geoint_runtime::{hamiltonian, lagrangian};

/// Two pendulums; q angles from below, v their rates.
#[lagrangian]
pub(crate) fn pendulum_of_velocities(q: [f64; 2], v: [f64; 2], m: [f64; 2], l: [f64; 2], g: f64) -> f64 {
    let x = [l[0] * v[0], l[1] * v[1]];
    let coupling = 2.0 * x[0] * x[1] * (q[0] - q[1]).cos();
    let kinetic = 0.5 * m[0] * x[0].powi(2) + 0.5 * m[1] * (x[0].powi(2) + x[1].powi(2) + coupling);
    kinetic + (m[0] + m[1]) * g * l[0] * q[0].cos() + m[1] * g * l[1] * q[1].cos()
}

/// The same with momenta, derived by hand.
#[hamiltonian]
pub(crate) fn pendulum_of_momenta(q: [f64; 2], p: [f64; 2], m: [f64; 2], l: [f64; 2], g: f64) -> f64 {
    let total = m[0] + m[1];
    let (sin, cos) = (q[0] - q[1]).sin_cos();
    let kinetic = (m[1] * l[1] * l[1] * p[0] * p[0] + total * l[0] * l[0] * p[1] * p[1]
        - 2.0 * m[1] * l[0] * l[1] * p[0] * p[1] * cos)
        / (2.0 * m[1] * l[0] * l[0] * l[1] * l[1] * (m[0] + m[1] * sin * sin));
    kinetic - total * g * l[0] * q[0].cos() - m[1] * g * l[1] * q[1].cos()
}

/// Hénon and Heiles' masses: a mass matrix that is constant.
#[lagrangian]
pub(crate) fn cubic_of_velocities(q: [f64; 2], v: [f64; 2], m: [f64; 2]) -> f64 {
    let [x, y] = q;
    0.5 * (m[0] * v[0] * v[0] + m[1] * v[1] * v[1]) - 0.5 * (x * x + y * y) - x * x * y + y.powi(3) / 3.0
}

/// The same with momenta.
#[hamiltonian]
pub(crate) fn cubic_of_momenta(q: [f64; 2], p: [f64; 2], m: [f64; 2]) -> f64 {
    let [x, y] = q;
    0.5 * (p[0] * p[0] / m[0] + p[1] * p[1] / m[1]) + 0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
}

/// Chains of point masses; q angles from below. The energy is that of the mass matrix M = LDLᵀ.
macro_rules! chains {
    ($($n:literal: $velocities:ident, $momenta:ident;)*) => { $(
        #[lagrangian]
        pub(crate) fn $velocities(q: [f64; $n], v: [f64; $n], m: [f64; $n], l: [f64; $n], g: f64) -> f64 {
            let (mut x, mut y, mut depth, mut energy) = (0.0, 0.0, 0.0, 0.0);
            for i in 0..$n {
                let (sin, cos) = q[i].sin_cos();
                x += l[i] * v[i] * cos;
                y += l[i] * v[i] * sin;
                depth += l[i] * cos;
                energy += m[i] * (0.5 * (x * x + y * y) + g * depth);
            }
            energy
        }

        #[hamiltonian]
        pub(crate) fn $momenta(q: [f64; $n], p: [f64; $n], m: [f64; $n], l: [f64; $n], g: f64) -> f64 {
            let mut hanging = [0.0; $n];
            for i in 0..$n {
                for k in i..$n {
                    hanging[i] += m[k];
                }
            }
            let mut upper = [[0.0; $n]; $n];
            let mut lower = [[0.0; $n]; $n];
            let mut y = [0.0; $n];
            let mut energy = 0.0;
            for i in 0..$n {
                y[i] = p[i];
                for j in 0..i {
                    let mut entry = hanging[i] * l[i] * l[j] * (q[i] - q[j]).cos();
                    for k in 0..j {
                        entry -= upper[i][k] * lower[j][k];
                    }
                    upper[i][j] = entry;
                    lower[i][j] = entry / upper[j][j];
                }
                let mut pivot = hanging[i] * l[i] * l[i];
                for k in 0..i {
                    pivot -= upper[i][k] * lower[i][k];
                    y[i] -= lower[i][k] * y[k];
                }
                upper[i][i] = pivot;
                energy += y[i] * y[i] / (2.0 * pivot) - hanging[i] * g * l[i] * q[i].cos();
            }
            energy
        }
    )* };
}

chains! {
    3: chain3, chain3_energy;
    6: chain6, chain6_energy;
}

/// The double pendulum that loses energy by the action.
#[lagrangian]
pub(crate) fn braked(q: [f64; 2], v: [f64; 2], s: f64, m: [f64; 2], l: [f64; 2], g: f64, gamma: f64) -> f64 {
    let x = [l[0] * v[0], l[1] * v[1]];
    let coupling = 2.0 * x[0] * x[1] * (q[0] - q[1]).cos();
    let kinetic = 0.5 * m[0] * x[0].powi(2) + 0.5 * m[1] * (x[0].powi(2) + x[1].powi(2) + coupling);
    kinetic + (m[0] + m[1]) * g * l[0] * q[0].cos() + m[1] * g * l[1] * q[1].cos() - gamma * s
}

/// A mass that grows with the action.
#[lagrangian]
pub(crate) fn growing(q: f64, v: f64, s: f64, t: f64, a: f64) -> f64 {
    0.5 * v * v * (1.0 + s / 5.0) + q.cos() - a * s * s - t.sin() * s / 4.0
}

/// A quartic oscillator in the plane with dissipation that is not linear.
#[lagrangian]
pub(crate) fn fading(q: [f64; 2], v: [f64; 2], s: f64, a: f64) -> f64 {
    let r = q[0] * q[0] + q[1] * q[1];
    0.5 * (v[0] * v[0] + v[1] * v[1]) - 0.25 * r * r - a * s - 0.5 * a * s * s
}

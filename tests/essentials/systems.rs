//! The systems of the essential tests. They are nonlinear, and their masses differ from 1.

use geoint_runtime::{contact_hamiltonian, energy_function, hamiltonian, lagrangian, vector_field};
use nalgebra::{UnitQuaternion, Vector3};

/// Two oscillators with a cubic coupling (M. Hénon & C. Heiles, 1964): T + V with a quadratic T.
#[hamiltonian]
pub(crate) fn henon_heiles(q: [f64; 2], p: [f64; 2], m: [f64; 2], a: f64) -> f64 {
    let kinetic = p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]);
    kinetic + (q[0] * q[0] + q[1] * q[1]) / 2.0 + a * (q[0] * q[0] * q[1] - q[1].powi(3) / 3.0)
}

/// A body that falls towards a fixed centre: angular momentum is conserved.
#[hamiltonian]
pub(crate) fn kepler(q: [f64; 2], p: [f64; 2], m: f64, k: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - k / (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// A star with a light planet and a lighter one, in Jacobi's coordinates.
#[hamiltonian(coordinates = jacobi)]
pub(crate) fn planets(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3], g: f64) -> f64 {
    let mut energy = 0.0;
    for i in 0..3 {
        energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
        for j in 0..i {
            energy -= g * m[i] * m[j] / ((q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2)).sqrt();
        }
    }
    energy
}

/// One degree of freedom in which q and p are coupled; every term has a flow in closed form.
#[hamiltonian]
pub(crate) fn shears(q: f64, p: f64, a: f64) -> f64 {
    (p * p + q * q) / 2.0 + a * q * q * p + a / 2.0 * q * p.powi(3)
}

/// A planar pendulum whose potential is a function from outside.
#[hamiltonian(with(height))]
pub(crate) fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
    p * p / (2.0 * m * l * l) + m * g * height(q, l)
}

/// Height above the pivot.
#[energy_function]
pub(crate) fn height(angle: f64, l: f64) -> f64 {
    -l * angle.cos()
}

/// A pendulum with friction.
#[hamiltonian(damping = c)]
pub(crate) fn braked(q: f64, p: f64, m: f64, g: f64, c: f64) -> f64 {
    p * p / (2.0 * m) - m * g * q.cos()
}

/// A bob on a sphere of radius l.
#[hamiltonian(constraint = [q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - l * l])]
pub(crate) fn on_a_sphere(q: [f64; 3], p: [f64; 3], m: f64, l: f64, g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) + m * g * q[2]
}

/// A free rigid body in its momenta: x' = S(x) ∇H with the structure of rotations.
#[hamiltonian(structure = [[0.0, -x[2], x[1]], [x[2], 0.0, -x[0]], [-x[1], x[0], 0.0]])]
pub(crate) fn free_body(x: [f64; 3], inertia: [f64; 3]) -> f64 {
    x[0] * x[0] / (2.0 * inertia[0]) + x[1] * x[1] / (2.0 * inertia[1]) + x[2] * x[2] / (2.0 * inertia[2])
}

/// A heavy rigid body by its attitude r and its momentum m.
#[hamiltonian(attitude = r)]
pub(crate) fn heavy(r: UnitQuaternion<f64>, m: Vector3<f64>, inertia: [f64; 3], c: Vector3<f64>) -> f64 {
    let kinetic = m[0] * m[0] / inertia[0] + m[1] * m[1] / inertia[1] + m[2] * m[2] / inertia[2];
    kinetic / 2.0 + (r * c)[2]
}

/// Predators and prey, with the integral that Volterra found.
#[vector_field(keeps(cycle = b * x[0] - c * x[0].ln() + b * x[1] - a * x[1].ln()))]
pub(crate) fn animals(x: [f64; 2], a: f64, b: f64, c: f64) -> [f64; 2] {
    [x[0] * (a - b * x[1]), x[1] * (b * x[0] - c)]
}

/// A pendulum with friction as a contact system.
#[contact_hamiltonian]
pub(crate) fn damped(q: f64, p: f64, s: f64, m: f64, g: f64, gamma: f64) -> f64 {
    p * p / (2.0 * m) - m * g * q.cos() + gamma * s
}

/// The pendulum by its Lagrangian.
#[lagrangian]
pub(crate) fn swinging(q: f64, v: f64, m: f64, l: f64, g: f64) -> f64 {
    m * l * l * v * v / 2.0 + m * g * l * q.cos()
}

/// Three joints whose mass matrix has no short inverse: velocities are the unknowns.
#[lagrangian]
pub(crate) fn arm(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
    let coupled = v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[1] - q[2]).cos();
    m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + coupled) + q[0].cos() + q[2].cos()
}

/// The damped pendulum by the principle of Herglotz: the Lagrangian reads the action.
#[lagrangian]
pub(crate) fn herglotz(q: f64, v: f64, s: f64, m: f64, g: f64, gamma: f64) -> f64 {
    m * v * v / 2.0 + m * g * q.cos() - gamma * s
}

/// Predators and prey by a Lagrangian that is linear in the velocities.
#[lagrangian]
pub(crate) fn linear(q: [f64; 2], v: [f64; 2], a: f64, b: f64, c: f64) -> f64 {
    let [x, y] = q;
    y.ln() / x * v[0] + b * x - c * x.ln() + b * y - a * y.ln()
}

pub(crate) const HENON_HEILES: HenonHeiles = HenonHeiles { m: [1.3, 0.8], a: 0.9 };
pub(crate) const KEPLER: Kepler = Kepler { m: 1.3, k: 1.7 };
pub(crate) const PLANETS: Planets = Planets { m: [1.3, 0.002, 0.001], g: 1.1 };
pub(crate) const SHEARS: Shears = Shears { a: 0.2 };
pub(crate) const PENDULUM: Pendulum = Pendulum { m: 1.3, l: 0.7, g: 9.81 };
pub(crate) const BRAKED: Braked = Braked { m: 1.3, g: 1.1, c: 0.4 };
pub(crate) const ON_A_SPHERE: OnASphere = OnASphere { m: 1.4, l: 1.5, g: 2.1 };
pub(crate) const FREE_BODY: FreeBody = FreeBody { inertia: [1.3, 2.1, 3.0] };
pub(crate) const ANIMALS: Animals = Animals { a: 1.0, b: 0.7, c: 0.5 };
pub(crate) const DAMPED: Damped = Damped { m: 1.3, g: 1.1, gamma: 0.4 };
pub(crate) const SWINGING: Swinging = Swinging { m: 1.3, l: 0.7, g: 9.81 };
pub(crate) const ARM: Arm = Arm { m: 0.7 };
pub(crate) const HERGLOTZ: Herglotz = Herglotz { m: 1.3, g: 1.1, gamma: 0.4 };
pub(crate) const LINEAR: Linear = Linear { a: 1.0, b: 0.7, c: 0.5 };

/// A heavy body; c is not a constant expression.
pub(crate) fn heavy_body() -> Heavy {
    Heavy { inertia: [1.3, 2.1, 3.0], c: Vector3::new(0.3, -0.2, 0.7) }
}

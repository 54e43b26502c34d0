//! Lagrangians, with parameters that are not 1 where the published solution has others.

use geoint_runtime::prelude::*;

/// ½q'² − ½q² + εqq'² − δq³: the mass depends on the position. Aung (2000), example 2.2.1.
#[lagrangian]
pub(crate) fn cubic(q: f64, v: f64, epsilon: f64, delta: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q + epsilon * q * v * v - delta * q.powi(3)
}

/// Two pendulums; q angles from below, v their rates.
#[lagrangian]
pub(crate) fn double_pendulum(q: [f64; 2], v: [f64; 2], m: [f64; 2], l: [f64; 2], g: f64) -> f64 {
    let x = [l[0] * v[0], l[1] * v[1]];
    let coupling = 2.0 * x[0] * x[1] * (q[0] - q[1]).cos();
    let kinetic = 0.5 * m[0] * x[0].powi(2) + 0.5 * m[1] * (x[0].powi(2) + x[1].powi(2) + coupling);
    kinetic + (m[0] + m[1]) * g * l[0] * q[0].cos() + m[1] * g * l[1] * q[1].cos()
}

/// The same that loses energy by the action.
#[lagrangian]
pub(crate) fn braked(q: [f64; 2], v: [f64; 2], s: f64, m: [f64; 2], l: [f64; 2], g: f64, gamma: f64) -> f64 {
    let x = [l[0] * v[0], l[1] * v[1]];
    let coupling = 2.0 * x[0] * x[1] * (q[0] - q[1]).cos();
    let kinetic = 0.5 * m[0] * x[0].powi(2) + 0.5 * m[1] * (x[0].powi(2) + x[1].powi(2) + coupling);
    kinetic + (m[0] + m[1]) * g * l[0] * q[0].cos() + m[1] * g * l[1] * q[1].cos() - gamma * s
}

/// The same that loses energy by friction in proportion to its kinetic energy.
#[lagrangian(rayleigh = gamma * (0.5 * m[0] * (l[0] * v[0]).powi(2)
    + 0.5 * m[1] * ((l[0] * v[0]).powi(2) + (l[1] * v[1]).powi(2) + 2.0 * l[0] * l[1] * v[0] * v[1] * (q[0] - q[1]).cos())))]
pub(crate) fn rubbed(q: [f64; 2], v: [f64; 2], m: [f64; 2], l: [f64; 2], g: f64, gamma: f64) -> f64 {
    let x = [l[0] * v[0], l[1] * v[1]];
    let coupling = 2.0 * x[0] * x[1] * (q[0] - q[1]).cos();
    let kinetic = 0.5 * m[0] * x[0].powi(2) + 0.5 * m[1] * (x[0].powi(2) + x[1].powi(2) + coupling);
    kinetic + (m[0] + m[1]) * g * l[0] * q[0].cos() + m[1] * g * l[1] * q[1].cos()
}

/// θ from below, and φ, which is not read.
#[lagrangian]
pub(crate) fn spherical_pendulum(q: [f64; 2], v: [f64; 2], m: f64, l: f64, g: f64) -> f64 {
    0.5 * m * l * l * (v[0] * v[0] + (q[0].sin() * v[1]).powi(2)) + m * g * l * q[0].cos()
}

/// A bead on a hoop that turns about its vertical diameter.
#[lagrangian]
pub(crate) fn hoop(q: f64, v: f64, omega: f64, g: f64) -> f64 {
    0.5 * v * v + 0.5 * (omega * q.sin()).powi(2) + g * q.cos()
}

/// A bead on the parabola z = r², which turns.
#[lagrangian]
pub(crate) fn parabola(q: f64, v: f64, omega: f64, g: f64) -> f64 {
    0.5 * (1.0 + 4.0 * q * q) * v * v + 0.5 * omega * omega * q * q - g * q * q
}

/// A relativistic particle on a spring.
#[lagrangian]
pub(crate) fn relativistic(q: f64, v: f64, m: f64, c: f64, k: f64) -> f64 {
    -m * c * c * (1.0 - v * v / (c * c)).sqrt() - 0.5 * k * q * q
}

/// A pendulum of length 1 whose pivot moves up and down.
#[lagrangian]
pub(crate) fn moving_pivot(q: f64, v: f64, t: f64, a: f64, omega: f64, g: f64) -> f64 {
    // Velocities of the mass, and its height.
    let up = v * q.sin() - a * omega * (omega * t).sin();
    let along = v * q.cos();
    0.5 * (along * along + up * up) - g * (a * (omega * t).cos() - q.cos())
}

/// A charge in a magnetic field 1 + x, with a spring.
#[lagrangian]
pub(crate) fn charge(q: [f64; 2], v: [f64; 2], k: f64) -> f64 {
    let [x, y] = q;
    0.5 * (v[0] * v[0] + v[1] * v[1]) + (x + 0.5 * x * x) * v[1] - k * (x * x + y * y)
}

/// L of three slender rods with relative angles, the first from below.
#[energy_function]
fn rods(q: [f64; 3], v: [f64; 3], m: [f64; 3], l: [f64; 3], g: f64) -> f64 {
    let (mut angle, mut rate) = (0.0, 0.0);
    // Velocity of the joint, and its depth.
    let (mut x, mut y, mut depth) = (0.0, 0.0, 0.0);
    let mut sum = 0.0;
    for i in 0..3 {
        angle += q[i];
        rate += v[i];
        let (sin, cos) = angle.sin_cos();
        let half = 0.5 * l[i];
        let (u, w) = (x + half * rate * cos, y + half * rate * sin);
        sum += 0.5 * m[i] * (u * u + w * w) + m[i] * l[i] * l[i] / 24.0 * rate * rate + m[i] * g * (depth + half * cos);
        x += l[i] * rate * cos;
        y += l[i] * rate * sin;
        depth += l[i] * cos;
    }
    sum
}

/// The rods.
#[lagrangian(with(rods))]
pub(crate) fn arm(q: [f64; 3], v: [f64; 3], m: [f64; 3], l: [f64; 3], g: f64) -> f64 {
    rods(q, v, m, l, g)
}

/// Herglotz' principle with an action that changes the mass.
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

/// Dissipation quadratic in the action.
#[lagrangian]
pub(crate) fn quadratic_dissipation(q: f64, v: f64, s: f64, a: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q - a * s * s
}

/// A damped oscillator that is driven.
#[lagrangian]
pub(crate) fn driven(q: f64, v: f64, s: f64, t: f64, a: f64, b: f64) -> f64 {
    0.5 * v * v - 0.5 * q * q - a * s + b * t.sin() * q
}

/// The time of a fall along a path y(x), of which x is the "time" here.
#[lagrangian(q = y, v = slope, t = _x)]
pub(crate) fn brachistochrone(y: f64, slope: f64, _x: f64) -> f64 {
    ((1.0 + slope * slope) / y).sqrt()
}

/// The weight of a chain along y(x).
#[lagrangian(q = y, v = slope)]
pub(crate) fn catenary(y: f64, slope: f64) -> f64 {
    y * (1.0 + slope * slope).sqrt()
}

/// The arm with joints that rub.
#[lagrangian(with(rods), rayleigh = 0.5 * c * (1.0 + q[1] * q[1])
    * (0.3 * v[0] * v[0] + 0.1 * v[0] * v[1] + 0.2 * v[1] * v[1] + 0.1 * v[2] * v[2]))]
pub(crate) fn rubbed_arm(q: [f64; 3], v: [f64; 3], m: [f64; 3], l: [f64; 3], g: f64, c: f64) -> f64 {
    rods(q, v, m, l, g)
}

/// An arm with torques, and friction that depends on its angles.
#[lagrangian(with(rods), force = [t.sin(), 0.5 * (3.0 * t).cos(), q[0]],
    rayleigh = 0.5 * (1.0 + q[1] * q[1]) * (0.3 * v[0] * v[0] + 0.1 * v[0] * v[1] + 0.2 * v[1] * v[1] + 0.1 * v[2] * v[2]))]
pub(crate) fn driven_arm(q: [f64; 3], v: [f64; 3], t: f64, m: [f64; 3], l: [f64; 3], g: f64) -> f64 {
    rods(q, v, m, l, g)
}

/// An arm in air, with dry friction in its joints.
#[lagrangian(with(rods), rayleigh = air * v[2].abs().powi(3) / 3.0 + dry * ((v[0] * v[0] + 1e-2).sqrt() + (v[1] * v[1] + 1e-2).sqrt()))]
pub(crate) fn arm_in_air(q: [f64; 3], v: [f64; 3], m: [f64; 3], l: [f64; 3], g: f64, air: f64, dry: f64) -> f64 {
    rods(q, v, m, l, g)
}

/// Three rods of length 1 without weight, by differences of angles: the first angle is not read.
#[lagrangian]
pub(crate) fn free_arm(q: [f64; 3], v: [f64; 3], m: [f64; 3]) -> f64 {
    let rates = [v[0], v[0] + v[1], v[0] + v[1] + v[2]];
    let coupled = m[1] * rates[0] * rates[1] * q[1].cos()
        + m[2] * rates[1] * rates[2] * q[2].cos()
        + 0.5 * m[2] * rates[0] * rates[2] * (q[1] + q[2]).cos();
    0.5 * (2.0 * m[0] * rates[0] * rates[0] + 3.0 * m[1] * rates[1] * rates[1] + 2.0 * m[2] * rates[2] * rates[2])
        + 0.4 * coupled
        - (1.0 - q[2].cos())
}

/// Masses that grow with time, and a field that is linear in the velocities.
#[lagrangian]
pub(crate) fn growing_arm(q: [f64; 3], v: [f64; 3], t: f64, m: [f64; 3], rate: f64) -> f64 {
    let grown = 1.0 + 0.3 * (rate * t).sin();
    let kinetic = 0.5 * (2.0 * m[0] * v[0] * v[0] + 3.0 * m[1] * v[1] * v[1] + 2.0 * m[2] * v[2] * v[2]);
    let coupled = m[1] * v[0] * v[1] * (q[0] - q[1]).cos() + m[2] * v[1] * v[2] * (q[1] - q[2] + t).cos();
    grown * (kinetic + 0.4 * coupled) + q[1] * v[0] * t + q[0].cos() + 2.0 * q[1].cos() + q[2].cos()
}

/// Of no known conjugate.
#[lagrangian]
pub(crate) fn quartic(q: [f64; 2], v: [f64; 2], k: f64) -> f64 {
    let square = v[0] * v[0] + v[1] * v[1] + 0.5 * v[0] * v[1] * q[0].cos();
    0.5 * square + 0.25 * square * square - k * (q[0] * q[0] + (q[0] - q[1]).powi(2))
}

/// A mass matrix without a diagonal.
#[lagrangian]
pub(crate) fn mixed(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
    m * v[0] * v[1] - q[0] * q[1] - (q[0] + 2.0 * q[1]).cos()
}

/// Whose mass matrix is singular where q₀ = 0.
#[lagrangian]
pub(crate) fn singular(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
    let shifted = v[1] + 0.3 * v[0] * q[2].cos();
    0.5 * m * q[0] * v[0] * v[0] + 0.5 * shifted * shifted + 0.7 * (v[2] + 0.2 * v[1] * q[0].sin()).powi(2)
        - 0.5 * q[1] * q[1]
        - 0.5 * q[2] * q[2]
}

//! Systems that are hard, and where they start.

use geoint_runtime::prelude::*;
use geoint_tests::problems::{Kepler, ThreeBodies};
use nalgebra::Vector3;

/// A mass on a spring that swings.
#[hamiltonian]
pub fn spring_pendulum(q: [f64; 2], p: [f64; 2], m: f64, k: f64, l: f64, g: f64) -> f64 {
    let r = (q[0] * q[0] + q[1] * q[1]).sqrt();
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + k * (r - l) * (r - l) / 2.0 + m * g * q[1]
}

/// Relaxation oscillations.
#[vector_field]
pub fn van_der_pol(x: [f64; 2], epsilon: f64) -> [f64; 2] {
    [x[1], epsilon * (1.0 - x[0] * x[0]) * x[1] - x[0]]
}

/// An oscillator.
#[hamiltonian]
pub fn oscillator(q: f64, p: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) + k * q * q / 2.0
}

/// An oscillator that hardens.
#[hamiltonian]
pub fn hardening(q: f64, p: f64, m: f64, k: f64) -> f64 {
    p * p / (2.0 * m) + k * (q * q / 2.0 + q * q * q * q / 4.0)
}

/// The mass of the body that orbits.
pub const MASS: f64 = 1.3;

/// An orbit with semi-major axis 1, and its period.
pub fn comet(eccentricity: f64) -> (Kepler, State<[f64; 2]>, f64) {
    let mu = 0.7;
    let speed = ((1.0 - eccentricity) / (1.0 + eccentricity) * mu / MASS).sqrt();
    let start = State::new([-1.0 - eccentricity, 0.0], [0.0, -MASS * speed]);
    (Kepler { mass: MASS, mu }, start, std::f64::consts::TAU * (MASS / mu).sqrt())
}

/// A spring whose vibration is `ratio` times as fast as the swing, at rest at an angle of a radian and stretched by a hundredth of a percent.
pub fn spring(ratio: f64) -> (SpringPendulum, State<[f64; 2]>) {
    let (m, l, g) = (MASS, 1.0, 1.0);
    let r = l * (1.0 + 1e-4);
    (
        SpringPendulum { m, k: m * g / l * ratio * ratio, l, g },
        State::new([r * 1_f64.sin(), -r * 1_f64.cos()], [0.0, 0.0]),
    )
}

/// Three bodies of mass 3, 4 and 5 at rest in the corners of a triangle with sides 3, 4 and 5, each opposite to the side of its number.
/// C. Burrau, Astron. Nachr. 195 (1913) 113.
pub fn pythagorean() -> (ThreeBodies, State<[Vector3<f64>; 3]>) {
    let q = [Vector3::new(1.0, 3.0, 0.0), Vector3::new(-2.0, -1.0, 0.0), Vector3::new(1.0, -1.0, 0.0)];
    (ThreeBodies { m: [3.0, 4.0, 5.0], g: 1.0 }, State::new(q, [Vector3::zeros(); 3]))
}

/// Three bodies that follow each other along an eight, and their period. C. Moore, Phys. Rev. Lett. 70 (1993) 3675; digits of C. Simó.
pub fn eight() -> (ThreeBodies, State<[Vector3<f64>; 3]>, f64) {
    let m = 1.7;
    let first = Vector3::new(0.97000435669734, -0.24308753153583, 0.0);
    let last = m * Vector3::new(-0.93240737144104, -0.86473146092102, 0.0);
    let start = State::new([first, -first, Vector3::zeros()], [-0.5 * last, -0.5 * last, last]);
    (ThreeBodies { m: [m; 3], g: 1.0 / m }, start, 6.325_913_985)
}

/// The angular momentum of bodies, of which only one component is not zero.
pub fn angular_momentum(state: &State<[Vector3<f64>; 3]>) -> f64 {
    state.q.iter().zip(&state.p).map(|(q, p)| q.cross(p).z).sum()
}

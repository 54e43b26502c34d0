//! Hard systems, and their starts.

use geoint_runtime::prelude::*;
use geoint_tests::problems::Kepler;

/// A mass on a spring that swings.
#[hamiltonian]
pub(crate) fn spring_pendulum(q: [f64; 2], p: [f64; 2], m: f64, k: f64, l: f64, g: f64) -> f64 {
    let r = (q[0] * q[0] + q[1] * q[1]).sqrt();
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + k * (r - l) * (r - l) / 2.0 + m * g * q[1]
}

/// The mass of the body that orbits.
pub(crate) const MASS: f64 = 1.3;

/// Returns Kepler's problem, a start of an orbit with semi-major axis 1, and its period.
pub(crate) fn comet(eccentricity: f64) -> (Kepler, State<[f64; 2]>, f64) {
    let mu = 0.7;
    let speed = ((1.0 - eccentricity) / (1.0 + eccentricity) * mu / MASS).sqrt();
    let start = State::new([-1.0 - eccentricity, 0.0], [0.0, -MASS * speed]);
    (Kepler { mass: MASS, mu }, start, std::f64::consts::TAU * (MASS / mu).sqrt())
}

/// Returns a spring whose vibration is `ratio` times as fast as the swing. It starts at rest at an angle of a radian, stretched by a hundredth of a
/// percent.
pub(crate) fn spring(ratio: f64) -> (SpringPendulum, State<[f64; 2]>) {
    let (m, l, g) = (MASS, 1.0, 1.0);
    let r = l * (1.0 + 1e-4);
    (
        SpringPendulum { m, k: m * g / l * ratio * ratio, l, g },
        State::new([r * 1_f64.sin(), -r * 1_f64.cos()], [0.0, 0.0]),
    )
}

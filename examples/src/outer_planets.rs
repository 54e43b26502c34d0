//! Sun, Jupiter, Saturn, Uranus, Neptune and Pluto: E. Hairer, C. Lubich & G. Wanner, *Geometric Numerical Integration*, 2nd ed. (2006),
//! section I.2.4, table 2.2: heliocentric, equatorial, for September 5, 1994, at 0h00. Astronomical units, days and solar masses.

use geoint_runtime::State;
use nalgebra::Vector3;

/// The constant of gravity.
pub const GRAVITY: f64 = 2.95912208286e-4;

/// The first mass is the sum of the Sun and the inner planets.
pub const MASSES: [f64; 6] =
    [1.00000597682, 0.000954786104043, 0.000285583733151, 0.0000437273164546, 0.0000517759138449, 1.0 / 1.3e8];

const POSITIONS: [[f64; 3]; 6] = [
    [0.0, 0.0, 0.0],
    [-3.5023653, -3.8169847, -1.5507963],
    [9.0755314, -3.0458353, -1.6483708],
    [8.3101420, -16.2901086, -7.2521278],
    [11.4707666, -25.7294829, -10.8169456],
    [-15.5387357, -25.2225594, -3.1902382],
];

const VELOCITIES: [[f64; 3]; 6] = [
    [0.0, 0.0, 0.0],
    [0.00565429, -0.00412490, -0.00190589],
    [0.00168318, 0.00483525, 0.00192462],
    [0.00354178, 0.00137102, 0.00055029],
    [0.00288930, 0.00114527, 0.00039677],
    [0.00276725, -0.00170702, -0.00136504],
];

/// Positions and momenta at the start.
pub fn start() -> State<[Vector3<f64>; 6]> {
    let momentum = |i: usize| Vector3::from(VELOCITIES[i]) * MASSES[i];
    State::new(POSITIONS.map(Vector3::from), std::array::from_fn(momentum))
}

//! Pendulums and closed chains in Cartesian coordinates, and some in angles.

use geoint_runtime::Constrained;
use geoint_runtime::prelude::*;

/// Two pendulums in a plane, point masses on massless rods.
#[hamiltonian(constraint = [
    (q[0] * q[0] + q[1] * q[1] - l[0] * l[0]) / 2.0,
    ((q[2] - q[0]).powi(2) + (q[3] - q[1]).powi(2) - l[1] * l[1]) / 2.0
])]
pub(crate) fn double_pendulum(q: [f64; 4], p: [f64; 4], m: [f64; 2], l: [f64; 2], g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m[0])
        + (p[2] * p[2] + p[3] * p[3]) / (2.0 * m[1])
        + g * (m[0] * q[1] + m[1] * q[3])
}

/// The same from velocities.
#[lagrangian(constraint = [
    (q[0] * q[0] + q[1] * q[1] - l[0] * l[0]) / 2.0,
    ((q[2] - q[0]).powi(2) + (q[3] - q[1]).powi(2) - l[1] * l[1]) / 2.0
])]
pub(crate) fn of_speeds(q: [f64; 4], v: [f64; 4], m: [f64; 2], l: [f64; 2], g: f64) -> f64 {
    let kinetic = m[0] * (v[0] * v[0] + v[1] * v[1]) / 2.0 + m[1] * (v[2] * v[2] + v[3] * v[3]) / 2.0;
    kinetic - g * (m[0] * q[1] + m[1] * q[3])
}

/// The same in air: friction in proportion to velocities.
#[lagrangian(rayleigh = c / 2.0 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]), constraint = [
    (q[0] * q[0] + q[1] * q[1] - l[0] * l[0]) / 2.0,
    ((q[2] - q[0]).powi(2) + (q[3] - q[1]).powi(2) - l[1] * l[1]) / 2.0
])]
pub(crate) fn rubbed(q: [f64; 4], v: [f64; 4], m: [f64; 2], l: [f64; 2], g: f64, c: f64) -> f64 {
    let kinetic = m[0] * (v[0] * v[0] + v[1] * v[1]) / 2.0 + m[1] * (v[2] * v[2] + v[3] * v[3]) / 2.0;
    kinetic - g * (m[0] * q[1] + m[1] * q[3])
}

pub(crate) const M: [f64; 2] = [1.0, 0.6];
pub(crate) const L: [f64; 2] = [1.0, 0.8];
pub(crate) const DOUBLE: DoublePendulum = DoublePendulum { m: M, l: L, g: 9.81 };

/// At rest, the first rod down, the second at 1.4 from below.
pub(crate) fn released() -> State<[f64; 4]> {
    State::new([0.0, -1.0, 0.8 * 1.4_f64.sin(), -1.0 - 0.8 * 1.4_f64.cos()], [0.0; 4])
}

/// Positions and momenta at t = 2, from angles and their rates to twenty digits.
pub(crate) fn at_two() -> State<[f64; 4]> {
    let (a, b) = (0.4483353385900958548533_f64, -0.3951892394371101603789_f64);
    let (u, w) = (1.632829344777859751742, -0.298964447871316939838);
    let first = [a.sin(), -a.cos()];
    let second = [0.8 * b.sin(), -0.8 * b.cos()];
    let (x, y) = ([u * a.cos(), u * a.sin()], [0.8 * w * b.cos(), 0.8 * w * b.sin()]);
    State {
        t: 2.0,
        q: [first[0], first[1], first[0] + second[0], first[1] + second[1]],
        p: [x[0], x[1], 0.6 * (x[0] + y[0]), 0.6 * (x[1] + y[1])],
    }
}

/// A mass at a distance l of the origin.
#[hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - l * l) / 2.0])]
pub(crate) fn spherical_pendulum(q: [f64; 3], p: [f64; 3], m: f64, l: f64, g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * m) + m * g * q[2]
}

/// A relativistic mass on a circle in a weight that swings: T is not quadratic, and H depends on time.
#[hamiltonian(constraint = [(q[0] * q[0] + q[1] * q[1]).sqrt() - l])]
pub(crate) fn fast(q: [f64; 2], p: [f64; 2], t: f64, m: f64, c: f64, l: f64, g: f64) -> f64 {
    c * (m * m * c * c + p[0] * p[0] + p[1] * p[1]).sqrt() + m * g * (1.0 + 0.3 * (2.0 * t).sin()) * q[1]
}

/// The same by the angle from below.
#[hamiltonian]
pub(crate) fn fast_angle(q: f64, p: f64, t: f64, m: f64, c: f64, l: f64, g: f64) -> f64 {
    c * (m * m * c * c + p * p / (l * l)).sqrt() - m * g * (1.0 + 0.3 * (2.0 * t).sin()) * l * q.cos()
}

/// A four-bar linkage: joints B and C with masses between the fixed points (0, 0) and (d, 0), and a rocker whose inertia is that of a mass
/// `rocker` at C without weight.
#[hamiltonian(constraint = [
    (q[0].powi(2) + q[1].powi(2) - bars[0] * bars[0]) / 2.0,
    ((q[2] - q[0]).powi(2) + (q[3] - q[1]).powi(2) - bars[1] * bars[1]) / 2.0,
    ((q[2] - d).powi(2) + q[3].powi(2) - bars[2] * bars[2]) / 2.0
])]
pub(crate) fn four_bar(q: [f64; 4], p: [f64; 4], m: [f64; 2], rocker: f64, bars: [f64; 3], d: f64, g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m[0])
        + (p[2] * p[2] + p[3] * p[3]) / (2.0 * (m[1] + rocker))
        + g * (m[0] * q[1] + m[1] * q[3])
}

/// The same linkage by the angles of its bars, with two equations that close it. Its mass matrix depends on angles.
#[lagrangian(constraint = [
    bars[0] * q[0].cos() + bars[1] * q[1].cos() - bars[2] * q[2].cos() - d,
    bars[0] * q[0].sin() + bars[1] * q[1].sin() - bars[2] * q[2].sin()
])]
pub(crate) fn four_bar_of_angles(
    q: [f64; 3],
    v: [f64; 3],
    m: [f64; 2],
    rocker: f64,
    bars: [f64; 3],
    d: f64,
    g: f64,
) -> f64 {
    let [a, b, c] = bars;
    let first = [-a * v[0] * q[0].sin(), a * v[0] * q[0].cos()];
    let second = [first[0] - b * v[1] * q[1].sin(), first[1] + b * v[1] * q[1].cos()];
    let square = |x: [f64; 2]| x[0] * x[0] + x[1] * x[1];
    let kinetic = m[0] * square(first) / 2.0 + m[1] * square(second) / 2.0 + rocker * (c * v[2]).powi(2) / 2.0;
    kinetic - g * (m[0] * a * q[0].sin() + m[1] * (a * q[0].sin() + b * q[1].sin()))
}

pub(crate) const BARS: [f64; 3] = [1.0, 2.0, 1.8];
pub(crate) const FOUR_BAR: FourBar = FourBar { m: [0.7, 1.1], rocker: 0.4, bars: BARS, d: 2.2, g: 9.81 };
pub(crate) const FOUR_BAR_OF_ANGLES: FourBarOfAngles =
    FourBarOfAngles { m: [0.7, 1.1], rocker: 0.4, bars: BARS, d: 2.2, g: 9.81 };

/// The crank at an angle, turning; the rest above it.
pub(crate) fn cranked(angle: f64, rate: f64) -> (State<[f64; 3]>, State<[f64; 4]>) {
    let [a, b, c] = BARS;
    let first = [a * angle.cos(), a * angle.sin()];
    let (x, y) = (2.2 - first[0], -first[1]);
    let distance = x.hypot(y);
    let between = ((b * b + distance * distance - c * c) / (2.0 * b * distance)).acos();
    let coupler = y.atan2(x) + between;
    let second = [first[0] + b * coupler.cos(), first[1] + b * coupler.sin()];
    let rocker = second[1].atan2(second[0] - 2.2);
    // Rates from the closure.
    let turned = rate * a * (angle - rocker).sin() / (b * (rocker - coupler).sin());
    let rocked = rate * a * (angle - coupler).sin() / (c * (rocker - coupler).sin());
    let angles = FOUR_BAR_OF_ANGLES.at([angle, coupler, rocker], [rate, turned, rocked]);
    let v = [-a * rate * angle.sin(), a * rate * angle.cos()];
    let w = [-c * rocked * rocker.sin(), c * rocked * rocker.cos()];
    let p = [0.7 * v[0], 0.7 * v[1], 1.5 * w[0], 1.5 * w[1]];
    (angles, State::new([first[0], first[1], second[0], second[1]], p))
}

/// The largest difference of positions and momenta.
pub(crate) fn far<const N: usize>(a: &State<[f64; N]>, b: &State<[f64; N]>) -> f64 {
    (0..N).fold(0.0, |far, i| f64::max(far, f64::max((a.q[i] - b.q[i]).abs(), (a.p[i] - b.p[i]).abs())))
}

/// The run after so much time, in steps of `h`.
pub(crate) fn run<S, M, const N: usize>(
    system: S,
    method: M,
    h: f64,
    start: State<[f64; N]>,
    time: f64,
) -> Integrator<S, M>
where
    S: Constrained<Coordinates = [f64; N], Array = [f64; N], State = State<[f64; N]>>,
    M: Method<S>,
{
    let mut sim = Integrator::new(system, method, h, start);
    sim.advance((time / h).round() as u64).expect("steps");
    sim
}

/// Orders that neighbouring errors of halved steps show.
pub(crate) fn orders(errors: &[f64]) -> Vec<f64> {
    errors.windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect()
}

//! Constraints that read time: a pendulum whose pivot moves, and a driven linkage. References are angles of an extrapolation method with 22 digits, and geometry.

use crate::systems::{orders, run};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A pendulum with its pivot at the height 0.1 cos 20t.
#[hamiltonian(constraint = [(q[0] * q[0] + (q[1] - 0.1 * (20.0 * t).cos()).powi(2) - l * l) / 2.0])]
fn shaken(q: [f64; 2], p: [f64; 2], t: f64, m: f64, l: f64, g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + m * g * q[1]
}

/// A crank that a motor turns, coupler and rocker to the joint C with a mass, and a pendulum that hangs from C: C and P are the coordinates.
#[hamiltonian(constraint = [
    ((q[0] - 0.4 * (0.3 + 2.0 * t).cos()).powi(2) + (q[1] - 0.4 * (0.3 + 2.0 * t).sin()).powi(2) - 1.5 * 1.5) / 2.0,
    ((q[0] - 1.2).powi(2) + q[1].powi(2) - 1.0) / 2.0,
    ((q[2] - q[0]).powi(2) + (q[3] - q[1]).powi(2) - 0.7 * 0.7) / 2.0
])]
fn crank(q: [f64; 4], p: [f64; 4], t: f64, m: [f64; 2], g: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m[0])
        + (p[2] * p[2] + p[3] * p[3]) / (2.0 * m[1])
        + g * (m[0] * q[1] + m[1] * q[3])
}

const SHAKEN: Shaken = Shaken { m: 1.0, l: 1.0, g: 9.81 };
const CRANK: Crank = Crank { m: [0.8, 0.5], g: 9.81 };

/// The shaken pendulum by its angle from below and the rate of the angle.
fn shaken_at(t: f64, angle: f64, rate: f64) -> State<[f64; 2]> {
    let (sin, cos) = angle.sin_cos();
    let pivot = [0.1 * (20.0 * t).cos(), -2.0 * (20.0 * t).sin()];
    State { t, q: [sin, pivot[0] - cos], p: [rate * cos, pivot[1] + rate * sin] }
}

/// The joint C, the intersection of two circles above.
fn joint(t: f64) -> [f64; 2] {
    let angle = 0.3 + 2.0 * t;
    let b = [0.4 * angle.cos(), 0.4 * angle.sin()];
    let e = [1.2 - b[0], -b[1]];
    let square = e[0] * e[0] + e[1] * e[1];
    let along = ((1.5 * 1.5 - 1.0) / square + 1.0) / 2.0;
    let across = (1.5 * 1.5 / square - along * along).sqrt();
    [b[0] + along * e[0] - across * e[1], b[1] + along * e[1] + across * e[0]]
}

/// A derivative of order 8 by central differences.
fn derivative(f: impl Fn(f64) -> [f64; 2], t: f64) -> [f64; 2] {
    let h = 1e-2;
    let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let mut sum = [0.0; 2];
    for (k, weight) in (1..).zip(weights) {
        let (after, before) = (f(t + f64::from(k) * h), f(t - f64::from(k) * h));
        for i in 0..2 {
            sum[i] += weight * (after[i] - before[i]) / h;
        }
    }
    sum
}

/// The crank with the angle of its pendulum from below, on the constraints to rounding.
fn cranked_at(t: f64, angle: f64, rate: f64) -> State<[f64; 4]> {
    let (c, v) = (joint(t), derivative(joint, t));
    let (sin, cos) = angle.sin_cos();
    let w = [v[0] + 0.7 * rate * cos, v[1] + 0.7 * rate * sin];
    let near = State {
        t,
        q: [c[0], c[1], c[0] + 0.7 * sin, c[1] - 0.7 * cos],
        p: [0.8 * v[0], 0.8 * v[1], 0.5 * w[0], 0.5 * w[1]],
    };
    CRANK.state_on_constraint(&near).expect("a state")
}

fn apart<const N: usize>(a: &State<[f64; N]>, b: &State<[f64; N]>) -> [f64; 2] {
    [(a.q, b.q), (a.p, b.p)].map(|(a, b)| a.iter().zip(b).fold(0.0, |far, (a, b)| f64::max(far, (a - b).abs())))
}

/// Errors of three runs of order 2, the first as given.
macro_rules! second {
    ($system:expr, $method:expr, $steps:expr, $start:expr, $end:expr, $errors:expr) => {{
        let end = $end;
        let errors = $steps.map(|h| apart(&run($system, $method, h, $start, end.t).state(), &end));
        for k in [0, 1] {
            let all = errors.map(|error| error[k]);
            assert!(orders(&all).iter().all(|order| (order - 2.0).abs() < 0.1), "{errors:?}");
            assert!((all[0] / $errors[k] - 1.0).abs() < 0.02, "{errors:?}");
        }
    }};
}

#[test]
fn a_pivot_that_moves() -> Result<(), StepError> {
    let (start, end) = (shaken_at(0.0, 3.0, 0.1), shaken_at(1.0, 2.369_899_917_770_885_8, -0.791_313_689_917_934_7));
    second!(SHAKEN, Rattle, [0.01, 0.005, 0.0025], start, end, [6.71e-4, 1.91e-3]);
    second!(SHAKEN, DiscreteGradient, [0.01, 0.005, 0.0025], start, end, [7.80e-4, 2.11e-3]);
    let errors = [0.01, 0.005].map(|h| {
        let error = apart(&run(SHAKEN, Suzuki4.of(DiscreteGradient), h, start, 1.0).state(), &end);
        error[0].max(error[1])
    });
    assert!(orders(&errors)[0] > 3.8 && errors[1] < 1e-5, "{errors:?}");
    // At every step the rod has its length, and its rate is that of the pivot.
    for rattle in [true, false] {
        let mut sims = (SHAKEN.integrator(Rattle, 0.01, start), SHAKEN.integrator(DiscreteGradient, 0.01, start));
        for _ in 0..1000 {
            let State { t, q, p } = if rattle {
                sims.0.step()?;
                sims.0.state()
            } else {
                sims.1.step()?;
                sims.1.state()
            };
            let (y, rate) = (q[1] - 0.1 * (20.0 * t).cos(), p[1] + 2.0 * (20.0 * t).sin());
            assert!((q[0].hypot(y) - 1.0).abs() < 1e-15 && (q[0] * p[0] + y * rate).abs() < 1e-14);
        }
    }
    Ok(())
}

#[test]
fn a_driven_linkage() -> Result<(), StepError> {
    let start = cranked_at(0.0, 0.5, 0.0);
    let end = cranked_at(2.0, 0.111_684_300_540_673_11, -0.454_288_395_181_898_6);
    let c = [0.697_079_616_917_605, 0.864_332_741_645_402];
    assert!((end.q[0] - c[0]).abs() < 1e-13 && (end.q[1] - c[1]).abs() < 1e-13);
    second!(CRANK, Rattle, [0.02, 0.01, 0.005], start, end, [2.33e-4, 3.89e-4]);
    second!(CRANK, DiscreteGradient, [0.02, 0.01, 0.005], start, end, [4.25e-4, 1.025e-3]);
    let mut sim = CRANK.integrator(DiscreteGradient, 0.02, start);
    for _ in 0..500 {
        sim.step()?;
        let State { t, q, .. } = sim.state();
        let exact = joint(t);
        assert!((q[0] - exact[0]).abs() < 5e-15 && (q[1] - exact[1]).abs() < 5e-15);
    }
    Ok(())
}

/// The forces of coupler, rocker and pendulum give the joint the acceleration that its way has.
#[test]
fn forces_in_bearings() -> Result<(), StepError> {
    let start = cranked_at(0.0, 0.5, 0.0);
    let mut sim = CRANK.integrator(DiscreteGradient, 0.01, start);
    sim.advance(150)?;
    let (State { t, q, .. }, [coupler, rocker, rod]) = (sim.state(), sim.multipliers());
    let crank = [0.4 * (0.3 + 2.0 * t).cos(), 0.4 * (0.3 + 2.0 * t).sin()];
    let fixed = [1.2, 0.0];
    let acceleration = derivative(|t| derivative(joint, t), t);
    for i in 0..2 {
        let pull = -coupler * (q[i] - crank[i]) - rocker * (q[i] - fixed[i]) + rod * (q[i + 2] - q[i]);
        let weight = [0.0, -0.8 * 9.81][i];
        assert!((0.8 * acceleration[i] - pull - weight).abs() < 1e-8, "{} {}", 0.8 * acceleration[i], pull + weight);
    }
    // Without a drive the energy is constant, and with one it is not.
    assert!((sim.energy() - CRANK.energy(&start)).abs() > 0.1);
    Ok(())
}

/// A mechanism whose constraints leave no freedom is kinematics, and its multipliers are the motor's force.
#[hamiltonian(constraint = [q[0] - a * (w * t).sin()])]
fn piston_rod(q: [f64; 1], p: [f64; 1], t: f64, m: f64, a: f64, w: f64) -> f64 {
    p[0] * p[0] / (2.0 * m)
}

#[test]
fn a_motion_that_is_given() -> Result<(), StepError> {
    let system = PistonRod { m: 1.7, a: 0.3, w: 2.0 };
    let start = State::new([0.0], [1.7 * 0.6]);
    let mut sim = system.integrator(DiscreteGradient, 0.05, start);
    for _ in 0..100 {
        sim.step()?;
        let (State { t, q, p }, [force]) = (sim.state(), sim.multipliers());
        let exact = [0.3 * (2.0 * t).sin(), 1.7 * 0.6 * (2.0 * t).cos(), 1.7 * 1.2 * (2.0 * t).sin()];
        assert!((q[0] - exact[0]).abs() < 1e-15 && (p[0] - exact[1]).abs() < 1e-14 && (force - exact[2]).abs() < 1e-14);
    }
    Ok(())
}

#[test]
fn a_start_off_a_moving_constraint() {
    let State { q, p, .. } = shaken_at(0.0, 3.0, 0.1);
    let mut sim = SHAKEN.integrator(DiscreteGradient, 0.01, State { t: 0.05, q, p });
    assert!(sim.step().is_err());
    let moved = SHAKEN.state_on_constraint(&State { t: 0.05, q, p }).expect("a state");
    assert!(SHAKEN.integrator(DiscreteGradient, 0.01, moved).step().is_ok());
}

//! An implicit equation with a step far too large has several solutions. Only the solution that is continuous in the step size is a step.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::measure::Noise;

/// Hénon and Heiles (1964). At energies below 1/6 no motion that begins in the unit circle leaves it. The starts here have energies below 1/8.
#[hamiltonian]
fn galaxy(q: [f64; 2], p: [f64; 2]) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + q[0] * q[0] + q[1] * q[1]) / 2.0 + q[0] * q[0] * q[1] - q[1].powi(3) / 3.0
}

/// The same potential, where the second mass depends on the first coordinate.
#[lagrangian]
fn heavy_galaxy(q: [f64; 2], v: [f64; 2], m: f64) -> f64 {
    m * (v[0] * v[0] + v[1] * v[1] * (1.0 + q[0] * q[0])) / 2.0 - (q[0] * q[0] + q[1] * q[1]) / 2.0 - q[0] * q[0] * q[1]
        + q[1].powi(3) / 3.0
}

/// A contact energy of the same potential, with friction.
#[contact_hamiltonian]
fn slow_galaxy(q: [f64; 2], p: [f64; 2], s: f64, c: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + q[0] * q[0] + q[1] * q[1]) / 2.0 + q[0] * q[0] * q[1] - q[1].powi(3) / 3.0 + c * s
}

/// Number of successful steps and number of refused steps.
#[derive(Debug, Default)]
struct Count {
    steps: usize,
    refused: usize,
}

/// Runs from random starts of small energy, with steps up to three periods. Each accepted step must end where motions of this energy are: within 1.2. The
/// bound leaves room for the errors of large steps. Other solutions of the equation are at 3 and farther. Some steps must be refused, because the test then
/// meets other solutions.
macro_rules! runs {
    ($count:ident, $system:expr, $start:expr; $($method:expr),*) => { $(
        let mut noise = Noise::new(42);
        for h in [2.0, 3.0, 5.0, -5.0, 8.0, 20.0] {
            for _ in 0..8 {
                let [a, b, c, d] = [(); 4].map(|_| 0.2 * noise.next().unwrap());
                let mut sim = $system.integrator($method, h, $start([a, b], [c, d]));
                while sim.steps() < 60 {
                    let before = sim.state();
                    if sim.step().is_err() {
                        $count.refused += 1;
                        break;
                    }
                    $count.steps += 1;
                    let [x, y] = sim.state().q;
                    assert!(x.hypot(y) < 1.2, "{}, h = {h}, from {before:?}: {x:.1e}, {y:.1e}", stringify!($method));
                }
            }
        }
    )* };
}

#[test]
fn steps_far_too_large_stay_on_their_branch() {
    let mut count = Count::default();
    runs!(count, Galaxy, State::new; Gauss::<1>, Gauss::<2>, Gauss::<4>, Gauss::<6>, Suzuki4.of(ImplicitMidpoint));
    assert!(count.steps > 5000 && count.refused > 20, "{count:?}");
}

#[test]
fn steps_of_lagrangians_stay_on_their_branch() {
    let mut count = Count::default();
    let system = HeavyGalaxy { m: 1.7 };
    runs!(count, system, |q, v| system.at(q, v); Gauss::<2>, Gauss::<4>);
    assert!(count.steps > 1000 && count.refused > 2, "{count:?}");
}

#[test]
fn steps_of_contact_energies_stay_on_their_branch() {
    let mut count = Count::default();
    runs!(count, SlowGalaxy { c: 0.01 }, |q, p| ContactState::new(q, p, 0.0); ContactGauss::<2>, ContactGauss::<4>);
    assert!(count.steps > 1000 && count.refused > 2, "{count:?}");
}

/// A regular orbit. Newton's iteration also finds a solution at 3·10¹¹, which must not be accepted.
#[test]
fn a_regular_orbit_has_a_step_of_almost_a_period() {
    let mut sim = Galaxy.integrator(Gauss::<6>, 5.0, State::new([0.12, 0.12], [0.12, 0.12]));
    for _ in 0..200 {
        sim.step().unwrap();
        assert!(sim.state().q.iter().all(|q| q.abs() < 0.5), "{:?}", sim.state());
    }
}

/// A step that grows by hundredths of 5 from the same start stays on one branch of solutions of the implicit equation.
#[test]
fn a_long_step_is_continuous_in_its_size() {
    let start = State::new([0.12, 0.12], [0.12, 0.12]);
    let mut before = start.q;
    for k in 1..=100 {
        let h = 5.0 * f64::from(k) / 100.0;
        let mut sim = Galaxy.integrator(Gauss::<6>, h, start);
        sim.step().unwrap();
        let q = sim.state().q;
        let leap = (q[0] - before[0]).hypot(q[1] - before[1]);
        assert!(leap < 0.05, "h = {h}: {leap:.1e}");
        before = q;
    }
}

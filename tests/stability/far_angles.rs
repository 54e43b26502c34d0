//! Projections of angles far from zero, with steps of a third of a period and more: the measure of rounding must not take the curvature of a cosine for noise, and
//! accept a step that is not projected.

use geoint_runtime::prelude::*;
use geoint_tests::measure::Noise;

/// A pendulum whose angle is counted from far away.
#[hamiltonian]
fn far_pendulum(q: f64, p: f64, m: f64, c: f64) -> f64 {
    p * p / (2.0 * m) - (q - c).cos()
}

/// A pendulum in single precision, where steps far too large show the same at angles of a few turns.
#[hamiltonian]
fn single_pendulum(q: f32, p: f32, m: f32, g: f32) -> f32 {
    p * p / (2.0 * m) - g * q.cos()
}

/// Returns how many of 1500 steps succeed, and the largest change of the energies in units of ε (1 + |q|), by which a rounded angle changes them.
macro_rules! runs {
    ($system:expr, $real:ty, $center:expr, $method:expr) => {{
        let (mut noise, mut steps, mut worst) = (Noise::new(7), 0, 0.0_f64);
        for _ in 0..500 {
            let [q, p] = [2.0, 1.0].map(|size| (size * noise.next().unwrap()) as $real);
            let mut sim = $system.integrator($method, 2.667 as $real, State::new($center as $real + q, p));
            let energy = sim.energy();
            for _ in 0..3 {
                if sim.step().is_err() {
                    break;
                }
                let rounding = <$real>::EPSILON * (1.0 + sim.state().q.abs());
                worst = worst.max(f64::from((sim.energy() - energy).abs() / rounding));
                steps += 1;
            }
        }
        (steps, worst)
    }};
}

#[test]
fn energies_of_angles_far_away_are_kept() {
    let (steps, worst) = runs!(FarPendulum { m: 1.3, c: 1e5 }, f64, 1e5, Projection(RK4, Energy));
    assert!(steps > 1000 && worst <= 32.0, "{steps} steps: {worst:.1e}");
    // Control: without the projection.
    let (_, worst) = runs!(FarPendulum { m: 1.3, c: 1e5 }, f64, 1e5, RK4);
    assert!(worst > 1e9, "{worst:.1e}");
}

#[test]
fn energies_of_angles_are_kept_in_single_precision() {
    let (steps, worst) = runs!(SinglePendulum { m: 1.3, g: 2.5 }, f32, 0.0, Projection(RK4, Energy));
    // A projection may leave changes of ε^⅔, which are some 200 roundings, in each of three steps.
    assert!(steps > 1000 && worst <= 1000.0, "{steps} steps: {worst:.1e}");
    let (_, worst) = runs!(SinglePendulum { m: 1.3, g: 2.5 }, f32, 0.0, RK4);
    assert!(worst > 1e5, "{worst:.1e}");
}

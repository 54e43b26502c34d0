//! Projections at angles far from zero, with steps of a third of a period. The measure of rounding must not mistake the curvature of a cosine for noise. A
//! step without projection would then be accepted.

use geoint_runtime::Method;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::measure::Noise;

/// A pendulum whose angle is counted from far away.
#[hamiltonian]
fn far_pendulum(q: f64, p: f64, m: f64, c: f64) -> f64 {
    p * p / (2.0 * m) - (q - c).cos()
}

/// Number of successful steps, and the largest change of the energy in units of ε (1 + |q|). A rounding of the angle changes the energy by one unit.
struct Outcome {
    steps: usize,
    worst: f64,
}

/// Takes at most three steps from each of 500 random starts.
fn run<M: Method<FarPendulum>>(method: M) -> Outcome {
    let (mut noise, mut outcome) = (Noise::new(7), Outcome { steps: 0, worst: 0.0 });
    let c = 1e5;
    for _ in 0..500 {
        let [q, p] = [2.0, 1.0].map(|size| size * noise.next().unwrap());
        let mut sim = FarPendulum { m: 1.3, c }.integrator(method, 2.667, State::new(c + q, p));
        let energy = sim.energy();
        for _ in 0..3 {
            if sim.step().is_err() {
                break;
            }
            let rounding = f64::EPSILON * (1.0 + sim.state().q.abs());
            outcome.worst = outcome.worst.max((sim.energy() - energy).abs() / rounding);
            outcome.steps += 1;
        }
    }
    outcome
}

#[test]
fn energies_of_angles_far_away_are_kept() {
    let Outcome { steps, worst } = run(Projection(RK4, Energy));
    assert!(steps > 1000 && worst <= 32.0, "{steps} steps: {worst:.1e}");
    // Control: without the projection.
    assert!(run(RK4).worst > 1e9);
}

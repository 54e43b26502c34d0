//! The value of initial guesses, by the number of evaluations of implicit steps. The unit is a sine or cosine: an evaluation has six, and the end of
//! a step one.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::scalars::{Tallied, Tally};

/// Two pendulums, the second hanging from the first.
#[hamiltonian]
fn double_pendulum(q: [f64; 2], p: [f64; 2], m: [f64; 2]) -> f64 {
    let (sin, cos) = (q[0] - q[1]).sin_cos();
    let kinetic = (m[1] * p[0] * p[0] + (m[0] + m[1]) * p[1] * p[1] - m[1] * p[0] * p[1] * cos * 2.0)
        / (m[1] * (m[0] + m[1] * sin * sin) * 2.0);
    kinetic - (m[0] + m[1]) * q[0].cos() * 9.81 - m[1] * q[1].cos() * 9.81
}

/// Evaluations a substep over some hundred of them.
fn evaluations<M: Method<DoublePendulum<Tallied>, Tallied>>(method: M, substeps: u64, h: f64) -> f64 {
    let system = DoublePendulum::<Tallied> { m: [1.3.into(), 0.7.into()] };
    let start = State::new([0.5.into(), 0.9.into()], [0.0.into(), 0.0.into()]);
    let mut sim = Integrator::new(system, method, h.into(), start);
    let steps = 300 / substeps;
    sim.advance(14).expect("steps");
    let Tally { functions, .. } = Tally::during(|| sim.advance(steps).expect("steps"));
    (functions as f64 / (steps * substeps) as f64 - 1.0) / 6.0
}

/// If steps are too long for extrapolation, an explicit guess takes two evaluations, and the equation two more at most.
#[test]
fn long_substeps_evaluate_four_times_at_most() {
    for (h, most) in [(0.05, [3.0, 3.0]), (0.1, [3.2, 3.2])] {
        let found =
            [evaluations(Suzuki4.of(ImplicitMidpoint), 5, h), evaluations(KahanLi8_17a.of(ImplicitMidpoint), 17, h)];
        println!("h = {h}: {found:.2?}");
        assert!(found.iter().zip(&most).all(|(found, most)| found <= most), "h = {h}: {found:?}");
    }
}

/// If all increments are extrapolated, one evaluation is enough, in compositions as well.
#[test]
fn short_steps_evaluate_once() {
    let found = [
        evaluations(ImplicitMidpoint, 1, 0.01),
        evaluations(Suzuki4.of(ImplicitMidpoint), 5, 0.01),
        evaluations(KahanLi8_17a.of(ImplicitMidpoint), 17, 0.01),
    ];
    assert!(found.iter().all(|found| *found <= 1.15), "{found:?}");
}

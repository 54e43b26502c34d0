//! A condition that reads parameters only is decided before the first step; roots that cancel are still roots.

use geoint_runtime::prelude::*;

#[hamiltonian]
fn well(q: f64, p: f64, a: f64, b: f64) -> f64 {
    let soft = a < 1.0 && b != 2.0;
    0.5 * p * p + if soft || q > b { a * q * q } else { b * q.powi(4) }
}

#[hamiltonian]
fn half_line(q: f64, p: f64) -> f64 {
    p * p / 2.0 + q.sqrt() * q.sqrt() * 3.0
}

#[test]
fn compiles_and_means_what_it_says() {
    for (a, b) in [(0.5, 1.0), (0.5, 2.0), (2.0, 0.1), (2.0, 3.0)] {
        let system = Well { a, b };
        assert_eq!(system.energy(&State::new(0.5, 1.0)), well(0.5, 1.0, a, b));
        system.integrator(StormerVerlet, 0.01, State::new(0.5, 1.0)).advance(10).unwrap();
        system.integrator(ImplicitMidpoint, 0.01, State::new(0.5, 1.0)).advance(10).unwrap();
    }
    let outside = HalfLine.integrator(StormerVerlet, 0.01, State::new(-0.5, 1.0)).step();
    assert!(matches!(outside, Err(StepError { failure: Failure::OutsideDomain { .. }, .. })), "{outside:?}");
}

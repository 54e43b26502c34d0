//! A system without parameters is a unit struct.
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

#[hamiltonian]
fn kepler(q: [f64; 2], p: [f64; 2]) -> f64 {
    0.5 * (p[0] * p[0] + p[1] * p[1]) - 1.0 / q[0].hypot(q[1])
}

#[test]
fn compiles_and_means_what_it_says() {
    let mut sim = Kepler.integrator(Yoshida4.of(StormerVerlet), 0.01, State::new([1.0, 0.0], [0.0, 1.0]));
    sim.advance(100).unwrap();
    assert!((sim.energy() + 0.5).abs() < 1e-8);
}

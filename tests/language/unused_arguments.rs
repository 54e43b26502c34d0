//! What is not read may be named as Rust names it; it is a coordinate, or time, all the same.

#![deny(warnings)]

use geoint_runtime::prelude::*;

#[hamiltonian]
fn free(_q: f64, p: f64, _t: f64, m: f64) -> f64 {
    p * p / (2.0 * m)
}

#[hamiltonian]
fn fixed(q: f64, _p: f64, k: f64) -> f64 {
    k * q.powi(4)
}

#[test]
fn compiles_and_means_what_it_says() {
    let mut sim = Free { m: 2.0 }.integrator(StormerVerlet, 0.5, State::new(1.0, 3.0));
    sim.advance(2).unwrap();
    assert_eq!(sim.state().q, 2.5);
    let mut sim = Fixed { k: 0.25 }.integrator(ImplicitMidpoint, 0.5, State::new(2.0, 0.0));
    sim.advance(2).unwrap();
    assert_eq!((sim.state().q, sim.state().p), (2.0, -8.0));
    let _ = (free(1.0, 3.0, 0.0, 2.0), fixed(2.0, 0.0, 0.25));
}

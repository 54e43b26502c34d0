//! The runtime may have another name, or be re-exported.
mod physics {
    pub(crate) mod engine {
        pub(crate) use geoint_runtime::*;
    }
}

use physics::engine::{ImplicitMidpoint, State};

#[physics::engine::hamiltonian(crate = crate::crate_path::physics::engine)]
fn oscillator(q: f64, p: f64, k: f64) -> f64 {
    0.5 * p * p + 0.5 * k * q * q
}

#[physics::engine::energy_function(crate = crate::crate_path::physics::engine)]
fn quartic(x: f64) -> f64 {
    x * x * x * x
}

#[physics::engine::energy_function(with(quartic), crate = crate::crate_path::physics::engine)]
fn octic(x: f64) -> f64 {
    quartic(x) * quartic(x)
}

#[physics::engine::hamiltonian(crate = crate::crate_path::physics::engine, with(octic))]
fn hard(q: f64, p: f64) -> f64 {
    0.3 * p * p + octic(q)
}

#[test]
fn compiles_and_means_what_it_says() {
    let mut sim = Hard.integrator(ImplicitMidpoint, 0.01, State::new(1.0, 0.0));
    sim.advance(10).unwrap();
    assert!((sim.energy() - hard(1.0, 0.0)).abs() < 1e-3);
    let mut sim = Oscillator { k: 2.0 }.integrator(ImplicitMidpoint, 0.01, State::new(1.0, 0.0));
    sim.advance(10).unwrap();
    assert!((sim.energy() - oscillator(1.0, 0.0, 2.0)).abs() < 1e-13);
}

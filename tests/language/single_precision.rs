//! Energies in `f32`.
use geoint_runtime::prelude::*;
use std::f32::consts::FRAC_PI_2;

const G: f64 = 9.81;

#[hamiltonian]
fn pendulum(q: f32, p: f32, l: [f32; 2]) -> f32 {
    p * p / (2.0 * l[0].powi(2)) - G as f32 * l[1] * (q + FRAC_PI_2).sin() + 0.1_f32
}

#[test]
fn compiles_and_means_what_it_says() {
    let system = Pendulum { l: [1.0, 1.0] };
    let mut sim = system.integrator(BlanesMoan4, 0.01, State::new(0.5, 0.0));
    assert!((sim.energy() - pendulum(0.5, 0.0, [1.0, 1.0])).abs() < 1e-5);
    sim.advance(100).unwrap();
}

//! Any argument may be q, p or t, and the struct may have any name.
use geoint_runtime::prelude::*;

#[hamiltonian(name = Swing, q = angle, p = momentum, t = time)]
fn pendulum_on_a_lift(angle: f64, momentum: f64, time: f64, length: f64) -> f64 {
    momentum * momentum / (2.0 * length * length) - (9.81 + time.sin()) * length * angle.cos()
}

#[test]
fn compiles_and_means_what_it_says() {
    let sim = Swing { length: 2.0 }.integrator(StormerVerlet, 0.01, State::at(0.5, 1.0, 0.3));
    assert!((sim.energy() - pendulum_on_a_lift(1.0, 0.3, 0.5, 2.0)).abs() < 1e-13);
}

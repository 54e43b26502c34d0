//! Names in the user's crate that generated code uses as well.
use geoint_runtime::prelude::{DiscreteGradient, StormerVerlet, hamiltonian};

#[derive(Clone, Copy)]
struct Real;
struct Option;
struct Array;
mod slope {}
mod core {}
#[allow(non_camel_case_types)]
struct f64x;

#[hamiltonian]
fn oscillator(q: f64, p: f64, h: f64, v0: f64, prepared: f64, start: f64, increment: f64, dq: f64, new0: f64) -> f64 {
    0.5 * p * p * h + 0.5 * v0 * q * q * prepared + start * q.powi(4) + increment * q + dq * q.exp() + new0 * q
}

#[test]
fn compiles_and_means_what_it_says() {
    let _ = (Real, Option, Array, f64x);
    let system = Oscillator { h: 1.0, v0: 2.0, prepared: 1.0, start: 0.1, increment: 0.2, dq: 0.3, new0: 0.4 };
    let state = geoint_runtime::State::new(0.5, 0.25);
    let energy = oscillator(0.5, 0.25, 1.0, 2.0, 1.0, 0.1, 0.2, 0.3, 0.4);
    assert!((system.energy(&state) - energy).abs() < 1e-14);
    system.integrator(DiscreteGradient, 0.01, state).advance(10).unwrap();
    system.integrator(StormerVerlet, 0.01, state).advance(10).unwrap();
}
